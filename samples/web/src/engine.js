// SPDX-License-Identifier: MIT
// The worker's calls as promises. A worker that is stopped answers nothing more: another one takes its place.

export class Stopped extends Error {}

export class Engine {
  #worker;
  #waiting = new Map();
  #last = 0;
  #isStarted = false;
  epoch = 0; // of workers: what one knew the next does not
  onProgress = () => {};

  constructor() {
    this.#begin();
  }

  // Until a new worker is started, what an ended job still asks is rejected.
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
    this.#rejectAll(new Stopped("stopped"));
    this.#begin();
  }

  #begin() {
    ++this.epoch;
    this.#isStarted = false;
    this.#worker = new Worker("worker.js", { type: "module" });
    this.#worker.onmessage = ({ data }) => {
      if (data.progress !== undefined) return this.onProgress(data.progress);
      const { resolve, reject } = this.#waiting.get(data.id);
      this.#waiting.delete(data.id);
      if (data.error !== undefined) reject(new Error(data.error));
      else resolve(data.reply);
    };
    this.#worker.onerror = (event) => {
      event.preventDefault();
      this.#rejectAll(new Error(`the engine stopped: ${event.message}; reload the page`));
    };
  }

  #rejectAll(error) {
    for (const { reject } of this.#waiting.values()) reject(error);
    this.#waiting.clear();
  }
}
