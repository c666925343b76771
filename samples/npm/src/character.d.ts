// SPDX-License-Identifier: MIT
// What the command does with one character, with its defaults: sinew/character.h says more of each option.
import type { Mesh, Progress, Skeleton, WasmSource } from "./index.js";
export { SinewError } from "./index.js";

export interface BindOptions {
  method?: "model" | "heat" | "distance";
  influences?: number;
  /** y where it is missing */
  up?: "x" | "y" | "z";
  /** where it is known from which joints may get weight; auto: mesh by mesh those that have some, else by names */
  joints?: "auto" | "own" | "names" | "all";
  rigidParts?: "auto" | "always" | "never";
  /** 0.25..4 */
  softness?: number;
  surfaceVertices?: number;
  keepTips?: boolean;
  /** meshes that hang on joints are bound too */
  bindProps?: boolean;
  /** a skeleton in other units or beside the mesh is brought into it */
  fit?: boolean;
  symmetric?: boolean;
  keepConfidence?: boolean;
  /** open what has grown together: vertices along it are doubled */
  cut?: boolean;
  /** the rest pose that the character is put into, cut before */
  toPose?: "t" | "a";
  onProgress?: Progress;
}
export interface RigOptions {
  method?: "auto" | "votes" | "shape" | "regions" | "slots";
  detail?: "body" | "hands" | "full";
  mirror?: "auto" | "always" | "never";
  /** found where it is missing, or as the file's format says */
  up?: "auto" | "y" | "z";
  /** where the mesh faces, in its own axes; found where it is missing */
  front?: "auto" | "plus-z" | "minus-z" | "plus-x" | "minus-x" | "plus-y" | "minus-y";
  spine?: number;
  toes?: boolean;
  ends?: boolean;
  /** false: the skeleton alone */
  bind?: boolean;
  keepLengths?: boolean;
  influences?: number;
  /** what kind of body it is, where the model takes it for another: which limbs are arms, legs, wings */
  category?: "any" | "biped" | "quadruped" | "bird" | "fish" | "snake" | "many-legged";
  /** a bundled skeleton that is put into the mesh: "mixamo", "vrm", "unreal", "rigify", ... */
  template?: string;
  /** the rest pose that the character is put into: arms out, or 45 degrees lower */
  toPose?: "t" | "a";
  /** measure the result: what fails is a note that begins with "gate: " */
  gate?: boolean;
  /** open what has grown together; toPose does so, too */
  cut?: boolean;
  onProgress?: Progress;
}
export interface RetargetOptions {
  method?: "auto" | "copy" | "contacts" | "reference-points" | "stream";
  inPlace?: boolean;
  /** false: knees and elbows may leave their natural range */
  range?: boolean;
  /** true: plays a motion that does not fit, such as a person's on a horse; else an error */
  force?: boolean;
  /** true: bones stretch as the motion's do */
  translations?: boolean;
  targetUp?: "x" | "y" | "z";
  motionUp?: "x" | "y" | "z";
  /** every frame is corrected by morph targets */
  deform?: "linear" | "volume" | "xpbd" | "delta-mush";
  bodyContact?: boolean;
  /** of "xpbd": of its springs, 0.2 where it is missing; where its tetrahedra have weights from; false: bends are not smoothed */
  stiffness?: number;
  tetWeights?: "skin" | "distance";
  smoothing?: boolean;
  shapes?: number;
  fps?: number;
  /** seconds */
  from?: number;
  to?: number;
  /** by name or number; all where it is missing */
  clip?: string | number;
  /** which joints places alone are (.npy, .npz); guessed by their count unless given */
  layout?: "smpl24" | "humanml3d22" | "coco17" | "mediapipe33";
  /** of a file of several people, by the root's name or number */
  actor?: string | number;
  /** what joints stay within: "human", a .urdf or a file of limits; nothing but the natural range where it is missing */
  limits?: string;
  /** bones of a picture's character leave its plane as the motion's do */
  depth?: boolean;
  onProgress?: Progress;
}
export interface PictureOptions {
  /** what kind of body it is; found where it is missing */
  bodyClass?: BodyClass;
  /** of several figures, from left to right, from 1 on; the largest where it is missing */
  figure?: number;
  /** a card instead of a body as thick as it is wide */
  flat?: boolean;
  /** the figure is opened along lines that are drawn into it from its outline, as a guess: a leg before a leg */
  cut?: boolean;
  /** figure: its longest side is 1; pixels: places are the picture's, x right, y up from the bottom edge */
  units?: "figure" | "pixels";
  /** name of a file beside it, a picture that is bright where the figure is; found where it is missing */
  mask?: string;
  /** closed lines round the figure in pixels, x right, y down from the top left corner, in place of what is found */
  outline?: [number, number][][];
}
export type BodyClass = "found" | "biped" | "quadruped" | "bird" | "fish" | "snake" | "many-legged" | "other";
export interface PictureInfo {
  width: number;
  height: number;
  figureCount: number;
  figure: number;
  /** found, front and 0 before rig() */
  bodyClass: BodyClass;
  view: "front" | "faces-right" | "faces-left";
  /** 0..1, of class and view together */
  certainty: number;
  /** closed lines of the figure, x and y by turns, as in PictureOptions: the border, then those of holes and smaller parts */
  outline: Float32Array[];
}
export interface TransferOptions {
  method?: "auto" | "nearest" | "biharmonic" | "rebind";
  influences?: number;
  targetUp?: "x" | "y" | "z";
  sourceUp?: "x" | "y" | "z";
  garment?: boolean;
  heat?: boolean;
  onProgress?: Progress;
}

