// SPDX-License-Identifier: MIT
// Modules that are there after a build, and node's that a page never asks for, for the checker of types alone.
declare module "sinew-draco";
declare module "sinew-scenes";
declare module "sinew-simd";
declare module "sinew-scalar";
declare module "*/wasm/bind-simd.js";
declare module "*/wasm/bind-scalar.js";
declare module "*/wasm/character.js";
declare module "*/wasm/scenes.js";
declare module "*/wasm/simd.js";
declare module "*/wasm/scalar.js";
declare module "*/models/weights.js";
declare module "*/models/skeletons.js";
declare module "*/models/fronts.js";
declare module "*/models/hands.js";
declare module "node:fs/promises";
declare module "node:worker_threads";
