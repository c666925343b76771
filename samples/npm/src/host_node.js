// SPDX-License-Identifier: MIT
// What only node has. package.json's "imports" says who gets this file and who host_web.js, so that no bundler for the web sees node's modules.
import { readFile } from "node:fs/promises";
import { parentPort } from "node:worker_threads";

/**
 * Bytes of a file: address.
 * @param {URL} address
 */
export const readFileAt = (address) => readFile(address);
/** A worker's way to who started it, or null. */
export const ownPort = () => parentPort;
