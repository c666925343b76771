/* SPDX-License-Identifier: MIT
 * The jobs of the command `sinew`: include sinew/character.h, which describes what all calls share. */
#ifndef SINEW_CHARACTER_JOBS_H
#define SINEW_CHARACTER_JOBS_H

#include "sinew/character_file.h"
#include "sinew/published.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Bytes of .sinew files, borrowed for the duration of a call, instead of the bundled models; null members = bundled. */
typedef struct sinew_character_models {
  uint32_t struct_size;
  uint32_t reserved;
  /* Model of skin weights. */
  const void* bind;
  size_t bind_size;
  /* Model of skeletons. */
  const void* rig;
  size_t rig_size;
  /* Model of fingers. */
  const void* hands;
  size_t hands_size;
  /* Model of SINEW_CHARACTER_RIG_SLOTS. */
  const void* slots;
  size_t slots_size;
  /* Model of the front direction. */
  const void* front;
  size_t front_size;
} sinew_character_models;

/* ---- bind ---- */

/* Joints that may get weight. */
typedef enum sinew_joints_from {
  SINEW_JOINTS_AUTO = 0,  /* OWN for a character with weights for its own skeleton, else NAMES */
  SINEW_JOINTS_OWN = 1,   /* per mesh, joints that already have weight there */
  SINEW_JOINTS_NAMES = 2, /* all but controls, slots, roots and joints beside the mesh */
  SINEW_JOINTS_ALL = 3
} sinew_joints_from;

/* `sinew bind` */
typedef struct sinew_character_bind_options {
  uint32_t struct_size;
  uint32_t thread_count;
  sinew_progress progress;
  void* progress_user;
  const sinew_character_models* models;
  /* sinew_method */
  uint32_t method;
  /* 1..12 influences per vertex; 0 = 4. */
  uint32_t influence_count;
  /* sinew_up; 0 = Y. */
  uint32_t up;
  /* sinew_joints_from */
  uint32_t joints;
  /* sinew_rigid_parts */
  uint32_t rigid_parts;
  /* 25..400, 200 = twice as soft; 0 = 100. */
  uint32_t softness_percent;
  /* Larger meshes are bound on a surface reduced to this many vertices; 0 = 32768. */
  uint32_t surface_vertices;
  /* 1: joints that only end a chain keep their weight. */
  uint32_t keep_tips;
  /* 1: meshes without a skin are bound too. */
  uint32_t bind_props;
  /* 1: scales, rotates and moves a skeleton that has other units or stands beside the mesh. */
  uint32_t fit;
  /* 1: mirrored vertices get mirrored weights. */
  uint32_t symmetric;
  /* 1: a saved .glb has the confidence as attribute _CONFIDENCE. */
  uint32_t keep_confidence;
  /* Maximum number of questions about parts. */
  uint32_t question_count;
  uint32_t answer_count;
  /* [answer_count] or null. */
  const sinew_answer* answers;
  /* [J] SINEW_JOINT_NEVER, SINEW_JOINT_DEFORMS (if any has it, no other deforms); or null. */
  const uint8_t* joint_flags;
  /* [V] not 0: the vertex keeps its weights; or null. */
  const uint8_t* locked;
  /* [V] not 0: the vertex keeps its weights, which guide its surroundings; or null. */
  const uint8_t* hinted;
  /* Weights of some vertices of the same mesh, joints by name, instead of hinted; or null. */
  const sinew_character* hints;
  /* A bound character whose weights are transferred where they fit; or null. */
  const sinew_character* like;
  /* A .style file with answers about similar parts; or null. */
  const char* style;
  /* Rest pose of the result: "t", "a", or a file with a skeleton in that pose; null = unchanged. Implies cut. */
  const char* to_pose;
  /* 1: fused parts are cut open; doubled vertices are appended. */
  uint32_t cut;
  uint32_t reserved;
} sinew_character_bind_options;

/* A seam: a line along which two separate parts of the body are fused. No weight crosses it. */
typedef struct sinew_character_seam {
  /* The joints on its two sides. */
  uint32_t joints[2];
  /* Its center. */
  float position[3];
  float length;
} sinew_character_seam;

