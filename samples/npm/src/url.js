// SPDX-License-Identifier: MIT
// Addresses of the modules as files, for load({ wasm }): a third smaller over the wire than the copies inside of the scripts, compiled while
// they arrive, and cached by the browser. webpack, Vite and node know `new URL(..., import.meta.url)`.

/** For load() of @sinew/skin. */
export const wasm = {
  simd: new URL("../wasm/simd.wasm", import.meta.url),
  scalar: new URL("../wasm/scalar.wasm", import.meta.url),
};
/** For load() of @sinew/skin/bind. */
export const bindWasm = {
  simd: new URL("../wasm/bind-simd.wasm", import.meta.url),
  scalar: new URL("../wasm/bind-scalar.wasm", import.meta.url),
};
