// SPDX-License-Identifier: MIT
// Modules and models, which build.sh packs as zlib does: servers pack few kinds of files by themselves.
import { unzlibSync } from "three/addons/libs/fflate.module.js";

/** @param {string} name */
const damaged = (name) => new Error(`${name}: damaged or incomplete; reload the page`);
/** @param {string} name @param {string} status */
const missing = (name, status) => new Error(`${name}: ${status}; build the page with samples/web/build.sh`);

/**
 * The bytes of NAME, of which the page's folder has NAME.zlib.
 * @param {string} name
 */
export async function fetchPacked(name) {
  const packed = `${name}.zlib`;
  const response = await fetch(packed);
  if (!response.ok || !response.body) throw missing(packed, `${response.status} ${response.statusText}`);
  try {
    if (!("DecompressionStream" in self)) return unzlibSync(new Uint8Array(await response.arrayBuffer())); // before Firefox 113 and Safari 16.4
    const stream = response.body.pipeThrough(new DecompressionStream("deflate"));
    return new Uint8Array(await new Response(stream).arrayBuffer());
  } catch {
    throw damaged(packed);
  }
}

// In the middle of a call, where a worker can wait for a file but not for a stream.
/** @param {string} name */
export function fetchPackedNow(name) {
  const packed = `${name}.zlib`;
  const request = new XMLHttpRequest();
  request.open("GET", packed, false);
  request.responseType = "arraybuffer";
  request.send();
  if (request.status !== 200) throw missing(packed, `${request.status}`);
  try {
    return unzlibSync(new Uint8Array(request.response));
  } catch {
    throw damaged(packed);
  }
}