/* A joint that must not get weight. */
typedef struct sinew_character_left_out {
  /* Reason: "control", "no weight in the file", ... */
  const char* why;
  uint32_t joint;
  uint32_t reserved;
} sinew_character_left_out;

typedef struct sinew_character_bind_result {
  uint32_t struct_size;
  /* With symmetric: number of vertices with a mirror image. */
  uint32_t symmetric_vertices;
  /* Number of meshes that stay attached to one joint. */
  uint32_t kept_meshes;
  /* Number of joints that gave their weight to their parents. */
  uint32_t folded_tips;
  uint32_t left_out_count;
  uint32_t question_count;
  /* Number of answers from the style file. */
  uint32_t answers_by_style;
  uint32_t seam_count;
  /* Duration of sinew_bind(). */
  double seconds;
  size_t workspace_bytes;
  /* [left_out_count] Joints that must not get weight. */
  const sinew_character_left_out* left_out;
  /* [question_count] By descending gain. */
  const sinew_question* questions;
  /* [V] Question of each vertex before a cut, or SINEW_NO_QUESTION; null without questions. */
  const uint32_t* vertex_questions;
  /* Hash of the weights, as in `sinew bind --json`. */
  const char* hash;
  /* [seam_count] Longest first. */
  const sinew_character_seam* seams;
  /* With cut or to_pose: number of doubled vertices. */
  uint32_t doubled_vertices;
  uint32_t reserved;
} sinew_character_bind_result;

/* Gives the mesh weights for its skeleton. A mesh without a skeleton is SINEW_ERROR_INPUT. */
SINEW_API sinew_status sinew_character_bind(sinew_character* character, const sinew_character_bind_options* options,
                                            sinew_character_bind_result* result);

/* ---- rig ---- */

typedef enum sinew_character_rig_method {
  SINEW_CHARACTER_RIG_AUTO = 0,    /* votes, or shape if the mesh is unlike the training data */
  SINEW_CHARACTER_RIG_VOTES = 1,   /* predicted by the model */
  SINEW_CHARACTER_RIG_SHAPE = 2,   /* along the medial axis of the mesh */
  SINEW_CHARACTER_RIG_REGIONS = 3, /* as published, for comparison */
  SINEW_CHARACTER_RIG_SLOTS = 4    /* by two networks, as published, for comparison */
} sinew_character_rig_method;

typedef enum sinew_character_detail {
  SINEW_CHARACTER_DETAIL_BODY = 0,  /* down to the hands */
  SINEW_CHARACTER_DETAIL_HANDS = 1, /* with fingers, where the mesh has them */
  SINEW_CHARACTER_DETAIL_FULL = 2   /* also with eyes, a jaw and props */
} sinew_character_detail;

typedef enum sinew_edit_kind {
  SINEW_EDIT_MOVE = 0,   /* joint to position */
  SINEW_EDIT_ADD = 1,    /* joint below other, at position */
  SINEW_EDIT_REMOVE = 2, /* joint */
  SINEW_EDIT_PARENT = 3, /* joint below other */
  SINEW_EDIT_RENAME = 4, /* joint to other */
  SINEW_EDIT_AT = 5      /* like MOVE; a joint that was not found is added, such as LeftHand with its arm */
} sinew_edit_kind;

/* An edit of a predicted skeleton before binding; on both sides if it is symmetric. */
typedef struct sinew_skeleton_edit {
  /* sinew_edit_kind */
  uint32_t kind;
  uint32_t reserved;
  /* Name of the joint; for ADD, of the new joint. */
  const char* joint;
  /* Parent for ADD and PARENT, new name for RENAME; else null. */
  const char* other;
  /* Position for MOVE, ADD and AT, in the mesh's units. */
  float position[3];
  uint32_t reserved2;
} sinew_skeleton_edit;

