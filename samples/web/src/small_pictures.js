// SPDX-License-Identifier: MIT
// Small pictures of the character alone: of a part that a question is about, orange on gray, and of poses of a clip.
import { Box3, DirectionalLight, HemisphereLight, MathUtils, NoToneMapping, PerspectiveCamera, SRGBColorSpace, Vector3, WebGLRenderTarget } from "three";

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

/** @typedef {{ renderer: import("three").WebGLRenderer, scene: import("three").Scene, model: import("three").Object3D, from: number[] }} Of from: the direction that the camera is in */

// Nothing but that part of the model is visible while `use` runs, and no light but its own.
/**
 * @param {Of} of
 * @param {import("three").Object3D} shown
 * @param {() => string | null} use
 */
function alone({ scene, model }, shown, use) {
  const others = [...scene.children.filter((one) => one !== model), ...model.children.filter((one) => one !== shown)].filter(({ visible }) => visible);
  const wasShown = shown.visible;
  for (const one of others) one.visible = false;
  shown.visible = true;
  try {
    return use();
  } finally {
    for (const one of others) one.visible = true;
    shown.visible = wasShown;
  }
}

// Draws a ball of the scene.
/** @param {Of} of @param {Vector3} centre @param {number} radius @param {number} aspect @param {import("three").Light[]} lights */
function drawAt({ renderer, scene, from }, centre, radius, aspect, lights) {
  const camera = new PerspectiveCamera(35, aspect, radius / 200, radius * 200);
  camera.position.copy(centre).addScaledVector(new Vector3().fromArray(from).normalize(), radius / Math.sin((camera.fov * MathUtils.DEG2RAD) / 2));
  camera.lookAt(centre);
  for (const light of lights) camera.add(light);
  lights[0].position.set(0.6, 0.9, 0.7);
  scene.add(camera);
  renderer.render(scene, camera);
  camera.removeFromParent();
}

/**
 * The address of a strip of square pictures of the character in poses.
 * @param {Of & { shown: import("three").Object3D, box: Box3 }} of
 * @param {{ pose: () => void, middle: Vector3 }[]} poses middle: of its joints, that the picture goes along with over the floor
 */
export function pictureOfPoses({ shown, box, ...of }, poses) {
  const sizes = box.clone().applyMatrix4(of.model.matrixWorld), centre = sizes.getCenter(new Vector3()), radius = sizes.getSize(new Vector3()).length() / 2;
  const draws = poses.map(({ pose, middle }) => () => {
    pose();
    drawAt(of, middle.clone().applyMatrix4(of.model.matrixWorld).setY(centre.y), 1.08 * radius, 1, [new DirectionalLight(0xffffff, 0.9)]);
  });
  return alone(of, shown, () => stripOf(of.renderer, [poseSide, poseSide], draws));
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
 * @param {Of & { mesh: import("three").Mesh, radius: number }} of
 * @param {{ of: ArrayLike<number>, number: number } | undefined} members
 * @param {ArrayLike<number>} vertexOf
 * @param {[number, number]} size pixels
 */
export function pictureOfPart({ mesh, radius, ...of }, members, vertexOf, [width, height] = [144, 108]) {
  if (!members) return null;
  const { renderer, scene } = of, { toneMapping } = renderer, { environment } = scene;
  const draw = (/** @type {Box3} */ box) => {
    box.applyMatrix4(of.model.matrixWorld);
    const far = 1.6 * Math.max(box.getSize(new Vector3()).length() / 2, leastShare * radius);
    return stripOf(renderer, [width, height], [() => drawAt(of, box.getCenter(new Vector3()), far, width / height, [new DirectionalLight(0xffffff, 1.7), new HemisphereLight(0xffffff, 0x8b93a3, 1.9)])]);
  };
  renderer.toneMapping = NoToneMapping;
  scene.environment = null;
  try {
    return alone(of, mesh, () => whilePainted(mesh.geometry, members, vertexOf, draw));
  } finally {
    renderer.toneMapping = toneMapping;
    scene.environment = environment;
  }
}
