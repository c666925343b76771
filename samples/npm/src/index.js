// SPDX-License-Identifier: MIT
// The package's entry: starts the engine, in the thread that calls it. ./worker runs it beside.
import { Skin } from "./engine.js";
import { compile, decodeBase64, hasSimd, instantiate } from "./loader.js";

export { compile, decodeBase64, hasSimd, instantiate } from "./loader.js";
export { SinewError } from "./memory.js";
export { babylonBuffers, playcanvasBuffers } from "./buffers.js";

/**
 * Starts the engine.
 * @param {import("./index.js").LoadOptions} options
 * @returns {Promise<Skin>}
 */
export async function load(options = {}) {
  const simd = !options.scalar && hasSimd();
  let source = options.wasm;
  // One of the two modules alone is loaded; bundlers make a chunk of each.
  if (source == null) source = decodeBase64((simd ? await import("../wasm/simd.js") : await import("../wasm/scalar.js")).default);
  const report = { progress: null };
  const exports = await instantiate(await compile(source), {
    sinew: { progress: (permille) => (report.progress?.(permille / 1000) === false ? 1 : 0) },
  });
  const skin = new Skin(exports, report);
  if (options.model != null) skin.model = skin.openModel(options.model);
  return skin;
}
