// SPDX-License-Identifier: MIT
// One of the two modules, with SIMD and without, from where the options say, and the class that calls it.
import { Calls } from "./calls.js";
import { compile, decodeBase64, hasSimd, instantiate } from "./loader.js";

/** @type {(source: any) => boolean} */
const isPair = (source) => source != null && typeof source === "object" && "simd" in source && "scalar" in source;

/**
 * @param {new (calls: Calls) => any} type
 * @param {import("./index.js").LoadOptions} options
 * @param {(simd: boolean) => Promise<{default: string}>} copies the modules inside of the scripts; bundlers make a chunk of each
 */
export async function start(type, options, copies) {
  const simd = !options.scalar && hasSimd();
  /** @type {any} */
  const { wasm } = options;
  let source = isPair(wasm) ? wasm[simd ? "simd" : "scalar"] : wasm;
  if (source == null) source = decodeBase64((await copies(simd)).default);
  /** @type {{ progress: ((share: number) => boolean | void) | null }} */
  const report = { progress: null };
  const exports = await instantiate(await compile(source), {
    sinew: { progress: (/** @type {number} */ permille) => (report.progress?.(permille / 1000) === true ? 1 : 0) },
  });
  const engine = new type(new Calls(exports, report));
  if (options.model != null) engine.model = engine.openModel(options.model);
  return engine;
}
