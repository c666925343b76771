// SPDX-License-Identifier: MIT
// Rays against the shown mesh by a tree of boxes (three-mesh-bvh), which is fetched by the first ray; until it is there, every triangle is tried.
/** @type {typeof import("./box_tree.js") | null} */
let library = null;
/** @type {Promise<any> | null} */
let asked = null;

function fetchTree() {
  asked ??= import("./box_tree.js").then(
    (loaded) => (library = loaded),
    () => (asked = null), // slower, and the next mesh asks again
  );
}

// The vertices were moved: boxes are fitted anew by the next ray.
/** @param {import("three").BufferGeometry} geometry */
export function moved(geometry) {
  geometry.userData.fits = false;
}

// As raycaster.intersectObject(mesh), the nearest alone.
/** @param {import("three").Raycaster} raycaster @param {any} mesh @returns {any} */
export function firstHit(raycaster, mesh) {
  const { geometry } = mesh;
  if (!library) {
    fetchTree();
    return raycaster.intersectObject(mesh)[0];
  }
  if (!geometry.boundsTree) geometry.boundsTree = new library.MeshBVH(geometry, { indirect: true });
  else if (!geometry.userData.fits) geometry.boundsTree.refit();
  geometry.userData.fits = true;
  mesh.raycast = library.acceleratedRaycast;
  raycaster.firstHitOnly = true;
  return raycaster.intersectObject(mesh)[0];
}
