// SPDX-License-Identifier: MIT
// Arrays are typed arrays, or plain arrays of numbers, which are copied. V vertices, J joints, N influences a vertex.

type Numbers<T> = T | readonly number[];

/** Triangles in `indices`, or polygons in `faceOffsets` and `faceVertices`, or neither: points alone. */
export interface Mesh {
  /** [V x 3] rest pose, any unit */
  positions: Numbers<Float32Array>;
  /** [3 x triangles] */
  indices?: Numbers<Uint32Array> | Uint16Array;
  /** [faces + 1] where each face's corners begin in faceVertices, and where the last one's end */
  faceOffsets?: Numbers<Uint32Array>;
  faceVertices?: Numbers<Uint32Array>;
}

export interface Skeleton {
  /** [J x 3] rest pose, in the mesh's space */
  positions: Numbers<Float32Array>;
  /** [J] a joint's number, or -1 */
  parents: Numbers<Int32Array>;
  /** [J] names, used to find controls, slots, bone ends, sides, arms and legs */
  names?: readonly string[];
  /** [J] 1: never gets weight; 2: deforms, and joints without a 2 do not */
  flags?: Numbers<Uint8Array>;
}

export interface SkinRows {
  /** [V x N] */
  joints: Numbers<Uint16Array>;
  /** [V x N]: Uint16Array rows sum to 65535, others to 1 */
  weights: Float32Array | Uint16Array | readonly number[];
  /** N; default 4 */
  influenceCount?: number;
}

export type AnswerKind = "proposed" | "rigid" | "soft" | "hard" | "softer" | "host";

/** Answer about the part of a vertex. */
export interface Answer {
  vertex: number;
  kind: AnswerKind;
  /** of "rigid" */
  joint?: number;
  /** for this part only, not for equal parts */
  alone?: boolean;
}

export interface Question {
  /** first vertex of the part, which identifies it in an answer */
  vertex: number;
  partCount: number;
  vertexCount: number;
  joint: number;
  /** 0..1 */
  share: number;
  doubt: number;
  gain: number;
  alternatives: { kind: AnswerKind; joint: number; change: number }[];
}

/** Share of the work done, 0..1. Returning true stops the call with a SinewError of status -8, as in C and Python; no other result does
 * (in a worker none: close() it). */
export type Progress = (share: number) => unknown;

export interface BindOptions<M = Model> {
  model?: M;
  /** "heat" and "distance" need no model */
  method?: "model" | "heat" | "distance";
  /** N, 1..12; 4 */
  influences?: number;
  /** weights as floats of sum 1, or as Uint16Array of sum 65535 */
  format?: "float" | "unorm16";
  upAxis?: "y" | "z";
  /** joints that may get weight: by names and positions, or all that `flags` allow */
  joints?: "names" | "all";
  /** bone ends keep their weight */
  keepTips?: boolean;
  symmetric?: boolean;
  rigidParts?: "auto" | "always" | "never";
  /** softness of the model's weights, 0.25..4; 2: twice as soft */
  softness?: number;
  /** larger meshes are bound on a surface reduced to this many vertices; 32768 */
  surfaceVertices?: number;
  /** [V] not 0: keeps its row of `given` */
  locked?: Numbers<Uint8Array>;
  /** [V] not 0: keeps its row of `given`, which guides its surroundings */
  hints?: Numbers<Uint8Array>;
  /** rows of locked and hinted vertices, N influences each */
  given?: SkinRows;
  answers?: readonly Answer[];
  /** maximum number of questions about parts */
  questions?: number;
  onProgress?: Progress;
}

export interface Bound {
  /** [V x N] by descending weight; unused slots are joint 0 with weight 0 */
  joints: Uint16Array;
  /** [V x N] */
  weights: Float32Array | Uint16Array;
  influenceCount: number;
  vertexCount: number;
  /** [V] 0..255: confidence of the strongest joint */
  confidence: Uint8Array;
  /** with `symmetric`: number of vertices with a mirror image; 0: no mirror plane was found */
  symmetricVertices: number;
  /** joints that were left out */
  leftOut: number[];
  /** in the engine */
  seconds: number;
  workspaceBytes: number;
  questions?: Question[];
  /** [V] index of a question, or -1 */
  vertexQuestions?: Int32Array;
}

export interface RigOptions<M = Model> {
  /** of loadRigModel(); "shape" needs none */
  model?: M;
  /** of loadHandsModel(): with fingers */
  handsModel?: M;
  /** eyes and a jaw, where a head has separate spheres */
  face?: boolean;
  /** a joint for an object in a hand, where it is a separate part */
  props?: boolean;
  /** of loadFrontModel(): finds the front at any angle, and with upAxis "auto" the up axis */
  frontModel?: M;
  method?: "votes" | "shape";
  upAxis?: "y" | "z" | "auto";
  front?: "auto" | "+z" | "-z" | "+x" | "-x" | "+y" | "-y";
  mirror?: "auto" | "always" | "never";
  /** joints between pelvis and neck or head, 1..16 */
  spine?: number;
  toes?: boolean;
  /** bone ends */
  ends?: boolean;
  onProgress?: Progress;
}

