// SPDX-License-Identifier: MIT
// The module in the parts that wasm/split.sh makes of it: what binds, what makes skeletons, the rest. Later ones are fetched afterwards, or when one of
// their functions is called before.
import { compile } from "@sinew/skin/loader";
import { fetchPacked, fetchPackedNow } from "./packed.js";

export class Parts {
  /** @type {any} */
  primary; // exports of the first part
  #names;
  #there = 0; // how many of these are
  /** @type {Promise<void> | null} */
  #loading = null;
  wasLastAsked = false;

  /** @param {string[]} names of those after the first */
  constructor(names) {
    this.#names = names;
  }

  // imports with a function for each that is not there yet; its name is its place in the table.
  /** @param {any} imports */
  withPlaceholders(imports) {
    const functions = new Proxy({}, { get: (_, place) => (/** @type {any[]} */ ...args) => this.#functionAt(Number(place))(...args) });
    return { ...imports, placeholder: functions };
  }

  // Resolved once that many of the later parts are there.
  async loaded(count = this.#names.length) {
    while (this.#there < count) {
      this.#loading ??= this.#load().finally(() => (this.#loading = null)); // what failed is tried again
      await this.#loading;
    }
  }

  async #load() {
    const next = this.#there;
    const compiled = await compile(await fetchPacked(this.#asked()));
    if (this.#there > next) return; // a call could not wait
    await WebAssembly.instantiate(compiled, { primary: this.primary });
    this.#there = Math.max(this.#there, next + 1);
  }

  // Parts are there one after another; each puts its functions into the table.
  /** @param {number} place */
  #functionAt(place) {
    const table = this.#table;
    const placeholder = table.get(place);
    while (table.get(place) === placeholder && this.#there < this.#names.length) {
      new WebAssembly.Instance(new WebAssembly.Module(fetchPackedNow(this.#asked())), { primary: this.primary });
      ++this.#there;
    }
    return table.get(place);
  }

  // The part that is next.
  #asked() {
    this.wasLastAsked ||= this.#there === this.#names.length - 1;
    return this.#names[this.#there];
  }

  /** @type {any} */
  get #table() {
    return Object.values(this.primary).find((one) => one instanceof WebAssembly.Table);
  }
}
