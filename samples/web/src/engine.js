// SPDX-License-Identifier: MIT
// The worker's calls as promises.

export class Engine {
  #worker = new Worker("worker.js", { type: "module" });
  #waiting = new Map();
  #last = 0;
  onProgress = () => {};

  constructor() {
    this.#worker.onmessage = ({ data }) => {
      if (data.progress !== undefined) return this.onProgress(data.progress);
      const { resolve, reject } = this.#waiting.get(data.id);
      this.#waiting.delete(data.id);
      if (data.error !== undefined) reject(new Error(data.error));
      else resolve(data.reply);
    };
    this.#worker.onerror = (event) => {
      event.preventDefault();
      for (const { reject } of this.#waiting.values()) reject(new Error(`the engine stopped: ${event.message}; reload the page`));
      this.#waiting.clear();
    };
  }

  call(call, options = {}, transfer = []) {
    return new Promise((resolve, reject) => {
      const id = ++this.#last;
      this.#waiting.set(id, { resolve, reject });
      this.#worker.postMessage({ id, call, ...options }, transfer);
    });
  }
}
