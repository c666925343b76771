// SPDX-License-Identifier: MIT
// What of a predicted skeleton is to be looked at beside its limbs in doubt: joints that lie out of the mesh, ears that move the head, a body on four legs without a tail.
import { crossings, insides } from "./limbs.js";

const far = 0.06; // of the size, from the nearest vertex: parts may have gaps, and skins are thin
const axes = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];

/**
 * @param {import("./types.js").Joint[]} joints
 * @param {Record<string, any>} surface {positions, triangles} of the mesh
 * @param {number} size of the mesh
 * @returns {{ name: string, joint: number, joints: number[] }[]}
 */
export function jointsOutside(joints, surface, size) {
  const { positions, triangles } = surface;
  const isFar = (/** @type {number[]} */ [x, y, z]) => {
    for (let v = 0; v < positions.length; v += 3) if (Math.hypot(positions[v] - x, positions[v + 1] - y, positions[v + 2] - z) < far * size) return false;
    return true;
  };
  const isInside = (/** @type {number[]} */ place) => axes.filter((axis) => insides(crossings({ positions, triangles }, place, axis)).some(([from, to]) => from <= 0 && to >= 0)).length >= 2;
  return joints.flatMap(({ name, parent, position, end }, joint) => (end || parent < 0 || !isFar(position) || isInside(position) ? [] : [{ name: `${name} outside the body`, joint, joints: [joint] }]));
}

/** @typedef {{ name: string, joint: number, joints: number[] }} Suspect */

// An ear that moves more of the mesh before it begins than behind that: it moves the head.
/** @param {{ name: string, parent: number, position: number[] }[]} joints @param {ArrayLike<number>} strongest the joint that moves each shown vertex most @param {ArrayLike<number>} positions of these @returns {Suspect[]} */
export function earsThatMoveHeads(joints, strongest, positions) {
  return joints.flatMap(({ name, parent, position }, joint) => {
    const tip = joints.findIndex((one) => one.parent === joint);
    if (tip < 0 || !/ear/i.test(name) || !/head/i.test(joints[parent]?.name ?? "")) return [];
    const along = joints[tip].position.map((x, i) => x - position[i]);
    let [before, behind] = [0, 0];
    for (let v = 0; v < strongest.length; ++v) {
      if (strongest[v] !== joint) continue;
      if (along.reduce((sum, x, i) => sum + x * (positions[3 * v + i] - position[i]), 0) < 0) ++before;
      else ++behind;
    }
    return before > behind ? [{ name: `${name} moves the head`, joint, joints: [joint] }] : [];
  });
}

// up: the axis, 1 or 2.
/** @param {{ name: string, position: number[] }[]} joints @param {number} up @returns {Suspect[]} */
export function missingTail(joints, up) {
  const find = (/** @type {RegExp} */ name) => joints.findIndex((joint) => name.test(joint.name));
  const [hips, neck, legs] = [find(/^hips$/i), find(/neck/i), find(/upleg/i)];
  if (hips < 0 || neck < 0 || legs < 0 || find(/tail/i) >= 0) return [];
  const trunk = joints[neck].position.map((x, i) => x - joints[hips].position[i]);
  const isUpright = Math.abs(trunk[up]) > 0.7 * Math.hypot(...trunk);
  return isUpright ? [] : [{ name: "no tail was found", joint: hips, joints: [hips] }];
}
