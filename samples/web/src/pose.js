// SPDX-License-Identifier: MIT
// Turns of all joints in degrees: x, then y, then z, about the joint's rest position; children follow.

export class Pose {
  turns;

  /** @param {number} jointCount */
  constructor(jointCount) {
    this.turns = new Float32Array(jointCount * 3);
  }

  /** @param {number} joint */
  of(joint) {
    return this.turns.subarray(joint * 3, joint * 3 + 3);
  }

  get isRest() {
    return this.turns.every((t) => t === 0);
  }

  /** @param {number} joint @param {number} x @param {number} y @param {number} z */
  set(joint, x, y, z) {
    this.turns.set([x, y, z], joint * 3);
  }

  reset() {
    this.turns.fill(0);
  }
}