export interface Rig extends Skeleton {
  names: string[];
  positions: Float32Array;
  parents: Int32Array;
  flags: Uint8Array;
  /** [J] sinew_joint_class of sinew/rig.h */
  classes: Uint8Array;
  /** [J] mirror image, itself on the plane, or -1 */
  partners: Int32Array;
  /** [J] 0..1 confidence of the joint's position */
  confidence: Float32Array;
  mirrored: boolean;
  facing: number;
  plane: number;
  /** unit vector, the mesh's axes */
  front: number[];
  up: "y" | "z";
  /** 0..1; uncertain below 0.7 */
  frontCertainty: number;
  upCertainty: number;
  /** estimated error: below about 0.03 is good, above 0.09 mostly wrong, above 0.25 the mesh is not a body */
  spread: number;
}

/** A skeleton to map. `up` if known; `ends` [J] 1: only the end of a bone. */
export interface MapRig extends Skeleton {
  up?: "auto" | "x" | "y" | "z";
  ends?: Numbers<Uint8Array>;
}

export interface JointMap {
  /** [target J] joint of the source, or -1 */
  sources: Int32Array;
  /** [target J] 0..1 */
  confidence: Float32Array;
  reasons: string[];
  mapped: number;
  certainty: number;
  method: "sinew" | "branches";
}

export interface MotionRig extends MapRig {
  /** [J x 4] x y z w, rotations of the joints' axes in the world at rest; default: world axes */
  rotations?: Numbers<Float32Array>;
}

export interface RetargetOptions {
  /** [target J] joint of the source, or -1; default: map() */
  map?: Numbers<Int32Array>;
  /** [target J] sinew_joint_class; default: from names, from those of the sources, or from a human body, as in the command */
  classes?: Numbers<Uint8Array>;
  sourceUp?: "auto" | "x" | "y" | "z";
  targetUp?: "auto" | "x" | "y" | "z";
  inPlace?: boolean;
  /** target length per source length */
  scale?: number;
  /** degrees, -90..90, by which both arms are lifted away from the body, or brought nearer if below 0 */
  armSpread?: number;
}

/** Local rotations [frames x J x 4] x y z w and translations [frames x J x 3], in the parents' axes, the world's for roots. */
export interface Poses {
  rotations: Numbers<Float32Array>;
  translations: Numbers<Float32Array>;
}

export interface ClipOptions {
  /** the target's mesh (triangles) with its weights, for contacts of feet */
  body?: Mesh & { skin: SkinRows };
  /** 30 */
  fps?: number;
}

export interface DeformOptions {
  method?: "volume" | "xpbd" | "delta-mush";
  /** lattice cells along the longest side, 8..64; 32 */
  cells?: number;
  /** 1..200; 20 */
  rounds?: number;
  softness?: number;
  twistSpread?: boolean;
  contact?: boolean;
  /** Keep arms out of the torso, thighs out of the belly and of each other. For "volume" only. */
  bodyContact?: boolean;
  smoothing?: boolean;
}

export interface TransferOptions<M = Model> {
  /** for rebinding; default: heat */
  model?: M;
  method?: "auto" | "nearest" | "biharmonic" | "rebind";
  influences?: number;
  format?: "float" | "unorm16";
  upAxis?: "y" | "z";
  sourceUpAxis?: "y" | "z";
  /** the source wears the target: same space, same skeleton */
  garment?: boolean;
  /** [source J] matching joint of the target, or -1; default: map() */
  jointMap?: Numbers<Int32Array>;
  onProgress?: Progress;
}

export interface Transferred {
  joints: Uint16Array;
  weights: Float32Array | Uint16Array;
  influenceCount: number;
  vertexCount: number;
  confidence: Uint8Array;
  /** share of the weights that was transferred; the rest was rebound */
  carried: number;
  parts: { vertex: number; vertexCount: number; reason: string; carried: number }[];
}

export interface SimplifyOptions {
  level?: "high" | "low";
  /** number of joints to keep */
  joints?: number;
  /** [J] share of the surface that moves with the joint */
  areas?: Numbers<Float32Array>;
  /** [J] 1: stays */
  keep?: Numbers<Uint8Array>;
}

/** A call that the engine rejects, or an argument of the wrong shape. */
export class SinewError extends Error {
  /** sinew_status of sinew/types.h; 0: the argument never reached the engine */
  status: number;
}

export class Model {
  private constructor();
  readonly task: "weights" | "skeletons" | "hands" | "fronts";
  readonly parameters: number;
  free(): void;
}

export class Retarget {
  private constructor();
  readonly map: Int32Array;
  /** [target J] sinew_joint_class that was used */
  readonly classes: Uint8Array;
  clip(clip: Poses, options?: ClipOptions): { rotations: Float32Array; translations: Float32Array; frameCount: number };
  free(): void;
}