/* `sinew rig` */
typedef struct sinew_character_rig_options {
  uint32_t struct_size;
  uint32_t thread_count;
  sinew_progress progress;
  void* progress_user;
  const sinew_character_models* models;
  /* Bind: influence_count, rigid_parts, softness_percent, surface_vertices, cut and to_pose; others
   * are ignored. Null = defaults. */
  const sinew_character_bind_options* bind;
  /* sinew_character_rig_method */
  uint32_t method;
  /* sinew_character_detail */
  uint32_t detail;
  /* sinew_mirror */
  uint32_t mirror;
  /* sinew_up; 0 = by the file format, else found. */
  uint32_t up;
  /* sinew_front; 0 = found. */
  uint32_t front;
  /* sinew_category: body class; 0 = as predicted. */
  uint32_t category;
  /* 1..16 spine joints; 0 = as predicted. */
  uint32_t spine_count;
  /* Bits of sinew_without.
   *   SINEW_WITHOUT_TOES  no toe joints
   *   SINEW_WITHOUT_ENDS  no NAME_end joints at chain ends
   *   SINEW_WITHOUT_BIND  the skeleton only, without weights */
  uint32_t without;
  /* 1: with a skeleton, its bones are rotated and all scaled by one factor. */
  uint32_t keep_lengths;
  /* 1: checks the result; each failure is a note that begins with "gate: ". */
  uint32_t gate;
  uint32_t reserved;
  uint32_t edit_count;
  /* [edit_count] Edits of the skeleton, in order. */
  const sinew_skeleton_edit* edits;
  /* A file, or template:NAME, whose skeleton is fitted into the mesh; or null. */
  const char* skeleton;
  /* A character whose skeleton is fitted into the mesh; or null. */
  const sinew_character* skeleton_character;
} sinew_character_rig_options;

/* A limb that may be wrong. */
typedef struct sinew_character_doubt {
  /* Joint that names the limb: LeftArm, RightUpLeg, Tail. */
  const char* name;
  /* Probability that the limb is wrong, 0..1. */
  float doubt;
  uint32_t reserved;
} sinew_character_doubt;

typedef struct sinew_character_rig_result {
  uint32_t struct_size;
  /* 1: the skeleton is symmetric. */
  uint32_t mirrored;
  /* With a skeleton: number of its joints that match the prediction. */
  uint32_t matched;
  /* N: number of joints of the arrays below. */
  uint32_t joint_count;
  /* Estimated error of the votes, see sinew_rig_outputs. */
  float spread;
  float reserved;
  /* With a skeleton: its scale factor. */
  double scale;
  double seconds;
  double bind_seconds;
  /* [N] 1: a bone end. */
  const uint8_t* ends;
  /* [N] Confidence of positions, 0..1. */
  const float* confidence;
  /* [N] Confidence of parents, 0..1. */
  const float* parent_confidence;
  /* Unit vector of the front direction. */
  float front[3];
  /* sinew_up: Y or Z. */
  uint32_t up;
  /* 0..1, see sinew_rig_outputs; uncertain below 0.7. */
  float front_confidence;
  float up_confidence;
  uint32_t seam_count;
  /* [seam_count] Longest first. */
  const sinew_character_seam* seams;
  uint32_t doubtful_count;
  /* [doubtful_count] Limbs by descending doubt; for votes. */
  const sinew_character_doubt* doubtful;
} sinew_character_rig_result;

/* Makes a skeleton for a mesh and binds the mesh to it. It replaces the character's skeleton. */
SINEW_API sinew_status sinew_character_rig(sinew_character* character, const sinew_character_rig_options* options,
                                           sinew_character_rig_result* result);

/* Returns the names of the built-in skeletons for template:NAME, separated by spaces. Static. */
SINEW_API const char* sinew_character_templates(void);

/* ---- map ---- */