export interface PlaceOptions {
  /** quarters about the origin, one after the other: "x", "-x", "y", ... */
  turns?: string[];
  /** metres along up */
  height?: number;
  /** the lowest vertex is at 0 along up */
  floor?: boolean;
  /** afterwards, y where it is missing */
  up?: "x" | "y" | "z";
}
export interface ProfileOptions {
  /** files as they were read where it is missing */
  profile?: "mixamo" | "unreal" | "unity" | "vrm" | "vrm0" | "blender" | "godot" | "three" | "maya";
  /** axes, names and roots of the skeleton stay as they are */
  keepAxes?: boolean;
  /** a glTF says in its extras what `controls` says */
  controls?: boolean;
  /** of a VRM, which has one at least */
  authors?: string[];
  /** of a VRM, in the words of its format; nothing is allowed where it is missing */
  licence?: string;
  title?: string;
}
export interface CheckOptions {
  /** false: the mesh is not posed */
  poses?: boolean;
  /** false: animations are not looked at */
  clips?: boolean;
  /** also how near the weights are to those of three methods */
  score?: boolean;
  /** rules that get other bounds than the library's */
  bounds?: Record<string, number>;
}
export interface Finding {
  rule: string;
  severity: "note" | "warning" | "error";
  /** one line each: what is wrong, and what to do */
  what: string;
  cure: string;
  /** in which it shows, "" for none */
  pose: string;
  clip: string;
  seconds: number;
  /** what was measured, and above which it is a finding */
  value: number;
  bound: number;
  /** that it is about, and that it is compared with; -1: none */
  joint: number;
  other: number;
  /** where all its vertices lie in one, or -1 */
  mesh: number;
  vertices: Uint32Array;
  /** where to look, and how far around it, the mesh's units */
  position: [number, number, number];
  radius: number;
}

export interface CharacterArrays {
  name: string;
  mesh: Mesh;
  skeleton: Skeleton;
  /** joint: that a mesh without a skin hangs on, or -1 */
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
  readonly picture: PictureInfo;
  bind(options?: BindOptions): {
    hash: string; seconds: number; symmetricVertices: number; keptMeshes: number; foldedTips: number; seams: number; leftOut: { joint: number; why: string }[];
  };
  /** doubtful: limbs that may be wrong, most doubtful first, and how likely they are */
  rig(options?: RigOptions): {
    mirrored: boolean; matched: number; spread: number; seconds: number; doubtful: { name: string; doubt: number }[];
  };
  retarget(motion: CharacterFile | null, options?: RetargetOptions): {
    clipCount: number; mapped: number; rigged: boolean; shapeCount: number; certainty: number; mappedBy: string;
  };
  transfer(source: CharacterFile, options?: TransferOptions): { carried: number; fitted: boolean; bound: boolean };
  place(options: PlaceOptions): void;
  setProfile(options: ProfileOptions): void;
  /** the text of a .controls.json, see formats/spec/controls.md */
  readonly controls: string;
  /** findings: errors first; line: "checked: 0 findings"; score: 0..100, null where it was not asked for */
  check(options?: CheckOptions): { findings: Finding[]; line: string; score: number | null };
  view(): CharacterArrays;
  /** bytes of a .glb, .vrm, .bvh or .rig.txt */
  save(name: string): Uint8Array;
  /** all files that the command would write, the named one first */
  files(name: string): { name: string; bytes: Uint8Array }[];
  /** of openPlaces(): local rotations [J x 4] and translations [J x 3] in the frame of these places [n x 3] */
  placesFrame(places: ArrayLike<number>): { rotations: Float32Array; translations: Float32Array };
  close(): void;
}

export class CharacterModule {
  private constructor();
  /** places of a person's joints alone, as cameras tell them, as a motion; for placesFrame(). Frames of [n x 3] numbers each */
  openPlaces(layout: "smpl24" | "humanml3d22" | "coco17" | "mediapipe33", frames: ArrayLike<number>[]): CharacterFile;
  open(bytes: ArrayBuffer | ArrayBufferView, name: string, beside?: Record<string, ArrayBuffer | ArrayBufferView>, picture?: PictureOptions): Promise<CharacterFile>;
}

/** wasm, scenes: wasm/character.wasm and, for FBX and COLLADA, wasm/scenes.wasm, where the bundler does not know new URL(). */
export function load(options?: { wasm?: WasmSource; scenes?: WasmSource }): Promise<CharacterModule>;
