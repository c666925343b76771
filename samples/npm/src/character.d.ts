// SPDX-License-Identifier: MIT
// What the command does with one character, with its defaults: sinew/character.h says more of each option.
import type { Mesh, Skeleton, WasmSource } from "./index.js";
export { SinewError } from "./index.js";

export * from "./jobs.js";
import type * as jobs from "./jobs.js";
export type BodyClass = jobs.PictureInfo["bodyClass"];

export interface CharacterArrays {
  name: string;
  mesh: Mesh;
  skeleton: Skeleton;
  /** joint: joint that carries a mesh without a skin, or -1 */
  meshes: { name: string; joint: number; skinned: boolean }[];
  /** rows as CSR; null without weights */
  weights: { rowOffsets: Uint32Array; joints: Uint32Array; weights: Float32Array } | null;
  /** [V] of the last bind */
  confidence: Uint8Array | null;
}

export class CharacterFile {
  private constructor();
  readonly notes: string[];
  /** of a picture's character; an error for others */
  readonly picture: jobs.PictureInfo;
  bind(options?: jobs.BindOptions): jobs.BindResult;
  rig(options?: jobs.RigOptions): jobs.RigResult;
  retarget(motion: CharacterFile | null, options?: jobs.RetargetOptions): jobs.AnimateResult;
  transfer(source: CharacterFile, options?: jobs.TransferOptions): jobs.TransferResult;
  transform(options: jobs.TransformOptions): void;
  setProfile(options: jobs.ProfileOptions): void;
  /** the text of a .controls.json, see formats/spec/controls.md */
  readonly controls: string;
  /** findings: errors first; line: "checked: 0 findings"; score: 0..100, null if not requested */
  check(options?: jobs.CheckOptions): jobs.CheckResult;
  /** proposed chains, those of the file first: names and kinds one per line, kept and certainties by index */
  springs(options?: jobs.SpringsOptions): jobs.SpringsResult;
  view(): CharacterArrays;
  /** bytes of a .glb, .vrm, .bvh or .rig.txt */
  save(name: string): Uint8Array;
  /** all files that the command would write, the named one first */
  files(name: string): { name: string; bytes: Uint8Array }[];
  /** of openKeypoints(): local rotations [J x 4] and translations [J x 3] in the frame of these keypoints [n x 3] */
  keypointsFrame(keypoints: ArrayLike<number>): { rotations: Float32Array; translations: Float32Array };
  close(): void;
}

export class CharacterModule {
  private constructor();
  /** keypoints of a person (positions only, as from a camera) as a motion; for keypointsFrame(). Frames of [n x 3] numbers each */
  openKeypoints(layout: "smpl24" | "humanml3d22" | "lafan22" | "smplh52" | "smplx55" | "coco17" | "h36m17" | "h36m32" | "kinect25" | "openpose25" | "mediapipe33", frames: ArrayLike<number>[]): CharacterFile;
  open(bytes: ArrayBuffer | ArrayBufferView, name: string, beside?: Record<string, ArrayBuffer | ArrayBufferView>, picture?: jobs.PictureOptions): Promise<CharacterFile>;
}

/** wasm, scenes: wasm/character.wasm and, for FBX and COLLADA, wasm/scenes.wasm, where the bundler does not know new URL(). */
export function load(options?: { wasm?: WasmSource; scenes?: WasmSource }): Promise<CharacterModule>;
