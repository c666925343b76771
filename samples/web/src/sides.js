// SPDX-License-Identifier: MIT
// The box around a mesh.

/** @param {Float32Array} positions [V x 3] @returns {number[]} along x, y and z */
export function extentsOf(positions) {
  const least = [Infinity, Infinity, Infinity];
  const most = [-Infinity, -Infinity, -Infinity];
  positions.forEach((x, i) => {
    least[i % 3] = Math.min(least[i % 3], x);
    most[i % 3] = Math.max(most[i % 3], x);
  });
  return most.map((x, axis) => x - least[axis]);
}

// Its sides, the longest first.
/** @param {Float32Array} positions [V x 3] @returns {number[]} */
export const sidesOf = (positions) => extentsOf(positions).sort((a, b) => b - a);

/** @param {Float32Array} positions [V x 3] */
export const longestSide = (positions) => sidesOf(positions)[0];
