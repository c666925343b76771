// SPDX-License-Identifier: MIT
// What the tests with three share: files opened without a browser, and where skinned vertices are.
import { readFileSync } from 'node:fs';
import { AnimationMixer, Vector3 } from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';

export const bytesOf = (file) => {
  const bytes = readFileSync(file);
  return bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength);
};

/** Promise of a glTF; `plugins`: of its loader. */
export const openGltf = (file, ...plugins) => {
  const loader = new GLTFLoader();
  for (const plugin of plugins) loader.register(plugin);
  return new Promise((resolve, reject) => loader.parse(bytesOf(file), '', resolve, reject));
};

export const skinnedMeshes = (root) => {
  const found = [];
  root.traverse((node) => node.isSkinnedMesh && found.push(node));
  return found;
};

/** World positions of all skinned vertices; with a clip those of `seconds`. */
export const skinnedPositions = (root, clip, seconds) => {
  if (clip) {
    const mixer = new AnimationMixer(root);
    mixer.clipAction(clip).play();
    mixer.setTime(seconds);
  }
  root.updateMatrixWorld(true);
  const positions = [];
  for (const mesh of skinnedMeshes(root)) {
    mesh.skeleton.update();
    const count = mesh.geometry.attributes.position.count;
    for (let v = 0; v < count; ++v) positions.push(mesh.localToWorld(mesh.getVertexPosition(v, new Vector3())));
  }
  return positions;
};

/** The largest distance from a point of `a` to the nearest of `b`. */
export const farthest = (a, b) => {
  const cell = 0.05;
  const key = (x, y, z) => `${x},${y},${z}`;
  const at = (p) => [p.x, p.y, p.z].map((value) => Math.floor(value / cell));
  const grid = new Map();
  for (const p of b) {
    const k = key(...at(p));
    grid.set(k, [...(grid.get(k) ?? []), p]);
  }
  let most = 0;
  for (const p of a) {
    const [x, y, z] = at(p);
    let least = cell;
    for (let i = -1; i <= 1; ++i)
      for (let j = -1; j <= 1; ++j)
        for (let k = -1; k <= 1; ++k) for (const q of grid.get(key(x + i, y + j, z + k)) ?? []) least = Math.min(least, p.distanceTo(q));
    most = Math.max(most, least);
  }
  return most;
};