/* Selects a motion of a file or character, and how it is read. */
typedef struct sinew_motion_source {
  uint32_t struct_size;
  /* sinew_up of the motion; 0 = found. */
  uint32_t up;
  /* A file instead of the call's character, which is then null; for sinew_character_map() also template:NAME. */
  const char* file;
  /* Layout of keypoints (.npy, .npz): "smpl24", ...; null: chosen by the number of keypoints. */
  const char* layout;
  /* Actor of a file with several people, by name of the root or number; null: the first, if all have equal skeletons. */
  const char* actor;
  /* Clip by name or number; null: all. */
  const char* clip;
  /* Frames per second; 0 = as in the motion. */
  double fps;
  /* First second to play. */
  double from;
  /* Last second to play; 0 = the end. */
  double to;
} sinew_motion_source;

/* `sinew map` */
typedef struct sinew_character_map_options {
  uint32_t struct_size;
  /* sinew_map_method */
  uint32_t method;
  /* Bits of sinew_without.
   *   SINEW_WITHOUT_NAMES  ignores joint names
   *   SINEW_WITHOUT_ENDS   ignores bone ends */
  uint32_t without;
  /* sinew_up; 0 = along the legs of a body with two legs, else Y. */
  uint32_t target_up;
  /* 1: guesses the up axis, as with target_up 0. */
  uint32_t guess_up;
  uint32_t pin_count;
  /* [pin_count] Pairs to keep; or null. */
  const sinew_map_pin* pins;
  /* A map file whose pairs are kept; or null. */
  const char* pins_file;
  /* sinew_branches_first: of SINEW_MAP_BRANCHES. */
  uint32_t branches_first;
  /* sinew_branches_cost: of SINEW_MAP_BRANCHES. */
  uint32_t branches_cost;
  /* Uses file, layout, actor and up (0 = the target's, Y for a template); null = defaults. */
  const sinew_motion_source* source;
} sinew_character_map_options;

typedef struct sinew_character_map_result {
  uint32_t struct_size;
  /* sinew_map_method that was used. */
  uint32_t method;
  /* J: number of joints of the target. */
  uint32_t joint_count;
  /* Number of joints with a source. */
  uint32_t mapped;
  /* 0..1, certainty of front, sides and torso. */
  float certainty;
  /* 0..1, share of both bodies that is mapped; below 0.5 sinew_character_animate() rejects it. */
  float cover;
  double seconds;
  /* [J] Joint of the source, -1 = none. */
  const int32_t* sources;
  /* [J] 0..1 */
  const float* confidence;
  /* [J] sinew_map_reason */
  const uint8_t* reasons;
  /* The map as `sinew map -o` writes it. */
  const char* text;
} sinew_character_map_result;

/* Finds the source joint of each target joint. Changes neither character; the result belongs to the target. The
 * source is read as in sinew_character_animate(): if its rest pose is not a standing pose, one is guessed from its
 * frames. Animated nodes without skin are counted after its joints.
 *   source  null if options->source has a file
 *   result  not null */
SINEW_API sinew_status sinew_character_map(sinew_character* target, const sinew_character* source,
                                           const sinew_character_map_options* options,
                                           sinew_character_map_result* result);

/* ---- animate ---- */

typedef enum sinew_animate_method {
  SINEW_ANIMATE_AUTO = 0, /* contacts */
  SINEW_ANIMATE_COPY = 1, /* each joint rotates like its source */
  SINEW_ANIMATE_CONTACTS = 2,
  SINEW_ANIMATE_REFERENCE_POINTS = 3, /* the published method, for comparison */
  SINEW_ANIMATE_STREAM = 4,           /* each frame from past frames only, see sinew/motion_stream.h */
  SINEW_ANIMATE_NODE_OFFSETS = 5      /* the published alignment of nodes, for comparison */
} sinew_animate_method;

typedef enum sinew_pose_deform {
  SINEW_POSE_LINEAR = 0, /* linear blend skinning */
  SINEW_POSE_DUAL_QUATERNION = 1,
  SINEW_POSE_VOLUME = 2, /* bends keep their volume without self-intersection */
  SINEW_POSE_XPBD = 3,   /* the published correction */
  SINEW_POSE_DELTA_MUSH = 4
} sinew_pose_deform;

