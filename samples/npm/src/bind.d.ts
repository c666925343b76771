// SPDX-License-Identifier: MIT
import type { Bound, BindOptions, LoadOptions, Mesh, Model, Skeleton } from "./index.js";
export { SinewError } from "./index.js";

/** What Skin of ./index.d.ts has for binding, in a smaller module. */
export class Binder {
  protected constructor();
  readonly version: string;
  readonly kernel: "simd128" | "ref";
  model: Model | null;
  openModel(bytes: ArrayBuffer | ArrayBufferView): Model;
  bind(mesh: Mesh, skeleton: Skeleton, options?: BindOptions): Bound;
  chooseJoints(mesh: Mesh, skeleton: Skeleton): { flags: Uint8Array; tips: Uint8Array };
}
export function load(options?: LoadOptions): Promise<Binder>;
