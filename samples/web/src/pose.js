// SPDX-License-Identifier: MIT
// Turns of all joints in degrees (x, then y, then z, about the joint's rest position; children follow), with undo.

export class Pose {
  #past = [];
  #future = [];
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

  // Call before a change that undo should take back as one.
  remember() {
    this.#past.push(this.turns.slice());
    if (this.#past.length > 200) this.#past.shift();
    this.#future = [];
  }

  set(joint, x, y, z) {
    this.turns.set([x, y, z], joint * 3);
  }

  reset() {
    if (this.isRest) return false;
    this.remember();
    this.turns.fill(0);
    return true;
  }

  undo() {
    return this.#step(this.#past, this.#future);
  }
  redo() {
    return this.#step(this.#future, this.#past);
  }
  get canUndo() {
    return this.#past.length > 0;
  }

  #step(from, to) {
    if (from.length === 0) return false;
    to.push(this.turns.slice());
    this.turns.set(from.pop());
    return true;
  }
}