/* Deformation of a posed mesh. */
typedef struct sinew_character_deformation {
  uint32_t struct_size;
  /* sinew_pose_deform: animate makes morph targets for corrections (VOLUME and above), which bake requires. 0 = none,
   * linear blending or VOLUME, depending on the call. */
  uint32_t method;
  /* Lattice cells of the deformer; 0 = its default. */
  uint32_t cells;
  /* Iterations of the deformer; 0 = its default. */
  uint32_t rounds;
  /* 1: for VOLUME and XPBD, limbs keep out of the body. */
  uint32_t body_contact;
  /* sinew_tet_weights, for SINEW_POSE_XPBD. */
  uint32_t tet_weights;
  /* Bits of sinew_without.
   *   SINEW_WITHOUT_SMOOTHING  bends are not smoothed, for SINEW_POSE_XPBD */
  uint32_t without;
  /* 1: SINEW_POSE_XPBD as published, see sinew/deform.h. */
  uint32_t deform_as_drawn;
  /* Stiffness of the springs in the lattice's tetrahedra, 0.001 to 1000, for SINEW_POSE_XPBD; 0 = 0.2. */
  double stiffness;
} sinew_character_deformation;

/* `sinew animate` */
typedef struct sinew_character_animate_options {
  uint32_t struct_size;
  uint32_t thread_count;
  sinew_progress progress;
  void* progress_user;
  /* Models for a bare mesh, which is rigged first. */
  const sinew_character_models* models;
  /* The played part of the motion; null = all of it. */
  const sinew_motion_source* motion;
  /* Corrections of the posed mesh; null = none. */
  const sinew_character_deformation* deform;
  /* Reference points: area_power, own_limb, legs, falloff, head, torso, source_points and as_drawn, for
   * SINEW_ANIMATE_REFERENCE_POINTS; null = defaults. */
  const sinew_reference_options* reference;
  /* sinew_animate_method */
  uint32_t method;
  /* Bits of sinew_without.
   *   SINEW_WITHOUT_RANGE  knees and elbows may leave their natural range */
  uint32_t without;
  /* 1: keeps the character above its rest position. */
  uint32_t in_place;
  /* sinew_up of the character; 0 = found. */
  uint32_t target_up;
  /* Maximum number of morph targets per clip; 0 = 16. */
  uint32_t shapes;
  /* 1: measures limbs before and after. */
  uint32_t report;
  /* 1: plays a motion that does not fit, such as a person's on a horse; 0: that is an error. */
  uint32_t force;
  /* 1: bones stretch like the source's, as in sinew_retarget_options. */
  uint32_t translations;
  /* 1: bones of a picture's character may leave the picture plane. */
  uint32_t depth;
  uint32_t pin_count;
  /* [pin_count] Pairs to keep in a map that is found; or null. */
  const sinew_map_pin* pins;
  /* A map file; null: found. */
  const char* map;
  /* [J] Joint of the motion or -1, instead of a map; or null. */
  const int32_t* sources;
  /* Rotation limits of joints, for every method: a .urdf, a file of formats/spec/limits.md, or "human"; null: only
   * the natural range of knees and elbows. */
  const char* limits;
  /* 1: simulates the character's springs (hair, tails, ears, skirts) in the clips, see sinew_character_springs(). */
  uint32_t springs;
  /* Degrees, -90..90, by which both arms are lifted away from the body, as in sinew_retarget_options. */
  float arm_spread;
} sinew_character_animate_options;

