// SPDX-License-Identifier: MIT
// Starts a module of WebAssembly anywhere: in a page, a worker, node, with and without SIMD.
import { readFileAt } from "#host";

// A function that adds two lanes: valid only where SIMD is.
const simdProbe = new Uint8Array([
  0, 97, 115, 109, 1, 0, 0, 0, 1, 5, 1, 96, 0, 1, 123, 3, 2, 1, 0, 10, 10, 1, 8, 0, 65, 0, 253, 15, 253, 98, 11,
]);

/** Whether this browser or node runs WebAssembly's 128-bit SIMD. A module that uses it does not start where it is missing. */
export const hasSimd = () => WebAssembly.validate(simdProbe);

// A function that catches what it throws, as emscripten writes it.
const exceptionsProbe = new Uint8Array([
  0, 97, 115, 109, 1, 0, 0, 0, 1, 4, 1, 96, 0, 0, 3, 2, 1, 0, 10, 8, 1, 6, 0, 6, 64, 25, 11, 11,
]);

/** Whether this browser or node runs exceptions of WebAssembly's own. A module that has some does not start where they are missing. */
export const hasExceptions = () => WebAssembly.validate(exceptionsProbe);

// Compiled while it arrives, where the server names its kind.
/** @param {Response} response */
async function compileResponse(response) {
  if (!response.ok) throw new Error(`${response.url}: ${response.status} ${response.statusText}, expected a WebAssembly file`);
  const streams = "compileStreaming" in WebAssembly && response.headers.get("content-type") === "application/wasm";
  return streams ? WebAssembly.compileStreaming(response) : WebAssembly.compile(await response.arrayBuffer());
}

// http(s) and data by fetch(), file: (node) from the disk.
/** @param {string | URL} url */
async function compileAt(url) {
  const address = new URL(url, globalThis.location?.href ?? import.meta.url);
  return address.protocol === "file:" ? WebAssembly.compile(await readFileAt(address)) : compileResponse(await fetch(address));
}

/**
 * A compiled module of what names or holds one.
 * @param {WebAssembly.Module | BufferSource | URL | string | Response | Promise<unknown>} source
 */
export async function compile(source) {
  const given = await source;
  if (given instanceof WebAssembly.Module) return given;
  if (typeof Response !== "undefined" && given instanceof Response) return compileResponse(given);
  if (typeof given === "string" || given instanceof URL) return compileAt(given);
  return WebAssembly.compile(/** @type {BufferSource} */ (given));
}

/**
 * Starts a module. What it imports besides `imports` is the C library's world outside, which the engine never asks for:
 * such a call is an error that says its name.
 * @param {WebAssembly.Module} module
 * @param {Record<string, Record<string, Function>>} imports
 * @returns {Promise<WebAssembly.Exports>}
 */
export async function instantiate(module, imports) {
  /** @type {Record<string, any>} */
  const all = {};
  for (const { module: from, name, kind } of WebAssembly.Module.imports(module)) {
    if (kind !== "function") throw new Error(`the module imports ${from}.${name}, a ${kind}, expected functions alone`);
    const refuse = () => {
      throw new Error(`the module called ${from}.${name}, which it has no use for`);
    };
    const quiet = name === "emscripten_notify_memory_growth" ? () => {} : refuse;
    (all[from] ??= {})[name] = imports[from]?.[name] ?? quiet;
  }
  const { exports } = await WebAssembly.instantiate(module, all);
  const initialize = exports._initialize;
  if (typeof initialize === "function") initialize();
  return exports;
}

/**
 * Bytes of base64 text.
 * @param {string} text
 */
export function decodeBase64(text) {
  if ("fromBase64" in Uint8Array && typeof Uint8Array.fromBase64 === "function") return Uint8Array.fromBase64(text);
  const binary = atob(text);
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < bytes.length; ++i) bytes[i] = binary.charCodeAt(i);
  return bytes;
}
