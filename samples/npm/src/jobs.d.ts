// SPDX-License-Identifier: MIT
// Types of options and results of a character's jobs; what is missing is 0, or the first word. Generated from the C headers by scripts/declarations.py; a test compares.
import type { Progress } from "./index.js";
import type { CharacterFile } from "./character.js";

// Tables for marshalling.js: name, kind, member, what the kind needs.
export declare const OPTIONS: Record<string, { struct: any; members: Record<string, any[]> }>;
export declare const RESULTS: Record<string, { struct: any; members: Record<string, any[]> }>;

export interface PictureOptions {
  bodyClass?: "found" | "biped" | "quadruped" | "bird" | "fish" | "snake" | "many-legged" | "other";
  /** of several figures, from left to right, from 1 on; 0: the largest */
  figure?: number;
  /** a card instead of a body as thick as it is wide */
  flat?: boolean;
  /** positions are the picture's pixels, x right, y up from the bottom edge; else the longest side is 1 */
  units?: "figure" | "pixels";
  /** a picture that is bright where the figure is, as a file or the name of one in memory; null: found */
  mask?: string;
  /** the figure as picture_info has it, in place of what is found */
  outline?: [number, number][][];
  /** the figure is opened along lines that are drawn into it from its outline, as a guess */
  cut?: boolean;
}
export interface ProfileOptions {
  /** axes, names and roots of the skeleton stay as they are */
  keepAxes?: boolean;
  /** "mixamo", "vrm": one of profiles(); null = none, files as they were read */
  profile?: string;
  /** of a VRM, in the words of its format; null = nothing is allowed */
  licence?: string;
  /** of a VRM; null = the character's name */
  title?: string;
  /** of a VRM, which has at least one */
  authors?: string[];
  /** a glTF's extras have what controls() says */
  controls?: boolean;
}
export interface TransformOptions {
  /** quarters about the origin, one after the other: "x", "-x", "y", ... */
  turns?: string[];
  /** metres along up; 0 = as it is */
  height?: number;
  /** the lowest vertex is at 0 along up */
  floor?: boolean;
  /** afterwards; auto: Y */
  up?: "auto" | "x" | "y" | "z";
}
export interface BindOptions {
  method?: "model" | "heat" | "distance";
  /** 1..12; 0 = 4 */
  influences?: number;
  /** auto: Y */
  up?: "auto" | "x" | "y" | "z";
  joints?: "auto" | "own" | "names" | "all";
  rigidParts?: "auto" | "always" | "never";
  /** 0.25..4; 0 = 1 */
  softness?: number;
  /** 0 = 32768 */
  surfaceVertices?: number;
  /** joints that only end a chain keep the weight they get */
  keepTips?: boolean;
  /** meshes without a skin are bound too */
  bindProps?: boolean;
  /** a skeleton in other units or beside the mesh is brought into it */
  fit?: boolean;
  /** mirrored vertices get mirrored rows */
  symmetric?: boolean;
  /** a saved .glb has the confidence as _CONFIDENCE */
  keepConfidence?: boolean;
  /** JOINT_NEVER, JOINT_DEFORMS (if any has it, no other deforms) */
  jointFlags?: ArrayLike<number>;
  /** not 0: keeps the weights it has */
  locked?: ArrayLike<number>;
  /** not 0: keeps the weights it has, which steer their surroundings */
  hinted?: ArrayLike<number>;
  /** a bound character whose weights are carried over where they fit */
  like?: CharacterFile;
  /** rest pose of the result: "t", "a", or a file whose skeleton stands so; null = as it stands. Cuts, too */
  toPose?: string;
  /** what has grown together is opened, its vertices doubled; the new ones come last */
  cut?: boolean;
  onProgress?: Progress;
}
export interface RigOptions {
  method?: "auto" | "votes" | "shape" | "regions" | "slots";
  detail?: "body" | "hands" | "full";
  mirror?: "auto" | "always" | "never";
  /** auto: found, or as the file's format says */
  up?: "auto" | "x" | "y" | "z";
  /** 1..16; 0 = as the model says */
  spine?: number;
  /** false: without */
  toes?: boolean;
  /** false: without */
  ends?: boolean;
  /** false: the skeleton alone */
  bind?: boolean;
  /** with a skeleton, its bones are turned and all scaled alike */
  keepLengths?: boolean;
  /** of the bind, and the three below */
  influences?: number;
  rigidParts?: "auto" | "always" | "never";
  softness?: number;
  surfaceVertices?: number;
  /** a file, or template:NAME, that is put into the mesh */
  template?: string;
  /** what kind of body it is; any: as the model says */
  category?: "any" | "biped" | "quadruped" | "bird" | "fish" | "snake" | "many-legged";
  /** auto: found */
  front?: "auto" | "plus-z" | "minus-z" | "plus-x" | "minus-x" | "plus-y" | "minus-y";
  /** the result is measured; what fails is a note that begins with "gate: " */
  gate?: boolean;
  /** what has grown together is opened, as of a bind; to_pose does so, too */
  cut?: boolean;
  /** rest pose of the result: "t", "a", or a file whose skeleton stands so; null = as the mesh stands */
  toPose?: string;
  onProgress?: Progress;
}
export interface RetargetOptions {
  method?: "auto" | "copy" | "contacts" | "reference-points" | "stream";
  /** stays above where it stands at rest */
  inPlace?: boolean;
  /** false: knees and elbows may leave their natural range */
  range?: boolean;
  targetUp?: "auto" | "x" | "y" | "z";
  motionUp?: "auto" | "x" | "y" | "z";
  /** every frame is corrected by morph targets, VOLUME and above */
  deform?: "linear" | "dual-quaternion" | "volume" | "xpbd" | "delta-mush";
  /** of the deformer; 0 = its own */
  cells?: number;
  /** of the deformer; 0 = its own */
  rounds?: number;
  /** with "volume" or "xpbd", limbs keep out of the body */
  bodyContact?: boolean;
  /** most morph targets a clip; 0 = 16 */
  shapes?: number;
  /** 0 = as the motion has */
  fps?: number;
  /** seconds; to 0 = the end */
  from?: number;
  /** seconds; to 0 = the end */
  to?: number;
  /** by name or number; null: all */
  clip?: string | number;
  /** joint of the motion or -1, in place of a map */
  sources?: ArrayLike<number>;
  /** reference points: 1..4, or NO_AREA; 0 = 3 */
  areaPower?: number;
  /** reference points */
  legs?: boolean;
  /** limbs are measured before and after */
  report?: boolean;
  /** reference points; 0 = 0.05, NO_FALLOFF: none */
  falloff?: number;
  /** reference points, as in sinew_reference_options */
  ownLimb?: boolean;
  /** reference points, as in sinew_reference_options */
  head?: boolean;
  /** reference points, as in sinew_reference_options */
  torso?: boolean;
  /** reference points, as in sinew_reference_options */
  sourcePoints?: boolean;
  /** plays a motion that does not fit, such as a person's on a horse; else an error */
  force?: boolean;
  /** bones stretch as the source's do, as in sinew_retarget_options */
  translations?: boolean;
  /** "xpbd": of the springs in the lattice's tetrahedra, 0.001 to 1000; 0 = 0.2 */
  stiffness?: number;
  /** "xpbd": sinew_tet_weights */
  tetWeights?: "skin" | "distance";
  /** false: "xpbd": bends are not smoothed */
  smoothing?: boolean;
  /** which joints places alone are (.npy, .npz): "smpl24", ...; null: guessed by their count */
  layout?: string;
  /** of a file of several people, by the root's name or number; null: the first where all are alike */
  actor?: string | number;
  /** what joints stay within, contacts or not: a .urdf, a file of formats/spec/limits.md, or "human" for what bodies can do; null:
   * nothing but the natural range */
  limits?: string;
  /** bones of a picture's character leave its plane as the motion's do */
  depth?: boolean;
  onProgress?: Progress;
}
export interface TransferOptions {
  method?: "auto" | "nearest" | "biharmonic" | "rebind";
  /** 1..12; 0 = 4 */
  influences?: number;
  /** auto: Y */
  targetUp?: "auto" | "x" | "y" | "z";
  /** auto: Y */
  sourceUp?: "auto" | "x" | "y" | "z";
  /** the target is worn by the source */
  garment?: boolean;
  /** of "biharmonic" */
  asDrawn?: boolean;
  /** binds by heat alone, without a model */
  heat?: boolean;
  /** of the target */
  locked?: ArrayLike<number>;
  onProgress?: Progress;
}
export interface CheckOptions {
  /** false: the mesh is not posed: no tears, lost volume, flips, crossings */
  poses?: boolean;
  /** false: animations are not looked at */
  clips?: boolean;
  /** rules that get other bounds */
  bounds?: Record<string, number>;
  /** the result has a score */
  score?: boolean;
}
export interface PictureInfo {
  /** pixels as the picture is seen */
  width: number;
  /** pixels as the picture is seen */
  height: number;
  /** in the picture */
  figureCount: number;
  /** the one that was taken, from 1 on */
  figure: number;
  /** 0 before it is rigged */
  bodyClass: "found" | "biped" | "quadruped" | "bird" | "fish" | "snake" | "many-legged" | "other";
  /** 0 before it is rigged */
  view: "front" | "faces-right" | "faces-left";
  /** 0..1, of class and view together; 0 before it is rigged */
  certainty: number;
  /** pixels, x right, y down from the top left corner */
  outline: Float32Array[];
}
export interface LeftOut {
  /** "control", "no weight in the file", ... */
  why: string;
  joint: number;
}
export interface Seam {
  /** that most of it lies between */
  joints: [number, number];
  /** its middle */
  position: [number, number, number];
  length: number;
}
export interface BindResult {
  /** with symmetric */
  symmetricVertices: number;
  /** that stayed attached */
  keptMeshes: number;
  /** that gave their weight to their parents */
  foldedTips: number;
  /** that the style file gave */
  answersByStyle: number;
  /** in sinew_bind() */
  seconds: number;
  workspaceBytes: number;
  leftOut: LeftOut[];
  /** of the weights, as `sinew bind --json` has it */
  hash: string;
  /** longest first */
  seams: Seam[];
  /** with cut or to_pose */
  doubledVertices: number;
}
export interface Doubt {
  /** of the joint that the limb is called by: LeftArm, RightUpLeg, Tail */
  name: string;
  /** how likely the limb is wrong, 0..1 */
  doubt: number;
}
export interface RigResult {
  /** the skeleton is its own mirror image */
  mirrored: boolean;
  /** with a skeleton: joints that have a like in the prediction */
  matched: number;
  /** N, of the arrays below */
  jointCount: number;
  /** how far off the votes think they are, see sinew_rig_outputs */
  spread: number;
  /** with a skeleton: how much larger it became */
  scale: number;
  seconds: number;
  bindSeconds: number;
  /** a bone end */
  ends: Uint8Array;
  /** 0..1 */
  confidence: Float32Array;
  /** 0..1 */
  parentConfidence: Float32Array;
  /** the direction that it faces, unit vector */
  front: [number, number, number];
  /** Y or Z */
  up: "auto" | "x" | "y" | "z";
  /** 0..1, see sinew_rig_outputs; below 0.7 a coin toss */
  frontConfidence: number;
  upConfidence: number;
  /** longest first */
  seams: Seam[];
  /** most doubtful first; of votes */
  doubtful: Doubt[];
}
export interface LimbQuality {
  /** of the target: wrist or ankle */
  joint: number;
  /** leg, 0: arm */
  leg: boolean;
  /** of the clip */
  frames: number;
  /** with a depth above 0.006 */
  deepFrames: number;
  /** with a contact */
  contactFrames: number;
  /** elbow or knee is out of its natural range by more than a degree */
  rangeFrames: number;
  /** mean over frames */
  depth: number;
  greatestDepth: number;
  /** mean over contact frames */
  error: number;
  greatestError: number;
}
export interface AnimateResult {
  /** that were added */
  clipCount: number;
  /** index of the first of them, for get_clip() */
  firstClip: number;
  /** joints that move */
  mapped: number;
  /** was a bare mesh */
  rigged: boolean;
  /** morph targets that were added */
  shapeCount: number;
  /** 0..1, of front and sides, and no more than how much of both bodies the map reaches */
  certainty: number;
  /** with report: [clip_count x limb_count] of both below */
  limbCount: number;
  /** with report */
  limbsBefore: LimbQuality[];
  /** with report */
  limbsAfter: LimbQuality[];
  /** "anatomy and names" */
  mappedBy: string;
  /** the map that was used */
  sources: Int32Array;
}
export interface TransferPart {
  /** its vertex of lowest index */
  vertex: number;
  /** of the target */
  vertexCount: number;
  /** of the larger share */
  reason: "asked" | "style" | "mismatch" | "plain" | "near" | "far" | "no-match" | "kept";
  /** How far the source's weights there are from a bind's: sum over joints of the difference, mean over the vertices, 0..131072. 0
   * where nothing was bound. */
  carried: number;
  /** The same between a bind of the target and the source's bind carried over: how far the match is off. */
  style: number;
  /** Mean distance of its vertices from the source as it was laid over the target, longest sides of the target. */
  mismatch: number;
  distance: number;
}
export interface TransferResult {
  /** of the source */
  mappedJoints: number;
  /** the target had no skeleton and has the source's */
  fitted: boolean;
  /** something was bound anew */
  bound: boolean;
  boundBy: "model" | "heat" | "distance";
  /** see sinew_transfer_outputs, as numbers */
  carried: number;
  /** see sinew_transfer_outputs, as numbers */
  style: number;
  /** see sinew_transfer_outputs, as numbers */
  mismatch: number;
  seconds: number;
  mappedBy: string;
  /** by falling size */
  parts: TransferPart[];
}
export interface Finding {
  /** "left-right"; check_rules() lists them */
  rule: string;
  /** one line of English */
  what: string;
  /** what to do, one line */
  cure: string;
  /** test pose in which it shows; "": none */
  pose: string;
  /** animation in which it shows; "": none */
  clip: string | number;
  /** in the clip */
  seconds: number;
  /** what was measured, and above which it is a finding */
  value: number;
  /** what was measured, and above which it is a finding */
  bound: number;
  /** ascending; null where it is about joints or clips */
  vertices: ArrayLike<number>;
  severity: "note" | "warning" | "error";
  /** that it is about, and that it is compared with; -1: none */
  joint: number;
  /** that it is about, and that it is compared with; -1: none */
  other: number;
  /** where all its vertices lie in one; -1: none */
  mesh: number;
  /** where to look, and how far around it, the mesh's units */
  position: [number, number, number];
  radius: number;
}
export interface CheckResult {
  errors: number;
  warnings: number;
  notes: number;
  /** errors first */
  findings: Finding[];
  /** "checked: 0 findings" */
  line: string;
  /** with score: how near the weights are to those of three methods, 0..100; -1 where it was not asked for */
  score: number | null;
}
