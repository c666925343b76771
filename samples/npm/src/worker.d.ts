// SPDX-License-Identifier: MIT
import type {
  BindOptions, Bound, ClipOptions, DeformOptions, JointMap, LoadOptions, MapRig, Mesh, MotionRig, Poses, RetargetOptions, Rig, RigOptions,
  SimplifyOptions, Skeleton, SkinRows, TransferOptions, Transferred,
} from "./index.js";

/** Skin of ./index.d.ts beside the page: the same calls, each a promise. */
export interface RemoteModel {
  readonly task: "weights" | "skeletons" | "hands" | "fronts";
  readonly parameters: number;
  free(): Promise<void>;
}
export interface RemoteDeformer {
  readonly vertexCount: number;
  readonly jointCount: number;
  readonly tetrahedronCount: number;
  pose(palette: Float32Array): Promise<{ positions: Float32Array; corrected: boolean }>;
  free(): Promise<void>;
}
export interface RemoteRetarget {
  readonly map: Int32Array;
  readonly classes: Uint8Array;
  clip(clip: Poses, options?: ClipOptions): Promise<{ rotations: Float32Array; translations: Float32Array; frameCount: number }>;
  free(): Promise<void>;
}
export interface RemoteSkin {
  readonly version: string;
  readonly kernel: "simd128" | "ref";
  model: RemoteModel | null;
  openModel(bytes: ArrayBuffer | ArrayBufferView): Promise<RemoteModel>;
  bind(mesh: Mesh, skeleton: Skeleton, options?: BindOptions<RemoteModel>): Promise<Bound>;
  rig(mesh: Mesh, options?: RigOptions<RemoteModel>): Promise<Rig>;
  map(target: MapRig, source: MapRig, options?: { method?: "auto" | "sinew" | "branches"; pins?: { target: number; source: number }[] }): Promise<JointMap>;
  retarget(source: MotionRig, target: MotionRig, options?: RetargetOptions): Promise<RemoteRetarget>;
  deformer(mesh: Mesh, skeleton: Skeleton, skin: SkinRows, options?: DeformOptions): Promise<RemoteDeformer>;
  pose(positions: Float32Array, skin: SkinRows, palette: Float32Array, options?: { dualQuaternion?: boolean }): Promise<Float32Array>;
  transfer(source: { mesh: Mesh; skeleton: Skeleton; skin: SkinRows }, mesh: Mesh, skeleton: Skeleton, options?: TransferOptions<RemoteModel>): Promise<Transferred>;
  simplify(skeleton: Skeleton, options?: SimplifyOptions): Promise<Uint32Array>;
  chooseJoints(mesh: Mesh, skeleton: Skeleton): Promise<{ flags: Uint8Array; tips: Uint8Array }>;
  jointClasses(skeleton: Skeleton): Promise<{ classes: Uint8Array; ends: Uint8Array }>;
  /** Stops the worker; calls that wait are refused. */
  close(): void | Promise<number>;
}

/** In a worker's script: answers the calls of connect(). */
export function serve(): void;
/** worker: of a browser or of node's worker_threads, whose script calls serve() */
export function connect(worker: object, options?: LoadOptions): Promise<RemoteSkin>;
