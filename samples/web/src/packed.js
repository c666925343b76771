// SPDX-License-Identifier: MIT
// What build.sh packed: modules and models.
import { unpackLzma } from "./lzma.js";

/** @param {string} name @param {string} status */
const missing = (name, status) => new Error(`${name}: ${status}; build the page with samples/web/build.sh`);

/**
 * The bytes of NAME, of which the page's folder has NAME.lzma.
 * @param {string} name
 */
export async function fetchPacked(name) {
  const response = await fetch(`${name}.lzma`);
  if (!response.ok) throw missing(`${name}.lzma`, `${response.status} ${response.statusText}`);
  return unpackLzma(new Uint8Array(await response.arrayBuffer()));
}

// In the middle of a call: a worker may wait.
/** @param {string} name */
export function fetchPackedNow(name) {
  const request = new XMLHttpRequest();
  request.open("GET", `${name}.lzma`, false);
  request.responseType = "arraybuffer";
  request.send();
  if (request.status !== 200) throw missing(`${name}.lzma`, `${request.status}`);
  return unpackLzma(new Uint8Array(request.response));
}
