// SPDX-License-Identifier: MIT
// The package's entry: starts the engine, in the thread that calls it. ./worker runs it beside, ./bind has less.
import { Skin } from "./engine.js";
import { start } from "./start.js";

export { compile, decodeBase64, hasExceptions, hasSimd, instantiate } from "./loader.js";
export { SinewError } from "./memory.js";
export { babylonBuffers, playcanvasBuffers } from "./buffers.js";

/**
 * Starts the engine.
 * @param {import("./index.js").LoadOptions} options
 * @returns {Promise<Skin>}
 */
export const load = (options = {}) =>
  start(Skin, options, (simd) => (simd ? import("../wasm/simd.js") : import("../wasm/scalar.js")));
