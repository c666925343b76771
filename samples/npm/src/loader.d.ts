// SPDX-License-Identifier: MIT
// How modules are started, for programs with a module of their own.
export { compile, decodeBase64, hasExceptions, hasSimd, instantiate } from "./index.js";
