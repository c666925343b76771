// SPDX-License-Identifier: MIT
// Joints of a predicted skeleton that lie out of the mesh: they are to be looked at, as limbs in doubt are.
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
