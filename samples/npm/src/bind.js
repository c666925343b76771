// SPDX-License-Identifier: MIT
// Skin weights alone, in a smaller module: for a page that binds and does nothing else.
import { Binder } from "./binder.js";
import { start } from "./start.js";

export { SinewError } from "./memory.js";

/**
 * Starts the module.
 * @param {import("./index.js").LoadOptions} options
 * @returns {Promise<Binder>}
 */
export const load = (options = {}) =>
  start(Binder, options, (simd) => (simd ? import("../wasm/bind-simd.js") : import("../wasm/bind-scalar.js")));
