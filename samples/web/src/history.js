// SPDX-License-Identifier: MIT
// One history for everything that is done to a character: states with the names of the steps that led to them. A state is never changed, the
// page makes another one.

const mostSteps = 100;
const oneStep = 1200; // milliseconds within which the same kind of step goes on, as arrow keys on a slider do

/** @typedef {import("./types.js").State} State */

export class History {
  /** @type {{ name: string, state: State }[]} */
  #steps; // [{name, state}], the first one without a name
  #at = 0;
  #last = { name: "", time: -Infinity };

  /** @param {State} state */
  constructor(state) {
    this.#steps = [{ name: "", state }];
  }

  get now() {
    return this.#steps[this.#at].state;
  }
  // Of the step that undo takes back, and that redo does again; "" for none.
  get undoName() {
    return this.#steps[this.#at].name;
  }
  get redoName() {
    return this.#steps[this.#at + 1]?.name ?? "";
  }
  get states() {
    return this.#steps.map(({ state }) => state);
  }

  // goesOn: such a step right after one of the same name is that one.
  /**
   * @param {string} name
   * @param {State} state
   * @param {{ goesOn?: boolean, time?: number }} how
   */
  add(name, state, { goesOn = false, time = Date.now() } = {}) {
    const same = goesOn && this.#at > 0 && this.#last.name === name && time - this.#last.time < oneStep && this.#at === this.#steps.length - 1;
    this.#last = { name, time };
    if (same) {
      this.#steps[this.#at] = { name, state };
      return;
    }
    this.#steps.splice(this.#at + 1, Infinity, { name, state });
    if (this.#steps.length > mostSteps + 1) this.#steps.shift();
    this.#at = this.#steps.length - 1;
  }

  // The present step with another state, as when what it holds was made anew.
  /** @param {State} state */
  replace(state) {
    this.#steps[this.#at] = { ...this.#steps[this.#at], state };
  }

  // The state to go to, null where there is none; it is the present one then.
  undo() {
    return this.#go(-1);
  }
  redo() {
    return this.#go(1);
  }

  /** @param {number} by */
  #go(by) {
    const to = this.#steps[this.#at + by];
    if (!to) return null;
    this.#at += by;
    this.#last.time = -Infinity;
    return to.state;
  }
}
