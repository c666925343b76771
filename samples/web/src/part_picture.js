// SPDX-License-Identifier: MIT
// Pictures of parts of the mesh for the cards that ask about them: the part orange, the rest grey.
import { Box3, DirectionalLight, MathUtils, NoToneMapping, PerspectiveCamera, SRGBColorSpace, Vector3, WebGLRenderTarget } from "three";
import { slanted } from "./framing.js";

const part = [0.87, 0.19, 0.007]; // linear
const rest = [0.3, 0.32, 0.36];
const poseSide = 96; // pixels
const leastShare = 0.18; // of the character that is shown at least

// The address of a strip of pictures side by side, each drawn by `draw` into a target of its size.
/**
 * @param {import("three").WebGLRenderer} renderer
 * @param {[number, number]} size pixels of each
 * @param {(() => void)[]} draws
 */
function stripOf(renderer, [width, height], draws) {
  const canvas = Object.assign(document.createElement("canvas"), { width: width * draws.length, height }), context = canvas.getContext("2d");
  const target = new WebGLRenderTarget(width, height, { samples: 4, colorSpace: SRGBColorSpace }), pixels = new Uint8ClampedArray(4 * width * height);
  try {
    for (const [number, draw] of draws.entries()) {
      renderer.setRenderTarget(target);
      renderer.clear();
      draw();
      renderer.readRenderTargetPixels(target, 0, 0, width, height, pixels);
      const upright = new ImageData(width, height); // WebGL reads its rows upwards
      for (let y = 0; y < height; ++y) upright.data.set(pixels.subarray(4 * width * (height - 1 - y), 4 * width * (height - y)), 4 * width * y);
      context?.putImageData(upright, number * width, 0);
    }
  } finally {
    renderer.setRenderTarget(null);
    target.dispose();
  }
  return canvas.toDataURL();
}

// A camera that has a ball in view, from the usual slanted side.
/** @param {Vector3} centre @param {number} radius @param {number} aspect */
function cameraAt(centre, radius, aspect) {
  const camera = new PerspectiveCamera(35, aspect, radius / 200, radius * 200);
  camera.position.copy(centre).addScaledVector(new Vector3().fromArray(slanted).normalize(), radius / Math.sin((camera.fov * MathUtils.DEG2RAD) / 2));
  camera.lookAt(centre);
  return camera;
}

/**
 * The address of a strip of square pictures of the character in poses.
 * @param {{ renderer: import("three").WebGLRenderer, scene: import("three").Scene, model: import("three").Object3D, shown: import("three").Object3D, box: Box3 }} of
 * @param {{ pose: () => void, middle: Vector3 }[]} poses middle: of its joints, that the picture goes along with over the floor
 */
export function pictureOfPoses({ renderer, scene, model, shown, box }, poses) {
  const others = [...scene.children.filter((one) => one !== model && !("isLight" in one)), ...model.children.filter((one) => one !== shown)].filter(({ visible }) => visible);
  const sizes = box.clone().applyMatrix4(model.matrixWorld), centre = sizes.getCenter(new Vector3()), radius = sizes.getSize(new Vector3()).length() / 2;
  for (const one of others) one.visible = false;
  try {
    const draws = poses.map(({ pose, middle }) => () => {
      pose();
      const at = middle.clone().applyMatrix4(model.matrixWorld).setY(centre.y);
      const camera = cameraAt(at, 1.08 * radius, 1);
      camera.add(new DirectionalLight(0xffffff, 0.9));
      scene.add(camera);
      renderer.render(scene, camera);
      camera.removeFromParent();
    });
    return stripOf(renderer, [poseSide, poseSide], draws);
  } finally {
    for (const one of others) one.visible = true;
  }
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
  const wasShown = mesh.visible;
  const others = hidden.filter((one) => one?.visible);
  const { toneMapping } = renderer;
  const { environment } = scene;
  const draw = (/** @type {Box3} */ box) => {
    box.applyMatrix4(model.matrixWorld);
    const camera = cameraAt(box.getCenter(new Vector3()), 1.6 * Math.max(box.getSize(new Vector3()).length() / 2, leastShare * radius), width / height);
    camera.add(new DirectionalLight(0xffffff, 1.7));
    return stripOf(renderer, [width, height], [() => renderer.render(scene, camera)]);
  };
  for (const one of others) if (one) one.visible = false;
  mesh.visible = true;
  renderer.toneMapping = NoToneMapping;
  scene.environment = null;
  try {
    return whilePainted(mesh.geometry, members, vertexOf, draw);
  } finally {
    for (const one of others) if (one) one.visible = true;
    mesh.visible = wasShown;
    renderer.toneMapping = toneMapping;
    scene.environment = environment;
  }
}
