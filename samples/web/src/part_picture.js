// SPDX-License-Identifier: MIT
// Pictures of parts of the mesh for the cards that ask about them: the part orange, the rest grey.
import { Box3, DirectionalLight, MathUtils, NoToneMapping, PerspectiveCamera, SRGBColorSpace, Vector3, WebGLRenderTarget } from "three";
import { slanted } from "./framing.js";

const part = [0.87, 0.19, 0.007]; // linear
const rest = [0.3, 0.32, 0.36];
const leastShare = 0.18; // of the character that is shown at least

// The address of a picture whose rows go upwards, as WebGL reads them.
/**
 * @param {Uint8ClampedArray} pixels
 * @param {number} width
 * @param {number} height
 */
function addressOf(pixels, width, height) {
  const canvas = Object.assign(document.createElement("canvas"), { width, height });
  const upright = new ImageData(width, height);
  for (let y = 0; y < height; ++y) upright.data.set(pixels.subarray(4 * width * (height - 1 - y), 4 * width * (height - y)), 4 * width * y);
  canvas.getContext("2d")?.putImageData(upright, 0, 0);
  return canvas.toDataURL();
}

/**
 * The vertices of a part are painted orange while `use` runs.
 * @param {import("three").BufferGeometry} geometry
 * @param {{ of: ArrayLike<number>, number: number }} members see Questions
 * @param {ArrayLike<number>} vertexOf of shown vertices
 * @param {(box: Box3) => string} use
 */
function whilePainted(geometry, members, vertexOf, use) {
  const [positions, colours] = [geometry.getAttribute("position"), geometry.getAttribute("color")];
  const before = colours.array.slice();
  const box = new Box3(), at = new Vector3();
  for (let i = 0; i < vertexOf.length; ++i) {
    const isPart = members.of[vertexOf[i]] === members.number;
    if (isPart) box.expandByPoint(at.set(positions.getX(i), positions.getY(i), positions.getZ(i)));
    const [r, g, b] = isPart ? part : rest;
    colours.setXYZ(i, r, g, b);
  }
  colours.needsUpdate = true;
  try {
    return box.isEmpty() ? null : use(box);
  } finally {
    colours.array.set(before);
    colours.needsUpdate = true;
  }
}

/**
 * The address of a PNG of a part at rest; null where there is none.
 * @param {{ renderer: import("three").WebGLRenderer, scene: import("three").Scene, model: import("three").Object3D, mesh: import("three").Mesh, radius: number,
 *   hidden: (import("three").Object3D | null | undefined)[] }} of hidden: what is not in it
 * @param {{ of: ArrayLike<number>, number: number } | undefined} members
 * @param {ArrayLike<number>} vertexOf
 * @param {[number, number]} size pixels
 */
export function pictureOfPart({ renderer, scene, model, mesh, radius, hidden }, members, vertexOf, [width, height] = [144, 108]) {
  if (!members) return null;
  const target = new WebGLRenderTarget(width, height, { samples: 4, colorSpace: SRGBColorSpace });
  const pixels = new Uint8ClampedArray(4 * width * height);
  const wasShown = mesh.visible;
  const others = hidden.filter((one) => one?.visible);
  const { toneMapping } = renderer;
  const { environment } = scene;
  const draw = (/** @type {Box3} */ box) => {
    box.applyMatrix4(model.matrixWorld);
    const camera = new PerspectiveCamera(35, width / height, radius / 200, radius * 200);
    const centre = box.getCenter(new Vector3());
    const seen = Math.max(box.getSize(new Vector3()).length() / 2, leastShare * radius);
    camera.position.copy(centre).addScaledVector(new Vector3().fromArray(slanted).normalize(), (1.6 * seen) / Math.sin((camera.fov * MathUtils.DEG2RAD) / 2));
    camera.lookAt(centre);
    camera.add(new DirectionalLight(0xffffff, 1.7));
    renderer.setRenderTarget(target);
    renderer.clear();
    renderer.render(scene, camera);
    renderer.readRenderTargetPixels(target, 0, 0, width, height, pixels);
    return addressOf(pixels, width, height);
  };
  for (const one of others) if (one) one.visible = false;
  mesh.visible = true;
  renderer.toneMapping = NoToneMapping;
  scene.environment = null;
  try {
    return whilePainted(mesh.geometry, members, vertexOf, draw);
  } finally {
    renderer.setRenderTarget(null);
    target.dispose();
    for (const one of others) if (one) one.visible = true;
    mesh.visible = wasShown;
    renderer.toneMapping = toneMapping;
    scene.environment = environment;
  }
}
