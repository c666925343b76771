// SPDX-License-Identifier: MIT
// The part of the module that the first bind does not need, as `wasm-split` made it: fetched afterwards, or when one of its functions is called before.
import { compile } from "@sinew/skin/loader";

/** @type {(address: string, status: number) => Error} */
const missing = (address, status) => new Error(`${address}: ${status}; build the page with samples/web/build.sh`);

export class Rest {
  /** @type {any} */
  primary; // exports of the first part
  #address;
  /** @type {any} */
  #loading = null;
  #isThere = false;
  wasAsked = false;

  /** @param {string} address */
  constructor(address) {
    this.#address = address;
  }

  // imports with a function for each that is not there yet; its name is its place in the table.
  /** @param {any} imports */
  withPlaceholders(imports) {
    const functions = new Proxy({}, { get: (_, place) => (/** @type {any[]} */ ...args) => (this.#loadNow(), this.#table?.get(Number(place))(...args)) });
    return { ...imports, placeholder: functions };
  }

  // Resolved once all functions are there.
  loaded() {
    if (this.#isThere) return Promise.resolve();
    this.#loading ??= this.#load().finally(() => (this.#loading = null)); // what failed is tried again
    return this.#loading;
  }

  async #load() {
    this.wasAsked = true;
    const response = await fetch(this.#address);
    if (!response.ok) throw missing(this.#address, response.status);
    const compiled = await compile(response);
    if (!this.#isThere) await WebAssembly.instantiate(compiled, { primary: this.primary });
    this.#isThere = true;
  }

  // In the middle of a call: a worker may wait.
  #loadNow() {
    if (this.#isThere) return;
    this.wasAsked = true;
    const request = new XMLHttpRequest();
    request.open("GET", this.#address, false);
    request.responseType = "arraybuffer";
    request.send();
    if (request.status !== 200) throw missing(this.#address, request.status);
    new WebAssembly.Instance(new WebAssembly.Module(request.response), { primary: this.primary });
    this.#isThere = true;
  }

  get #table() {
    return Object.values(this.primary).find((one) => one instanceof WebAssembly.Table);
  }
}