export interface StreamOptions extends RetargetOptions {
  /** the target's mesh (triangles) with its weights, for contacts of its skin with the floor and hands; default: its joints */
  body?: Mesh & { skin: SkinRows };
  /** the source's mesh, with the same vertices, for contacts of hands with the body */
  sourceBody?: Mesh & { skin: SkinRows };
  /** 30 */
  fps?: number;
  /** height of a standing ankle of the source; default: that at rest */
  ground?: number;
  /** false: no contacts with the floor or the body */
  contacts?: boolean;
  /** false: knees and elbows may leave their natural range */
  range?: boolean;
}

export class RetargetStream {
  private constructor();
  readonly map: Int32Array;
  /** [target J] sinew_joint_class that was used */
  readonly classes: Uint8Array;
  frame(rotations: Numbers<Float32Array>, translations: Numbers<Float32Array>): { rotations: Float32Array; translations: Float32Array };
  restart(): void;
  free(): void;
}

export class Deformer {
  private constructor();
  readonly vertexCount: number;
  readonly jointCount: number;
  readonly tetrahedronCount: number;
  /** palette: [J x 12] row-major 3x4, pose times inverse bind. corrected: false for matrices with shear or unequal scales */
  pose(palette: Numbers<Float32Array>): { positions: Float32Array; corrected: boolean };
  free(): void;
}

export class Skin {
  private constructor();
  readonly version: string;
  readonly kernel: "simd128" | "ref";
  model: Model | null;
  openModel(bytes: ArrayBuffer | ArrayBufferView): Model;
  bind(mesh: Mesh, skeleton: Skeleton, options?: BindOptions): Bound;
  rig(mesh: Mesh, options?: RigOptions): Rig;
  map(target: MapRig, source: MapRig, options?: {
    method?: "auto" | "sinew" | "branches";
    /** for branches only: which skeleton's branches choose, and the cost of two of them */
    branchesFirst?: "both" | "target" | "source";
    branchesCost?: "mean" | "sum";
    pins?: { target: number; source: number }[] }): JointMap;
  retarget(source: MotionRig, target: MotionRig, options?: RetargetOptions): Retarget;
  retargetStream(source: MotionRig, target: MotionRig, options?: StreamOptions): RetargetStream;
  deformer(mesh: Mesh, skeleton: Skeleton, skin: SkinRows, options?: DeformOptions): Deformer;
  pose(positions: Numbers<Float32Array>, skin: SkinRows, palette: Numbers<Float32Array>, options?: { dualQuaternion?: boolean }): Float32Array;
  transfer(source: { mesh: Mesh; skeleton: Skeleton; skin: SkinRows }, mesh: Mesh, skeleton: Skeleton, options?: TransferOptions): Transferred;
  simplify(skeleton: Skeleton, options?: SimplifyOptions): Uint32Array;
  chooseJoints(mesh: Mesh, skeleton: Skeleton): { flags: Uint8Array; tips: Uint8Array };
  jointClasses(skeleton: Skeleton): { classes: Uint8Array; ends: Uint8Array };
}

export interface LoadOptions {
  /** bytes of loadModel(): default model of bind() and transfer() */
  model?: ArrayBuffer | ArrayBufferView;
  /** the module without SIMD, even if SIMD is supported */
  scalar?: boolean;
  /** the module from elsewhere, instead of the copy in the scripts; of a pair the one that runs here, as @sinew/skin/url has it */
  wasm?: WasmSource | { simd: WasmSource; scalar: WasmSource };
}
/** A module, its bytes, or its URL. */
export type WasmSource = WebAssembly.Module | ArrayBuffer | ArrayBufferView | URL | string | Response | Promise<Response>;

export function load(options?: LoadOptions): Promise<Skin>;
export function hasSimd(): boolean;
export function hasExceptions(): boolean;
export function compile(source: WasmSource): Promise<WebAssembly.Module>;
export function instantiate(module: WebAssembly.Module, imports: Record<string, Record<string, Function>>): Promise<WebAssembly.Exports>;
export function decodeBase64(text: string): Uint8Array;

/** For Babylon.js' VertexData; the ...Extra pair if there are more than four influences. */
export function babylonBuffers(bound: { joints: Uint16Array; weights: Float32Array | Uint16Array; influenceCount: number }): {
  matricesIndices: Float32Array;
  matricesWeights: Float32Array;
  matricesIndicesExtra?: Float32Array;
  matricesWeightsExtra?: Float32Array;
  numBoneInfluencers: number;
};
/** For PlayCanvas' SEMANTIC_BLENDINDICES and SEMANTIC_BLENDWEIGHT, four per vertex. */
export function playcanvasBuffers(bound: { joints: Uint16Array; weights: Float32Array | Uint16Array; influenceCount: number }): {
  blendIndices: Uint8Array | Uint16Array;
  blendWeights: Float32Array;
};
