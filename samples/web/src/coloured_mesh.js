// SPDX-License-Identifier: MIT
// The mesh with a colour per vertex, which shows weights and doubt.
import { BufferAttribute, BufferGeometry, DoubleSide, Mesh, MeshStandardMaterial } from "three";
import { moved } from "./rays.js";

const toLinear = Float32Array.from({ length: 256 }, (_, i) => {
  const x = i / 255;
  return x <= 0.04045 ? x / 12.92 : ((x + 0.055) / 1.055) ** 2.4;
});

/** @typedef {Mesh<BufferGeometry, MeshStandardMaterial>} ColouredMesh */

/**
 * Grey, with the bounds of its rest pose.
 * @param {{ triangles: Uint32Array, positions: Float32Array, normals: Float32Array, wireframe: boolean }} of
 * @returns {ColouredMesh}
 */
export function colouredMesh({ triangles, positions, normals, wireframe }) {
  const geometry = new BufferGeometry();
  geometry.setIndex(new BufferAttribute(triangles, 1));
  geometry.setAttribute("position", new BufferAttribute(positions, 3));
  geometry.setAttribute("normal", new BufferAttribute(normals, 3));
  geometry.setAttribute("color", new BufferAttribute(new Float32Array(positions.length).fill(0.35), 3));
  geometry.computeBoundingBox();
  const mesh = new Mesh(geometry, new MeshStandardMaterial({ vertexColors: true, wireframe, roughness: 0.82, metalness: 0, side: DoubleSide }));
  mesh.frustumCulled = false; // poses leave the rest pose's bounds
  return mesh;
}

/** @param {ColouredMesh} mesh @param {Uint8Array} srgb three numbers a vertex */
export function paintMesh(mesh, srgb) {
  const colours = mesh.geometry.getAttribute("color");
  for (let i = 0; i < srgb.length; ++i) colours.array[i] = toLinear[srgb[i]];
  colours.needsUpdate = true;
}

/** @param {ColouredMesh} mesh @param {Float32Array} positions @param {Float32Array} normals */
export function moveMesh({ geometry }, positions, normals) {
  for (const [name, values] of /** @type {const} */ ([["position", positions], ["normal", normals]])) {
    const attribute = geometry.getAttribute(name);
    attribute.array.set(values);
    attribute.needsUpdate = true;
  }
  geometry.boundingSphere = null;
  moved(geometry);
}
