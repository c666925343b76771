// SPDX-License-Identifier: MIT
// The worker's calls as promises. A worker that is stopped or ends by itself answers nothing more: another one takes its place.

export class Stopped extends Error {}

export class Engine {
  /** @type {Worker} */
  #worker = new Worker("worker.js", { type: "module" });
  /** @type {Map<number, { resolve: (reply: any) => void, reject: (error: Error) => void }>} */
  #waiting = new Map();
  #last = 0;
  #isStarted = false;
  epoch = 0; // of workers: what one knew the next does not
  /** @type {(share: number) => void} */
  onProgress = () => {};
  /** @type {(cause: string) => void} */
  onCrash = () => {}; // the worker ended by itself: another one is to be started

  constructor() {
    this.#begin();
  }

  // Until a new worker is started, what an ended job still asks is rejected.
  /**
   * @param {string} call
   * @param {object} options
   * @param {Transferable[]} transfer
   * @returns {Promise<any>}
   */
  call(call, options = {}, transfer = []) {
    if (call === "start") this.#isStarted = true;
    else if (!this.#isStarted) return Promise.reject(new Stopped("stopped"));
    return new Promise((resolve, reject) => {
      const id = ++this.#last;
      this.#waiting.set(id, { resolve, reject });
      this.#worker.postMessage({ id, call, ...options }, transfer);
    });
  }

  // Ends what is being done, in the middle of it. What waits is rejected with Stopped; the new worker is to be started.
  stop() {
    this.#worker.terminate();
    for (const { reject } of this.#waiting.values()) reject(new Stopped("stopped"));
    this.#waiting.clear();
    this.#worker = new Worker("worker.js", { type: "module" });
    this.#begin();
  }

  #begin() {
    ++this.epoch;
    this.#isStarted = false;
    this.#worker.onmessage = ({ data }) => {
      if (data.progress !== undefined) return this.onProgress(data.progress);
      if (data.crashed) return this.#crash(data.error);
      const asked = this.#waiting.get(data.id);
      this.#waiting.delete(data.id);
      if (data.error !== undefined) asked?.reject(new Error(data.error));
      else asked?.resolve(data.reply);
    };
    this.#worker.onerror = (event) => {
      event.preventDefault();
      this.#crash(event.message);
    };
  }

  /** @param {string} cause */
  #crash(cause) {
    this.stop();
    this.onCrash(cause);
  }
}