typedef struct sinew_character_animate_result {
  uint32_t struct_size;
  /* Number of clips that were added. */
  uint32_t clip_count;
  /* Index of the first of them, for sinew_character_get_clip(). */
  uint32_t first_clip;
  /* Number of joints with a source. */
  uint32_t mapped;
  /* 1: a bare mesh was rigged first. */
  uint32_t rigged;
  /* Number of morph targets that were added. */
  uint32_t shape_count;
  /* 0..1, certainty of front and sides, at most the share of both bodies that is mapped. */
  float certainty;
  /* With report: number of limbs in both arrays below. */
  uint32_t limb_count;
  /* [clip_count x limb_count] With report; or null. */
  const sinew_limb_quality* limbs_before;
  /* [clip_count x limb_count] With report; or null. */
  const sinew_limb_quality* limbs_after;
  /* How the map was found: "anatomy and names", ... */
  const char* mapped_by;
  /* [J] The map that was used: joint of the motion, -1 = none. */
  const int32_t* sources;
  /* [J] sinew_map_reason */
  const uint8_t* reasons;
  /* [source_count] 1: a bone end, which does not rotate. */
  const uint8_t* source_ends;
  /* Names of the joints of the motion, one per line. */
  const char* source_names;
  uint32_t source_count;
  /* With report: limb_count spots per frame, clip after clip. */
  uint32_t spot_count;
  /* [spot_count] sinew_spot_kind */
  const uint8_t* spot_kinds;
  /* [spot_count x 3] Positions, see sinew_contact_spot. */
  const float* spot_positions;
  /* [spot_count] */
  const float* spot_errors;
} sinew_character_animate_result;

/* Adds clips of another skeleton to a bound character, which are saved with it. A bare mesh is rigged first.
 *   motion  null: options->motion has a file, or the character of a picture plays a bundled clip of its class */
SINEW_API sinew_status sinew_character_animate(sinew_character* character, sinew_character* motion,
                                               const sinew_character_animate_options* options,
                                               sinew_character_animate_result* result);

/* ---- pose ---- */

/* `sinew pose`: one of angles, rotations, matrices and clip gives the pose. */
typedef struct sinew_character_pose_options {
  uint32_t struct_size;
  uint32_t thread_count;
  /* Deformation of the mesh; null = linear blend skinning. */
  const sinew_character_deformation* deform;
  /* [J x 3] Degrees about x, then y, then z. */
  const double* angles;
  /* [J x 4] x y z w, local, relative to the rest pose. */
  const double* rotations;
  /* [J x 12] Row-major 3x4, rest to posed space. */
  const double* matrices;
  /* Clip of the character, by name or number. */
  const char* clip;
  /* Time in the clip, in seconds. */
  double time;
} sinew_character_pose_options;

/* Makes a copy of a bound character in a pose, to be saved as .obj or viewed.
 *   posed  out, closed by sinew_character_close(); untouched on failure */
SINEW_API sinew_status sinew_character_pose(sinew_character* character, const sinew_character_pose_options* options,
                                            sinew_character** posed);

/* ---- transfer ---- */

/* `sinew transfer` */
typedef struct sinew_character_transfer_options {
  uint32_t struct_size;
  uint32_t thread_count;
  sinew_progress progress;
  void* progress_user;
  const sinew_character_models* models;
  /* sinew_transfer_method */
  uint32_t method;
  /* 1..12 influences per vertex; 0 = 4. */
  uint32_t influence_count;
  /* sinew_up; 0 = Y. */
  uint32_t target_up;
  /* sinew_up; 0 = Y. */
  uint32_t source_up;
  /* 1: the source wears the target. */
  uint32_t garment;
  /* 1: SINEW_TRANSFER_BIHARMONIC as published. */
  uint32_t as_drawn;
  /* 1: binds by heat only, without a model. */
  uint32_t heat;
  uint32_t pair_count;
  /* [pair_count] Reference points of SINEW_TRANSFER_BIHARMONIC; or null. */
  const sinew_vertex_pair* pairs;
  /* [V] not 0: the target's vertex keeps its weights; or null. */
  const uint8_t* locked;
  /* A map file; null: found. */
  const char* map;
} sinew_character_transfer_options;

typedef struct sinew_character_transfer_result {
  uint32_t struct_size;
  /* Number of source joints that were mapped. */
  uint32_t mapped_joints;
  /* 1: the target had no skeleton and got the source's. */
  uint32_t fitted;
  /* 1: a part was rebound. */
  uint32_t bound;
  /* sinew_method */
  uint32_t bound_by;
  uint32_t part_count;
  /* As in sinew_transfer_outputs; so are style and mismatch. */
  double carried;
  double style;
  double mismatch;
  double seconds;
  const char* mapped_by;
  /* [part_count] By descending size. */
  const sinew_transfer_part* parts;
} sinew_character_transfer_result;

