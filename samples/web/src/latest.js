// SPDX-License-Identifier: MIT
// Work that is wanted faster than it can be done: what is wanted last is done next, what came between is left out.

/** @template Wanted */
export class Latest {
  #job;
  /** @type {{ what: any } | null} */
  #wanted = null;
  /** @type {Promise<void> | null} */
  #running = null;

  /** @param {(what: Wanted) => Promise<any>} job */
  constructor(job) {
    this.#job = job;
  }

  get busy() {
    return this.#running !== null;
  }

  // Whether something newer is wanted than what is being done.
  get pending() {
    return Boolean(this.#wanted);
  }

  // When nothing is wanted any more; rejects as want() does.
  idle() {
    return this.#running ?? Promise.resolve();
  }

  // Resolves when nothing is wanted any more; rejects with the first error, which ends what was wanted after it too.
  /** @param {Wanted} [what] */
  want(what) {
    this.#wanted = { what };
    this.#running ??= this.#run();
    return this.#running;
  }

  async #run() {
    try {
      while (this.#wanted) {
        const { what } = this.#wanted;
        this.#wanted = null;
        await this.#job(what);
      }
    } finally {
      this.#wanted = null;
      this.#running = null;
    }
  }
}
