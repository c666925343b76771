// SPDX-License-Identifier: MIT
// Types of options and results of a character's jobs; what is missing is 0, or the first word. Generated from the C headers by scripts/declarations.py; a test compares.
import type { Progress } from "./index.js";
import type { CharacterFile } from "./character.js";

// Tables for marshalling.js: name, kind, member, what the kind needs.
export declare const OPTIONS: Record<string, { struct: any; inner?: any; members: Record<string, any[]> }>;
export declare const RESULTS: Record<string, { struct: any; inner?: any; members: Record<string, any[]> }>;

export interface ProfileOptions {
  /** axes, names and roots of the skeleton stay as they are */
  keepAxes?: boolean;
  /** one of profiles(): "mixamo", "vrm"; null = none, files as they were read */
  profile?: string;
  /** license of a VRM, in the words of its format; null = nothing is allowed */
  license?: string;
  /** title of a VRM; null = the character's name */
  title?: string;
  /** authors of a VRM; null: those of its file, else "unknown", which a note says */
  authors?: string[];
  /** a glTF has the text of controls() in its extras */
  controls?: boolean;
}
export interface TransformOptions {
  /** quarter turns about the origin, one after the other: "x", "-x", "y", ... */
  turns?: string[];
  /** height in meters along up; 0 = unchanged */
  height?: number;
  /** the lowest vertex is moved to 0 along up */
  floor?: boolean;
  /** after the turns; auto: Y */
  up?: "auto" | "x" | "y" | "z";
}
export interface CheckOptions {
  /** false: the mesh is not posed: no tears, lost volume, flips, crossings */
  poses?: boolean;
  /** false: animations are not looked at */
  clips?: boolean;
  /** the result has a score */
  score?: boolean;
  /** rules that get other bounds */
  bounds?: Record<string, number>;
}
export interface BindOptions {
  method?: "model" | "heat" | "distance";
  /** 1..12 influences a vertex; 0 = 4 */
  influences?: number;
  /** auto: Y */
  up?: "auto" | "x" | "y" | "z";
  joints?: "auto" | "own" | "names" | "all";
  rigidParts?: "auto" | "always" | "never";
  /** 0.25..4, 2 blends twice as softly; 0 = 1 */
  softness?: number;
  /** a mesh of more vertices is bound on a surface reduced to so many; 0 = 32768 */
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
  /** auto: found */
  front?: "auto" | "plus-z" | "minus-z" | "plus-x" | "minus-x" | "plus-y" | "minus-y";
  /** what kind of body it is; any: as the model says */
  category?: "any" | "biped" | "quadruped" | "bird" | "fish" | "snake" | "many-legged" | "vehicle";
  /** 1..16; 0 = as the model says */
  spine?: number;
  /** false: feet have no toe joints */
  toes?: boolean;
  /** false: chains have no NAME_end joints */
  ends?: boolean;
  /** false: the skeleton alone, without weights */
  bind?: boolean;
  /** with a skeleton, its bones are turned and all scaled alike */
  keepLengths?: boolean;
  /** the result is measured; what fails is a note that begins with "gate: " */
  gate?: boolean;
  /** a file, or template:NAME, that is put into the mesh */
  template?: string;
  /** of the bind: 1..12 influences a vertex; 0 = 4 */
  influences?: number;
  rigidParts?: "auto" | "always" | "never";
  /** of the bind: 0.25..4, 2 blends twice as softly; 0 = 1 */
  softness?: number;
  /** of the bind: a mesh of more vertices is bound on a surface reduced to so many; 0 = 32768 */
  surfaceVertices?: number;
  /** of the bind: rest pose of the result: "t", "a", or a file whose skeleton stands so; null = as it stands. Cuts, too */
  toPose?: string;
  /** of the bind: what has grown together is opened, its vertices doubled; the new ones come last */
  cut?: boolean;
  onProgress?: Progress;
}
export interface RetargetOptions {
  method?: "auto" | "copy" | "contacts" | "reference-points" | "stream" | "node-offsets";
  /** false: knees and elbows may leave their natural range */
  range?: boolean;
  /** stays above where it stands at rest */
  inPlace?: boolean;
  /** of the character; auto: found */
  targetUp?: "auto" | "x" | "y" | "z";
  /** most morph targets a clip; 0 = 16 */
  shapes?: number;
  /** limbs are measured before and after */
  report?: boolean;
  /** plays a motion that does not fit, such as a person's on a horse; else an error */
  force?: boolean;
  /** bones stretch as the source's do, as in sinew_retarget_options */
  translations?: boolean;
  /** bones of a picture's character leave its plane as the motion's do */
  depth?: boolean;
  /** pairs that a found map keeps */
  pins?: { target: number; source: number }[];
  /** joint of the motion or -1, in place of a map */
  sources?: ArrayLike<number>;
  /** what joints stay within, contacts or not: a .urdf, a file of formats/spec/limits.md, or "human" for what bodies can do; null: the
   * natural range alone */
  limits?: string;
  /** hair, tails, ears and skirts swing in the clips, by the springs of the character, see springs() */
  springs?: boolean;
  /** of the motion; auto: found */
  motionUp?: "auto" | "x" | "y" | "z";
  /** layout of keypoints (.npy, .npz): "smpl24", ...; null: guessed by their count */
  layout?: string;
  /** of a file of several people, by the root's name or number; null: the first where all are alike */
  actor?: string | number;
  /** by name or number; null: all */
  clip?: string | number;
  /** frames a second; 0 = as the motion has */
  fps?: number;
  /** first second that is played */
  from?: number;
  /** last second that is played; 0 = the end */
  to?: number;
  /** animate makes morph targets of corrections, VOLUME and above; bake takes no other. 0 = none, linear blending or VOLUME, as the
   * call says */
  deform?: "linear" | "dual-quaternion" | "volume" | "xpbd" | "delta-mush";
  /** of the deformer; 0 = its own */
  cells?: number;
  /** of the deformer; 0 = its own */
  rounds?: number;
  /** with VOLUME or XPBD, limbs keep out of the body */
  bodyContact?: boolean;
  /** of "xpbd" */
  tetWeights?: "skin" | "distance";
  /** false: bends are not smoothed, of SINEW_POSE_XPBD */
  smoothing?: boolean;
  /** "xpbd" as published, see sinew/deform.h */
  deformAsDrawn?: boolean;
  /** of "xpbd": of the springs in the lattice's tetrahedra, 0.001 to 1000; 0 = 0.2 */
  stiffness?: number;
  /** reference points: n, 1 .. 4, or NO_AREA for 0; 0 = 3 */
  areaPower?: number;
  /** reference points: triangles of the limb itself have influence as well */
  ownLimb?: boolean;
  /** reference points: knees and ankles move as well */
  legs?: boolean;
  /** reference points: d: influence also falls by exp(-(distance / (d * source's height))^2); 0 = 0.05, which is ours */
  falloff?: number;
  /** reference points: the head moves as well */
  head?: boolean;
  /** reference points: torso joints lie as the source's do, each seen from the one before; 0: they turn as copied */
  torso?: boolean;
  /** reference points: reference points are the source's, in the size of the target; 0: the target's */
  sourcePoints?: boolean;
  /** reference points: as published: one sum over all triangles, the limb's own too; knees, ankles, head and torso as well; the
   * source's reference points; no falloff, no push-out. own_limb to source_points say nothing then */
  asDrawn?: boolean;
  onProgress?: Progress;
}
export interface TransferOptions {
  method?: "auto" | "nearest" | "biharmonic" | "rebind";
  /** 1..12 influences a vertex; 0 = 4 */
  influences?: number;
  /** auto: Y */
  targetUp?: "auto" | "x" | "y" | "z";
  /** auto: Y */
  sourceUp?: "auto" | "x" | "y" | "z";
  /** the target is worn by the source */
  garment?: boolean;
  /** as its paper says, of "biharmonic" */
  asDrawn?: boolean;
  /** binds by heat alone, without a model */
  heat?: boolean;
  /** not 0: the target's vertex keeps the weights it has */
  locked?: ArrayLike<number>;
  onProgress?: Progress;
}
export interface SpringsOptions {
  /** finds springs anew in place of the file's own */
  replace?: boolean;
  /** chains that are kept although they are not sure, or beside the file's own */
  take?: string[];
  /** chains that are left out */
  drop?: string[];
  /** NAME=KIND: numbers of another kind, hair, long-hair, skirt, tail, ear, cape, bust or ribbon */
  presets?: string[];
  /** NAME:FIELD=X, one number of a chain's joints, or NAME:FIELD=xF, F times what each has: stiffness, gravity, drag, radius or limit
   * */
  values?: string[];
  /** chains of joints are laid into skirts, coats and capes that have none, and these are bound to them */
  make?: boolean;
}
export interface PictureOptions {
  bodyClass?: "found" | "biped" | "quadruped" | "bird" | "fish" | "snake" | "many-legged" | "other";
  /** which of several figures, from left to right, from 1 on; 0: the largest */
  figure?: number;
  /** a flat card instead of a body as thick as it is wide */
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
export interface Finding {
  /** "left-right"; check_rules() lists them */
  rule: string;
  /** one line of English */
  what: string;
  /** one line: what to do */
  cure: string;
  /** test pose in which it shows; "": none */
  pose: string;
  /** animation in which it shows; "": none */
  clip: string | number;
  /** time in the clip */
  seconds: number;
  /** what was measured */
  value: number;
  /** the value above which it is a finding */
  bound: number;
  /** ascending; null where it is about joints or clips */
  vertices: ArrayLike<number>;
  severity: "note" | "warning" | "error";
  /** joint that it is about; -1: none */
  joint: number;
  /** joint that it is compared with; -1: none */
  other: number;
  /** mesh of all its vertices; -1: none, or several */
  mesh: number;
  /** where to look, in the mesh's units */
  position: [number, number, number];
  /** how far around the position to look */
  radius: number;
}
export interface CheckResult {
  /** findings of each severity */
  errors: number;
  warnings: number;
  notes: number;
  /** errors first */
  findings: Finding[];
  /** "checked: 0 findings" */
  line: string;
  /** 0..100, how near the weights are to those of three methods; -1 where it was not asked for */
  score: number | null;
}
export interface LeftOut {
  /** "control", "no weight in the file", .. */
  why: string;
  joint: number;
}
export interface Seam {
  /** the joints that most of it lies between */
  joints: [number, number];
  /** its middle */
  position: [number, number, number];
  length: number;
}
export interface BindResult {
  /** with symmetric: vertices that have a mirror image */
  symmetricVertices: number;
  /** meshes that stay attached to one joint */
  keptMeshes: number;
  /** joints that gave their weight to their parents */
  foldedTips: number;
  /** answers by the style file */
  answersByStyle: number;
  /** in sinew_bind() */
  seconds: number;
  workspaceBytes: number;
  /** joints that may get no weight */
  leftOut: LeftOut[];
  /** of the weights, as in `sinew bind --json` */
  hash: string;
  /** longest first */
  seams: Seam[];
  /** with cut or to_pose */
  doubledVertices: number;
}
export interface Doubt {
  /** joint that the limb is called by: LeftArm, RightUpLeg, Tail */
  name: string;
  /** probability that the limb is wrong, 0..1 */
  doubt: number;
}
export interface RigResult {
  /** the skeleton is its own mirror image */
  mirrored: boolean;
  /** with a skeleton: its joints that have a counterpart in the prediction */
  matched: number;
  /** N: joints of the arrays below */
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
  /** unit vector in which the mesh faces */
  front: [number, number, number];
  /** Y or Z */
  up: "auto" | "x" | "y" | "z";
  /** 0..1, see sinew_rig_outputs; below 0.7 a coin toss */
  frontConfidence: number;
  upConfidence: number;
  /** longest first */
  seams: Seam[];
  /** limbs by falling doubt; of votes */
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
  /** clips that were added */
  clipCount: number;
  /** index of the first of them, for get_clip() */
  firstClip: number;
  /** joints that move */
  mapped: number;
  /** it was a bare mesh */
  rigged: boolean;
  /** morph targets that were added */
  shapeCount: number;
  /** 0..1, of front and sides, and no more than how much of both bodies the map reaches */
  certainty: number;
  /** with report: limbs in both arrays below */
  limbCount: number;
  /** with report */
  limbsBefore: LimbQuality[];
  /** with report */
  limbsAfter: LimbQuality[];
  /** "anatomy and names" */
  mappedBy: string;
  /** the map that was used: joint of the motion, -1 = none */
  sources: Int32Array;
  reasons: Uint8Array;
  /** a mere end, which never turns */
  sourceEnds: Uint8Array;
  /** joints of the motion, a line each, '\n' between two */
  sourceNames: string;
  spotKinds: Uint8Array;
  /** see sinew_contact_spot, as the errors */
  spotPositions: Float32Array;
  spotErrors: Float32Array;
}
export interface TransferPart {
  /** its vertex of lowest index */
  vertex: number;
  /** of the target */
  vertexCount: number;
  /** of the larger share */
  reason: "asked" | "style" | "mismatch" | "plain" | "near" | "far" | "no-match" | "kept";
  /** share of its weights that was carried over, 65536 = all; the rest was bound anew */
  carried: number;
  /** how far the source's weights there are from a bind's: sum over joints of the difference, mean over the vertices, 0..131072. 0
   * where nothing was bound */
  style: number;
  /** the same between a bind of the target and the source's bind carried over: how far the match is off */
  mismatch: number;
  /** mean distance of its vertices from the source as it was laid over the target, longest sides of the target */
  distance: number;
}
export interface TransferResult {
  /** joints of the source */
  mappedJoints: number;
  /** the target had no skeleton and has the source's */
  fitted: boolean;
  /** something was bound anew */
  bound: boolean;
  boundBy: "model" | "heat" | "distance";
  /** as in sinew_transfer_outputs, and the two below */
  carried: number;
  style: number;
  mismatch: number;
  seconds: number;
  mappedBy: string;
  /** by falling size */
  parts: TransferPart[];
}
export interface SpringsResult {
  /** chains that are kept */
  chainCount: number;
  /** joints that swing */
  jointCount: number;
  /** spheres and capsules that push them */
  colliderCount: number;
  /** the first of these are the file's own */
  ownCount: number;
  /** kept */
  kept: Uint8Array;
  /** 0..1 */
  certainties: Float32Array;
  /** names of the proposals, a line each, '\n' between two */
  names: string;
  /** kinds of the proposals, a line each, '\n' between two */
  kinds: string;
}
export interface PictureInfo {
  /** pixels, of the picture as it is seen */
  width: number;
  height: number;
  /** figures in the picture */
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
