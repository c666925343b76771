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
  /** authors of a VRM; null: those of its file, else "unknown" with a note */
  authors?: string[];
  /** a glTF has the text of controls() in its extras */
  controls?: boolean;
}
export interface TransformOptions {
  /** rotations by 90 degrees about an axis through the origin, in order: "x", "-x", "y", ... */
  turns?: string[];
  /** height in meters along up; 0 = unchanged */
  height?: number;
  /** the lowest vertex is moved to 0 along up */
  floor?: boolean;
  /** after the rotations; auto: Y */
  up?: "auto" | "x" | "y" | "z";
}
export interface CheckOptions {
  /** false: no test poses: no tears, lost volume, flips, crossings */
  poses?: boolean;
  /** false: ignores animations */
  clips?: boolean;
  /** computes the score */
  score?: boolean;
  /** rules with other bounds */
  bounds?: Record<string, number>;
}
export interface BindOptions {
  method?: "model" | "heat" | "distance";
  /** 1..12 influences per vertex; 0 = 4 */
  influences?: number;
  /** auto: Y */
  up?: "auto" | "x" | "y" | "z";
  joints?: "auto" | "own" | "names" | "all";
  rigidParts?: "auto" | "always" | "never";
  /** 0.25..4, 2 = twice as soft; 0 = 1 */
  softness?: number;
  /** larger meshes are bound on a surface reduced to this many vertices; 0 = 32768 */
  surfaceVertices?: number;
  /** joints that only end a chain keep their weight */
  keepTips?: boolean;
  /** meshes without a skin are bound too */
  bindProps?: boolean;
  /** scales, rotates and moves a skeleton that has other units or stands beside the mesh */
  fit?: boolean;
  /** mirrored vertices get mirrored weights */
  symmetric?: boolean;
  /** a saved .glb has the confidence as attribute _CONFIDENCE */
  keepConfidence?: boolean;
  /** JOINT_NEVER, JOINT_DEFORMS (if any has it, no other deforms) */
  jointFlags?: ArrayLike<number>;
  /** not 0: the vertex keeps its weights */
  locked?: ArrayLike<number>;
  /** not 0: the vertex keeps its weights, which guide its surroundings */
  hinted?: ArrayLike<number>;
  /** a bound character whose weights are transferred where they fit */
  like?: CharacterFile;
  /** rest pose of the result: "t", "a", or a file with a skeleton in that pose; null = unchanged. Implies cut */
  toPose?: string;
  /** fused parts are cut open; doubled vertices are appended */
  cut?: boolean;
  onProgress?: Progress;
}
export interface RigOptions {
  method?: "auto" | "votes" | "shape" | "regions" | "slots";
  detail?: "body" | "hands" | "full";
  mirror?: "auto" | "always" | "never";
  /** auto: by the file format, else found */
  up?: "auto" | "x" | "y" | "z";
  /** auto: found */
  front?: "auto" | "plus-z" | "minus-z" | "plus-x" | "minus-x" | "plus-y" | "minus-y";
  /** body class; any: as predicted */
  category?: "any" | "biped" | "quadruped" | "bird" | "fish" | "snake" | "many-legged" | "vehicle";
  /** 1..16 spine joints; 0 = as predicted */
  spine?: number;
  /** false: no toe joints */
  toes?: boolean;
  /** false: no NAME_end joints at chain ends */
  ends?: boolean;
  /** false: the skeleton only, without weights */
  bind?: boolean;
  /** with a skeleton, its bones are rotated and all scaled by one factor */
  keepLengths?: boolean;
  /** checks the result; each failure is a note that begins with "gate: " */
  gate?: boolean;
  /** a file, or template:NAME, whose skeleton is fitted into the mesh */
  template?: string;
  /** bind: 1..12 influences per vertex; 0 = 4 */
  influences?: number;
  rigidParts?: "auto" | "always" | "never";
  /** bind: 0.25..4, 2 = twice as soft; 0 = 1 */
  softness?: number;
  /** bind: larger meshes are bound on a surface reduced to this many vertices; 0 = 32768 */
  surfaceVertices?: number;
  /** bind: rest pose of the result: "t", "a", or a file with a skeleton in that pose; null = unchanged. Implies cut */
  toPose?: string;
  /** bind: fused parts are cut open; doubled vertices are appended */
  cut?: boolean;
  onProgress?: Progress;
}
export interface RetargetOptions {
  method?: "auto" | "copy" | "contacts" | "reference-points" | "stream" | "node-offsets";
  /** false: knees and elbows may leave their natural range */
  range?: boolean;
  /** keeps the character above its rest position */
  inPlace?: boolean;
  /** of the character; auto: found */
  targetUp?: "auto" | "x" | "y" | "z";
  /** maximum number of morph targets per clip; 0 = 16 */
  shapes?: number;
  /** measures limbs before and after */
  report?: boolean;
  /** plays a motion that does not fit, such as a person's on a horse; 0: that is an error */
  force?: boolean;
  /** bones stretch like the source's, as in sinew_retarget_options */
  translations?: boolean;
  /** bones of a picture's character may leave the picture plane */
  depth?: boolean;
  /** pairs to keep in a map that is found */
  pins?: { target: number; source: number }[];
  /** joint of the motion or -1, instead of a map */
  sources?: ArrayLike<number>;
  /** rotation limits of joints, for every method: a .urdf, a file of formats/spec/limits.md, or "human"; null: only the natural range
   * of knees and elbows */
  limits?: string;
  /** simulates the character's springs (hair, tails, ears, skirts) in the clips, see springs() */
  springs?: boolean;
  /** degrees, -90..90, by which both arms are lifted away from the body, as in sinew_retarget_options */
  armSpread?: number;
  /** of the motion; auto: found */
  motionUp?: "auto" | "x" | "y" | "z";
  /** layout of keypoints (.npy, .npz): "smpl24", ...; null: chosen by the number of keypoints */
  layout?: string;
  /** actor of a file with several people, by name of the root or number; null: the first, if all have equal skeletons */
  actor?: string | number;
  /** clip by name or number; null: all */
  clip?: string | number;
  /** frames per second; 0 = as in the motion */
  fps?: number;
  /** first second to play */
  from?: number;
  /** last second to play; 0 = the end */
  to?: number;
  /** animate makes morph targets for corrections (VOLUME and above), which bake requires. 0 = none, linear blending or VOLUME,
   * depending on the call */
  deform?: "linear" | "dual-quaternion" | "volume" | "xpbd" | "delta-mush";
  /** lattice cells of the deformer; 0 = its default */
  cells?: number;
  /** iterations of the deformer; 0 = its default */
  rounds?: number;
  /** for VOLUME and XPBD, limbs keep out of the body */
  bodyContact?: boolean;
  /** for "xpbd" */
  tetWeights?: "skin" | "distance";
  /** false: bends are not smoothed, for SINEW_POSE_XPBD */
  smoothing?: boolean;
  /** "xpbd" as published, see sinew/deform.h */
  deformAsDrawn?: boolean;
  /** stiffness of the springs in the lattice's tetrahedra, 0.001 to 1000, for "xpbd"; 0 = 0.2 */
  stiffness?: number;
  /** reference points: n, 1 .. 4, or NO_AREA for 0; 0 = 3 */
  areaPower?: number;
  /** reference points: triangles of the limb itself have influence too */
  ownLimb?: boolean;
  /** reference points: also corrects knees and ankles */
  legs?: boolean;
  /** reference points: d: influence also falls by exp(-(distance / (d * source's height))^2); 0 = 0.05 (added by sinew) */
  falloff?: number;
  /** reference points: also corrects the head */
  head?: boolean;
  /** reference points: copies directions between torso joints; 0: copies their rotations */
  torso?: boolean;
  /** reference points: reference points of the source's body, scaled to the target; 0: of the target's body */
  sourcePoints?: boolean;
  /** reference points: as published: one sum over all triangles, including the limb's own; knees, ankles, head and torso too; the
   * source's reference points; no falloff, no push-out. own_limb to source_points are ignored */
  asDrawn?: boolean;
  onProgress?: Progress;
}
export interface TransferOptions {
  method?: "auto" | "nearest" | "biharmonic" | "rebind";
  /** 1..12 influences per vertex; 0 = 4 */
  influences?: number;
  /** auto: Y */
  targetUp?: "auto" | "x" | "y" | "z";
  /** auto: Y */
  sourceUp?: "auto" | "x" | "y" | "z";
  /** the source wears the target */
  garment?: boolean;
  /** "biharmonic" as published */
  asDrawn?: boolean;
  /** binds by heat only, without a model */
  heat?: boolean;
  /** not 0: the target's vertex keeps its weights */
  locked?: ArrayLike<number>;
  onProgress?: Progress;
}
export interface SpringsOptions {
  /** finds springs anew instead of the file's own */
  replace?: boolean;
  /** chains to keep despite a low probability, or in addition to the file's own */
  take?: string[];
  /** chains to leave out */
  drop?: string[];
  /** NAME=KIND: parameters of another kind, hair, long-hair, skirt, tail, ear, cape, bust or ribbon */
  presets?: string[];
  /** NAME:FIELD=X sets a parameter of a chain's joints, NAME:FIELD=xF scales it by F: stiffness, gravity, drag, radius or limit */
  values?: string[];
  /** makes chains of joints in skirts, coats and capes that have none, and binds these to them */
  make?: boolean;
}
export interface PictureOptions {
  bodyClass?: "found" | "biped" | "quadruped" | "bird" | "fish" | "snake" | "many-legged" | "other";
  /** number of the figure, from left to right, starting at 1; 0: the largest */
  figure?: number;
  /** a flat card instead of a body as thick as it is wide */
  flat?: boolean;
  /** positions in pixels, x right, y up from the bottom edge; 0: the longest side is 1 */
  units?: "figure" | "pixels";
  /** mask of the figure, bright inside: a file, or the name of one in memory; null: found */
  mask?: string;
  /** outline of the figure as in picture_info; null: found */
  outline?: [number, number][][];
  /** cuts the figure along lines drawn into it from its outline */
  cut?: boolean;
}
export interface Finding {
  /** "left-right"; check_rules() lists them */
  rule: string;
  /** one line of English */
  what: string;
  /** one line: the remedy */
  cure: string;
  /** test pose in which it shows; "": none */
  pose: string;
  /** animation in which it shows; "": none */
  clip: string | number;
  /** time in the clip */
  seconds: number;
  /** measured value */
  value: number;
  /** the value above which it is a finding */
  bound: number;
  /** ascending; null for a finding about joints or clips */
  vertices: ArrayLike<number>;
  severity: "note" | "warning" | "error";
  /** joint of the finding; -1: none */
  joint: number;
  /** joint for comparison; -1: none */
  other: number;
  /** mesh of all its vertices; -1: none, or several */
  mesh: number;
  /** position of the finding, in the mesh's units */
  position: [number, number, number];
  /** radius of the finding around the position */
  radius: number;
}
export interface CheckResult {
  /** number of findings of each severity */
  errors: number;
  warnings: number;
  notes: number;
  /** errors first */
  findings: Finding[];
  /** "checked: 0 findings" */
  line: string;
  /** 0..100, similarity of the weights to those of three methods; -1 if not requested */
  score: number | null;
}
export interface LeftOut {
  /** reason: "control", "no weight in the file", .. */
  why: string;
  joint: number;
}
export interface Seam {
  /** the joints on its two sides */
  joints: [number, number];
  /** its center */
  position: [number, number, number];
  length: number;
}
export interface BindResult {
  /** with symmetric: number of vertices with a mirror image */
  symmetricVertices: number;
  /** number of meshes that stay attached to one joint */
  keptMeshes: number;
  /** number of joints that gave their weight to their parents */
  foldedTips: number;
  /** number of answers from the style file */
  answersByStyle: number;
  /** duration of sinew_bind() */
  seconds: number;
  workspaceBytes: number;
  /** joints that must not get weight */
  leftOut: LeftOut[];
  /** hash of the weights, as in `sinew bind --json` */
  hash: string;
  /** longest first */
  seams: Seam[];
  /** with cut or to_pose: number of doubled vertices */
  doubledVertices: number;
}
export interface Doubt {
  /** joint that names the limb: LeftArm, RightUpLeg, Tail */
  name: string;
  /** probability that the limb is wrong, 0..1 */
  doubt: number;
}
export interface RigResult {
  /** the skeleton is symmetric */
  mirrored: boolean;
  /** with a skeleton: number of its joints that match the prediction */
  matched: number;
  /** N: number of joints of the arrays below */
  jointCount: number;
  /** estimated error of the votes, see sinew_rig_outputs */
  spread: number;
  /** with a skeleton: its scale factor */
  scale: number;
  seconds: number;
  bindSeconds: number;
  /** a bone end */
  ends: Uint8Array;
  /** confidence of positions, 0..1 */
  confidence: Float32Array;
  /** confidence of parents, 0..1 */
  parentConfidence: Float32Array;
  /** unit vector of the front direction */
  front: [number, number, number];
  /** Y or Z */
  up: "auto" | "x" | "y" | "z";
  /** 0..1, see sinew_rig_outputs; uncertain below 0.7 */
  frontConfidence: number;
  upConfidence: number;
  /** longest first */
  seams: Seam[];
  /** limbs by descending doubt; for votes */
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
  /** with elbow or knee out of its natural range by more than a degree */
  rangeFrames: number;
  /** mean over frames */
  depth: number;
  greatestDepth: number;
  /** mean over contact frames */
  error: number;
  greatestError: number;
}
export interface AnimateResult {
  /** number of clips that were added */
  clipCount: number;
  /** index of the first of them, for get_clip() */
  firstClip: number;
  /** number of joints with a source */
  mapped: number;
  /** a bare mesh was rigged first */
  rigged: boolean;
  /** number of morph targets that were added */
  shapeCount: number;
  /** 0..1, certainty of front and sides, at most the share of both bodies that is mapped */
  certainty: number;
  /** with report: number of limbs in both arrays below */
  limbCount: number;
  /** with report */
  limbsBefore: LimbQuality[];
  /** with report */
  limbsAfter: LimbQuality[];
  /** how the map was found: "anatomy and names", .. */
  mappedBy: string;
  /** the map that was used: joint of the motion, -1 = none */
  sources: Int32Array;
  reasons: Uint8Array;
  /** a bone end, which does not rotate */
  sourceEnds: Uint8Array;
  /** names of the joints of the motion, one per line */
  sourceNames: string;
  spotKinds: Uint8Array;
  /** positions, see sinew_contact_spot */
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
  /** share of its weights that was transferred, 65536 = all; the rest was rebound */
  carried: number;
  /** difference between the source's weights there and a bind: sum over joints, mean over the vertices, 0..131072. 0 if nothing was
   * bound */
  style: number;
  /** the same between a bind of the target and the transferred bind of the source: the match error */
  mismatch: number;
  /** mean distance of its vertices from the aligned source, in longest sides of the target */
  distance: number;
}
export interface TransferResult {
  /** number of source joints that were mapped */
  mappedJoints: number;
  /** the target had no skeleton and got the source's */
  fitted: boolean;
  /** a part was rebound */
  bound: boolean;
  boundBy: "model" | "heat" | "distance";
  /** as in sinew_transfer_outputs; so are style and mismatch */
  carried: number;
  style: number;
  mismatch: number;
  seconds: number;
  mappedBy: string;
  /** by descending size */
  parts: TransferPart[];
}
export interface SpringsResult {
  /** number of chains that are kept */
  chainCount: number;
  /** number of joints that swing */
  jointCount: number;
  /** number of spheres and capsules that push them */
  colliderCount: number;
  /** number of the file's own chains, which come first */
  ownCount: number;
  /** kept */
  kept: Uint8Array;
  /** 0..1 */
  certainties: Float32Array;
  /** names of the proposals, one per line */
  names: string;
  /** kinds of the proposals, one per line */
  kinds: string;
}
export interface PictureInfo {
  /** pixels of the picture as displayed */
  width: number;
  height: number;
  /** number of figures in the picture */
  figureCount: number;
  /** the figure that was taken, starting at 1 */
  figure: number;
  /** 0 before it is rigged */
  bodyClass: "found" | "biped" | "quadruped" | "bird" | "fish" | "snake" | "many-legged" | "other";
  /** 0 before it is rigged */
  view: "front" | "faces-right" | "faces-left";
  /** 0..1, certainty of class and view together; 0 before it is rigged */
  certainty: number;
  /** pixels, x right, y down from the top left corner */
  outline: Float32Array[];
}