/* Transfers the weights of a bound character to the target's mesh. A target without a skeleton gets the source's,
 * fitted. */
SINEW_API sinew_status sinew_character_transfer(const sinew_character* source, sinew_character* target,
                                                const sinew_character_transfer_options* options,
                                                sinew_character_transfer_result* result);

/* ---- simplify, lod ---- */

/* `sinew simplify` */
typedef struct sinew_character_simplify_options {
  uint32_t struct_size;
  /* 1: also removes fingers and small parts; 0: bone ends, helpers, faces, twists. */
  uint32_t low;
  /* Number of joints to keep; 0 = by the level. */
  uint32_t joint_count;
  uint32_t keep_count;
  /* [keep_count] Joints to keep; or null. */
  const char* const* keep;
  /* 1: removes joints by the published conditions only; see sinew/simplify.h. */
  uint32_t as_drawn;
  uint32_t reserved;
} sinew_character_simplify_options;

/* Removes joints; weights and the file's animations follow. The body stays at both levels; at the high one vertices
 * move by less than 1 % of the height in these animations.
 *   into  out [J before] index before the call of the joint that each was merged into; or null */
SINEW_API sinew_status sinew_character_simplify(sinew_character* character,
                                                const sinew_character_simplify_options* options, uint32_t* into);

#define SINEW_MAX_LOD_LEVELS 8

/* `sinew lod` */
typedef struct sinew_character_lod_options {
  uint32_t struct_size;
  /* Number of levels, 1..SINEW_MAX_LOD_LEVELS; 0 = 3. */
  uint32_t level_count;
  /* Triangles of a level as a share of the level before, 0.05..0.95; 0 = 0.5. */
  double ratio;
  /* 1: reduces joints: level 2 as sinew_character_simplify(), later ones as its low level. */
  uint32_t fewer_joints;
  uint32_t reserved;
} sinew_character_lod_options;

/* Error of a level relative to the whole character, in shares of its height. */
typedef struct sinew_character_lod_level {
  /* Largest distance of a vertex from the level's surface. */
  double rest_error;
  /* The same in the worst test pose. */
  double posed_error;
  /* The mean in that pose. */
  double mean_error;
  uint32_t triangle_count;
  uint32_t reserved;
} sinew_character_lod_level;

/* Makes copies of a bound character with fewer and fewer triangles; weights, shapes, seams and materials are kept. A
 * character with clips or morph targets added by a call is SINEW_ERROR_INPUT: save and open it first.
 *   levels   out [level_count, or 3 if it is 0], each closed by sinew_character_close(); untouched on failure
 *   figures  out, the same count; or null */
SINEW_API sinew_status sinew_character_lod(sinew_character* character, const sinew_character_lod_options* options,
                                           sinew_character** levels, sinew_character_lod_level* figures);

/* ---- springs ---- */

/* `sinew springs`: a chain has the name of its first joint; NAME* selects all chains whose names begin with NAME. */
typedef struct sinew_character_springs_options {
  uint32_t struct_size;
  /* 1: finds springs anew instead of the file's own. */
  uint32_t replace;
  uint32_t take_count;
  uint32_t drop_count;
  uint32_t preset_count;
  uint32_t value_count;
  /* [take_count] Chains to keep despite a low probability, or in addition to the file's own; or null. */
  const char* const* take;
  /* [drop_count] Chains to leave out; or null. */
  const char* const* drop;
  /* [preset_count] NAME=KIND: parameters of another kind, hair, long-hair, skirt, tail, ear, cape, bust or ribbon; or
   * null. */
  const char* const* presets;
  /* [value_count] NAME:FIELD=X sets a parameter of a chain's joints, NAME:FIELD=xF scales it by F: stiffness,
   * gravity, drag, radius or limit; or null. */
  const char* const* values;
  /* 1: makes chains of joints in skirts, coats and capes that have none, and binds these to them. */
  uint32_t make;
  uint32_t reserved;
} sinew_character_springs_options;

