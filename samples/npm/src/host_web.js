// SPDX-License-Identifier: MIT
// A browser's answers to what host_node.js has.

/**
 * Bytes of a file: address: no page may read one.
 * @param {URL} address
 * @returns {Promise<BufferSource>}
 */
export const readFileAt = (address) => Promise.reject(new Error(`${address}: a page cannot read files; serve it and give its http address`));
/** A worker's way to who started it, or null. */
export const ownPort = () => (typeof self !== "undefined" && typeof self.postMessage === "function" ? self : null);
