// SPDX-License-Identifier: MIT
/** Addresses of the modules as files, for load({ wasm }) of . and of ./bind. */
export const wasm: { simd: URL; scalar: URL };
export const bindWasm: { simd: URL; scalar: URL };