typedef struct sinew_character_springs_result {
  uint32_t struct_size;
  /* Number of chains that are kept. */
  uint32_t chain_count;
  /* Number of joints that swing. */
  uint32_t joint_count;
  /* Number of spheres and capsules that push them. */
  uint32_t collider_count;
  /* Number of proposed chains, kept or not. */
  uint32_t proposal_count;
  /* Number of the file's own chains, which come first. */
  uint32_t own_count;
  /* [proposal_count] 1: kept. */
  const uint8_t* kept;
  /* [proposal_count] 0..1 */
  const float* certainties;
  /* Names of the proposals, one per line. */
  const char* names;
  /* Kinds of the proposals, one per line. */
  const char* kinds;
} sinew_character_springs_result;

/* Finds hair, tails, ears and skirts that swing on a bound character, with colliders. The springs are saved with it
 * (VRMC_springBone) and simulated by sinew_character_animate(). */
SINEW_API sinew_status sinew_character_springs(sinew_character* character,
                                               const sinew_character_springs_options* options,
                                               sinew_character_springs_result* result);

/* Moves the joints that swing behind the next frame of a motion, for motion that arrives frame by frame: sinew_retarget_stream_frame(),
 * sinew_character_keypoints_frame() or an editor's own. The springs are those of sinew_character_springs() or, where it was not called, those
 * that it would keep. The first frame shows the pose as it is; see sinew_springs_frame() for gaps, jumps and time steps.
 *   seconds        since the frame before, 0 or more; ignored in the first frame
 *   rotations      [J x 4] x y z w, local, in the joints' order of sinew_character_view()
 *   translations   [J x 3] in the parents' axes
 *   out_rotations  [J x 4] the pose with the chains' joints rotated; may be `rotations`; untouched on failure
 * One thread at a time. Returns SINEW_OK, SINEW_ERROR_INPUT where nothing swings, or SINEW_ERROR_ARGUMENT. */
SINEW_API sinew_status sinew_character_springs_frame(sinew_character* character, float seconds, const float* rotations,
                                                     const float* translations, float* out_rotations);
/* Forgets all motion: the next frame of sinew_character_springs_frame() is the first. */
SINEW_API sinew_status sinew_character_springs_restart(sinew_character* character);

/* ---- bake ---- */

/* `sinew bake` */
typedef struct sinew_character_bake_options {
  uint32_t struct_size;
  uint32_t reserved;
  sinew_progress progress;
  void* progress_user;
  /* The correction; null = SINEW_POSE_VOLUME. */
  const sinew_character_deformation* deform;
  /* Number of training poses; 0 = 1500. */
  uint32_t poses;
  /* Maximum number of driving weights per bend, each with one or two morph targets; 0 = 8. */
  uint32_t shapes;
  /* Seed of the random poses; 0 = 1. */
  uint64_t seed;
  /* Maximum angle in degrees; 0 = 60. */
  double limit;
  /* Clip of the character to train on; null: random poses. */
  const char* clip;
  /* Threshold for leaving out displacements of vertices: root mean square over the poses as a share of the size; 0 =
   * 0.002. */
  double error;
} sinew_character_bake_options;

typedef struct sinew_character_bake_result {
  uint32_t struct_size;
  uint32_t shape_count;
  uint32_t bend_count;
  uint32_t moved_vertices;
  uint32_t learnt_poses;
  uint32_t held_out_poses;
  /* Error in the training poses as a share of the size, with linear skinning; the next member with the shapes. */
  double linear_error;
  double baked_error;
  /* The same in other poses. */
  double held_out_linear_error;
  double held_out_baked_error;
} sinew_character_bake_result;

/* Adds morph targets that correct bends, with their drivers, which are saved with the character. */
SINEW_API sinew_status sinew_character_bake(sinew_character* character, const sinew_character_bake_options* options,
                                            sinew_character_bake_result* result);

#ifdef __cplusplus
}
#endif
#endif
