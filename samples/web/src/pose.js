// SPDX-License-Identifier: MIT
// Turns of all joints in degrees: x, then y, then z, about the joint's rest position; children follow.

export class Pose {
  turns;

  constructor(jointCount) {
    this.turns = new Float32Array(jointCount * 3);
  }

  of(joint) {
    return this.turns.subarray(joint * 3, joint * 3 + 3);
  }

  get isRest() {
    return this.turns.every((t) => t === 0);
  }

  set(joint, x, y, z) {
    this.turns.set([x, y, z], joint * 3);
  }

  reset() {
    this.turns.fill(0);
  }
}
