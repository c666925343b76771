/* SPDX-License-Identifier: MIT
 * The command's jobs: include sinew/character.h, which says what all calls share. */
#ifndef SINEW_CHARACTER_JOBS_H
#define SINEW_CHARACTER_JOBS_H

#include "sinew/character_file.h"
#include "sinew/published.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Bytes of .sinew files, borrowed for the time of a call, in place of the bundled models; null members = bundled. */
typedef struct sinew_character_models {
  uint32_t struct_size;
  uint32_t reserved;
  /* Predicts weights. */
  const void* bind;
  size_t bind_size;
  /* Predicts skeletons. */
  const void* rig;
  size_t rig_size;
  /* Predicts fingers. */
  const void* hands;
  size_t hands_size;
  /* Predicts skeletons by SINEW_CHARACTER_RIG_SLOTS. */
  const void* slots;
  size_t slots_size;
  /* Predicts where a mesh faces. */
  const void* front;
  size_t front_size;
} sinew_character_models;

/* ---- bind ---- */

/* Which joints may get weight. */
typedef enum sinew_joints_from {
  SINEW_JOINTS_AUTO = 0,  /* OWN for a character with weights for its own skeleton, else NAMES */
  SINEW_JOINTS_OWN = 1,   /* mesh by mesh, those that have weight there already */
  SINEW_JOINTS_NAMES = 2, /* not controls, slots, roots and what stands beside the mesh */
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
  /* 1..12 influences a vertex; 0 = 4. */
  uint32_t influence_count;
  /* sinew_up; 0 = Y. */
  uint32_t up;
  /* sinew_joints_from */
  uint32_t joints;
  /* sinew_rigid_parts */
  uint32_t rigid_parts;
  /* 25..400, 200 blends twice as softly; 0 = 100. */
  uint32_t softness_percent;
  /* A mesh of more vertices is bound on a surface reduced to so many; 0 = 32768. */
  uint32_t surface_vertices;
  /* 1: joints that only end a chain keep the weight they get. */
  uint32_t keep_tips;
  /* 1: meshes without a skin are bound too. */
  uint32_t bind_props;
  /* 1: a skeleton in other units or beside the mesh is brought into it. */
  uint32_t fit;
  /* 1: mirrored vertices get mirrored rows. */
  uint32_t symmetric;
  /* 1: a saved .glb has the confidence as _CONFIDENCE. */
  uint32_t keep_confidence;
  /* Lists at most so many parts that are worth a question. */
  uint32_t question_count;
  uint32_t answer_count;
  /* [answer_count] or null. */
  const sinew_answer* answers;
  /* [J] SINEW_JOINT_NEVER, SINEW_JOINT_DEFORMS (if any has it, no other deforms); or null. */
  const uint8_t* joint_flags;
  /* [V] not 0: keeps the weights it has; or null. */
  const uint8_t* locked;
  /* [V] not 0: keeps the weights it has, which steer their surroundings; or null. */
  const uint8_t* hinted;
  /* Weights of some vertices of the same mesh, joints by name, in place of hinted; or null. */
  const sinew_character* hints;
  /* A bound character whose weights are carried over where they fit; or null. */
  const sinew_character* like;
  /* A .style file that answers what it knows; or null. */
  const char* style;
  /* Rest pose of the result: "t", "a", or a file whose skeleton stands so; null = as it stands. Cuts, too. */
  const char* to_pose;
  /* 1: what has grown together is opened, its vertices doubled; the new ones come last. */
  uint32_t cut;
  uint32_t reserved;
} sinew_character_bind_options;

/* A line along which two parts of the body that move apart have grown together. No weight crosses it. */
typedef struct sinew_character_seam {
  /* The joints that most of it lies between. */
  uint32_t joints[2];
  /* Its middle. */
  float position[3];
  float length;
} sinew_character_seam;

/* A joint that may get no weight. */
typedef struct sinew_character_left_out {
  /* "control", "no weight in the file", ... */
  const char* why;
  uint32_t joint;
  uint32_t reserved;
} sinew_character_left_out;

typedef struct sinew_character_bind_result {
  uint32_t struct_size;
  /* With symmetric: vertices that have a mirror image. */
  uint32_t symmetric_vertices;
  /* Meshes that stay attached to one joint. */
  uint32_t kept_meshes;
  /* Joints that gave their weight to their parents. */
  uint32_t folded_tips;
  uint32_t left_out_count;
  uint32_t question_count;
  /* Answers by the style file. */
  uint32_t answers_by_style;
  uint32_t seam_count;
  /* In sinew_bind(). */
  double seconds;
  size_t workspace_bytes;
  /* [left_out_count] Joints that may get no weight. */
  const sinew_character_left_out* left_out;
  /* [question_count] By falling gain. */
  const sinew_question* questions;
  /* [V] Before a cut, or SINEW_NO_QUESTION; null without questions. */
  const uint32_t* vertex_questions;
  /* Of the weights, as in `sinew bind --json`. */
  const char* hash;
  /* [seam_count] Longest first. */
  const sinew_character_seam* seams;
  /* With cut or to_pose. */
  uint32_t doubled_vertices;
  uint32_t reserved;
} sinew_character_bind_result;

/* Gives the mesh weights for its skeleton. A mesh without a skeleton is SINEW_ERROR_INPUT. */
SINEW_API sinew_status sinew_character_bind(sinew_character* character, const sinew_character_bind_options* options,
                                            sinew_character_bind_result* result);

/* ---- rig ---- */

typedef enum sinew_character_rig_method {
  SINEW_CHARACTER_RIG_AUTO = 0,    /* votes, or shape where the votes know nothing */
  SINEW_CHARACTER_RIG_VOTES = 1,   /* by the model */
  SINEW_CHARACTER_RIG_SHAPE = 2,   /* along the middle line of the mesh */
  SINEW_CHARACTER_RIG_REGIONS = 3, /* as published, for comparison */
  SINEW_CHARACTER_RIG_SLOTS = 4    /* by the two networks of another publication, for comparison */
} sinew_character_rig_method;

typedef enum sinew_character_detail {
  SINEW_CHARACTER_DETAIL_BODY = 0,  /* down to the hands */
  SINEW_CHARACTER_DETAIL_HANDS = 1, /* with fingers, where the mesh shows some */
  SINEW_CHARACTER_DETAIL_FULL = 2   /* with eyes, a jaw and props, too */
} sinew_character_detail;

typedef enum sinew_edit_kind {
  SINEW_EDIT_MOVE = 0,   /* joint to position */
  SINEW_EDIT_ADD = 1,    /* joint below other, at position */
  SINEW_EDIT_REMOVE = 2, /* joint */
  SINEW_EDIT_PARENT = 3, /* joint below other */
  SINEW_EDIT_RENAME = 4, /* joint to other */
  SINEW_EDIT_AT = 5      /* as MOVE; a joint that was not found is added, as LeftHand with its arm */
} sinew_edit_kind;

/* A change of a predicted skeleton, before the mesh is bound to it; to both sides where it is symmetric. */
typedef struct sinew_skeleton_edit {
  /* sinew_edit_kind */
  uint32_t kind;
  uint32_t reserved;
  /* The joint's name; of ADD, the new joint's. */
  const char* joint;
  /* The parent of ADD and PARENT, the new name of RENAME; else null. */
  const char* other;
  /* Where MOVE, ADD and AT put the joint, in the mesh's units. */
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
  /* Of the bind: influence_count, rigid_parts, softness_percent, surface_vertices, cut and to_pose; all else is ignored. Null =
   * defaults. */
  const sinew_character_bind_options* bind;
  /* sinew_character_rig_method */
  uint32_t method;
  /* sinew_character_detail */
  uint32_t detail;
  /* sinew_mirror */
  uint32_t mirror;
  /* sinew_up; 0 = found, or as the file's format says. */
  uint32_t up;
  /* sinew_front; 0 = found. */
  uint32_t front;
  /* sinew_category: what kind of body it is; 0 = as the model says. */
  uint32_t category;
  /* 1..16; 0 = as the model says. */
  uint32_t spine_count;
  /* Bits of sinew_without.
   *   SINEW_WITHOUT_TOES  feet have no toe joints
   *   SINEW_WITHOUT_ENDS  chains have no NAME_end joints
   *   SINEW_WITHOUT_BIND  the skeleton alone, without weights */
  uint32_t without;
  /* 1: with a skeleton, its bones are turned and all scaled alike. */
  uint32_t keep_lengths;
  /* 1: the result is measured; what fails is a note that begins with "gate: ". */
  uint32_t gate;
  uint32_t reserved;
  uint32_t edit_count;
  /* [edit_count] Changes of the skeleton. */
  const sinew_skeleton_edit* edits;
  /* A file, or template:NAME, that is put into the mesh; or null. */
  const char* skeleton;
  /* A character whose skeleton is put into the mesh; or null. */
  const sinew_character* skeleton_character;
} sinew_character_rig_options;

/* A limb that may be wrong. */
typedef struct sinew_character_doubt {
  /* Joint that the limb is called by: LeftArm, RightUpLeg, Tail. */
  const char* name;
  /* Probability that the limb is wrong, 0..1. */
  float doubt;
  uint32_t reserved;
} sinew_character_doubt;

typedef struct sinew_character_rig_result {
  uint32_t struct_size;
  /* 1: the skeleton is its own mirror image. */
  uint32_t mirrored;
  /* With a skeleton: its joints that have a counterpart in the prediction. */
  uint32_t matched;
  /* N: joints of the arrays below. */
  uint32_t joint_count;
  /* How far off the votes think they are, see sinew_rig_outputs. */
  float spread;
  float reserved;
  /* With a skeleton: how much larger it became. */
  double scale;
  double seconds;
  double bind_seconds;
  /* [N] 1: a bone end. */
  const uint8_t* ends;
  /* [N] 0..1 */
  const float* confidence;
  /* [N] 0..1 */
  const float* parent_confidence;
  /* Unit vector in which the mesh faces. */
  float front[3];
  /* sinew_up: Y or Z. */
  uint32_t up;
  /* 0..1, see sinew_rig_outputs; below 0.7 a coin toss. */
  float front_confidence;
  float up_confidence;
  uint32_t seam_count;
  /* [seam_count] Longest first. */
  const sinew_character_seam* seams;
  uint32_t doubtful_count;
  /* [doubtful_count] Limbs by falling doubt; of votes. */
  const sinew_character_doubt* doubtful;
} sinew_character_rig_result;

/* Makes a skeleton for a mesh and binds the mesh to it. A skeleton that the character has is replaced. */
SINEW_API sinew_status sinew_character_rig(sinew_character* character, const sinew_character_rig_options* options,
                                           sinew_character_rig_result* result);

/* Returns the names of the skeletons that template:NAME knows, a space between two. Static. */
SINEW_API const char* sinew_character_templates(void);

/* ---- map ---- */

/* Which motion is used of a file or character, and how it is read. */
typedef struct sinew_motion_source {
  uint32_t struct_size;
  /* sinew_up: of the motion; 0 = found. */
  uint32_t up;
  /* A file in place of the call's character, which is null then; of sinew_character_map() also template:NAME. */
  const char* file;
  /* Layout of keypoints (.npy, .npz): "smpl24", ...; null: guessed by their count. */
  const char* layout;
  /* Of a file of several people, by the root's name or number; null: the first where all are alike. */
  const char* actor;
  /* By name or number; null: all. */
  const char* clip;
  /* Frames a second; 0 = as the motion has. */
  double fps;
  /* First second that is played. */
  double from;
  /* Last second that is played; 0 = the end. */
  double to;
} sinew_motion_source;

/* `sinew map` */
typedef struct sinew_character_map_options {
  uint32_t struct_size;
  /* sinew_map_method */
  uint32_t method;
  /* Bits of sinew_without.
   *   SINEW_WITHOUT_NAMES  joints' names are not read
   *   SINEW_WITHOUT_ENDS   bone ends are not read */
  uint32_t without;
  /* sinew_up; 0 = along the legs of a body that has two, else Y. */
  uint32_t target_up;
  /* 1: as with target_up 0, whatever it is. */
  uint32_t guess_up;
  uint32_t pin_count;
  /* [pin_count] Pairs that are kept; or null. */
  const sinew_map_pin* pins;
  /* A map whose lines are kept; or null. */
  const char* pins_file;
  /* sinew_branches_first: of SINEW_MAP_BRANCHES. */
  uint32_t branches_first;
  /* sinew_branches_cost: of SINEW_MAP_BRANCHES. */
  uint32_t branches_cost;
  /* Only file, layout, actor and up, which is the target's where it is 0, Y for a template; null = defaults. */
  const sinew_motion_source* source;
} sinew_character_map_options;

typedef struct sinew_character_map_result {
  uint32_t struct_size;
  /* sinew_map_method: that was used. */
  uint32_t method;
  /* J of the target. */
  uint32_t joint_count;
  /* Joints with a source. */
  uint32_t mapped;
  /* 0..1, of front, sides and trunk. */
  float certainty;
  /* 0..1, how much of both bodies it reaches; below 0.5 sinew_character_animate() refuses it. */
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

/* Finds the joint of the source for each joint of the target. Changes neither; the result's arrays are the target's. The source is read as
 * sinew_character_animate() reads a motion: in a stance that is guessed where its rest pose is none. Joints of its motion beside its own
 * (animated nodes without skin) are counted behind them.
 *   source  or null where options->source has a file
 *   result  not null */
SINEW_API sinew_status sinew_character_map(sinew_character* target, const sinew_character* source,
                                           const sinew_character_map_options* options,
                                           sinew_character_map_result* result);

/* ---- animate ---- */

typedef enum sinew_animate_method {
  SINEW_ANIMATE_AUTO = 0, /* contacts */
  SINEW_ANIMATE_COPY = 1, /* every joint rotates as its source does */
  SINEW_ANIMATE_CONTACTS = 2,
  SINEW_ANIMATE_REFERENCE_POINTS = 3, /* the published method, for comparison */
  SINEW_ANIMATE_STREAM = 4,           /* every frame of those before it alone, see sinew/motion_stream.h */
  SINEW_ANIMATE_NODE_OFFSETS = 5      /* the published alignment of nodes, for comparison */
} sinew_animate_method;

typedef enum sinew_pose_deform {
  SINEW_POSE_LINEAR = 0, /* linear blend skinning */
  SINEW_POSE_DUAL_QUATERNION = 1,
  SINEW_POSE_VOLUME = 2, /* bends keep their volume and do not pass through themselves */
  SINEW_POSE_XPBD = 3,   /* the published correction */
  SINEW_POSE_DELTA_MUSH = 4
} sinew_pose_deform;

/* How a posed mesh follows its joints. */
typedef struct sinew_character_deformation {
  uint32_t struct_size;
  /* sinew_pose_deform: animate makes morph targets of corrections, VOLUME and above; bake takes no other. 0 = none, linear blending
   * or VOLUME, as the call says. */
  uint32_t method;
  /* Of the deformer; 0 = its own. */
  uint32_t cells;
  /* Of the deformer; 0 = its own. */
  uint32_t rounds;
  /* 1: with VOLUME or XPBD, limbs keep out of the body. */
  uint32_t body_contact;
  /* sinew_tet_weights: of SINEW_POSE_XPBD. */
  uint32_t tet_weights;
  /* Bits of sinew_without.
   *   SINEW_WITHOUT_SMOOTHING  bends are not smoothed, of SINEW_POSE_XPBD */
  uint32_t without;
  /* 1: SINEW_POSE_XPBD as published, see sinew/deform.h. */
  uint32_t deform_as_drawn;
  /* Of SINEW_POSE_XPBD: of the springs in the lattice's tetrahedra, 0.001 to 1000; 0 = 0.2. */
  double stiffness;
} sinew_character_deformation;

/* `sinew animate` */
typedef struct sinew_character_animate_options {
  uint32_t struct_size;
  uint32_t thread_count;
  sinew_progress progress;
  void* progress_user;
  /* For a bare mesh, which is rigged first. */
  const sinew_character_models* models;
  /* What is played of the motion; null = all of it. */
  const sinew_motion_source* motion;
  /* Corrections of the posed mesh; null = none. */
  const sinew_character_deformation* deform;
  /* Reference points: area_power, own_limb, legs, falloff, head, torso, source_points and as_drawn of
   * SINEW_ANIMATE_REFERENCE_POINTS; null = defaults. */
  const sinew_reference_options* reference;
  /* sinew_animate_method */
  uint32_t method;
  /* Bits of sinew_without.
   *   SINEW_WITHOUT_RANGE  knees and elbows may leave their natural range */
  uint32_t without;
  /* 1: stays above where it stands at rest. */
  uint32_t in_place;
  /* sinew_up: of the character; 0 = found. */
  uint32_t target_up;
  /* Most morph targets a clip; 0 = 16. */
  uint32_t shapes;
  /* 1: limbs are measured before and after. */
  uint32_t report;
  /* 1: plays a motion that does not fit, such as a person's on a horse; else an error. */
  uint32_t force;
  /* 1: bones stretch as the source's do, as in sinew_retarget_options. */
  uint32_t translations;
  /* 1: bones of a picture's character leave its plane as the motion's do. */
  uint32_t depth;
  uint32_t pin_count;
  /* [pin_count] Pairs that a found map keeps; or null. */
  const sinew_map_pin* pins;
  /* A map file; null: found. */
  const char* map;
  /* [J] Joint of the motion or -1, in place of a map; or null. */
  const int32_t* sources;
  /* What joints stay within, contacts or not: a .urdf, a file of formats/spec/limits.md, or "human" for what bodies can do; null:
   * the natural range alone. */
  const char* limits;
  /* 1: hair, tails, ears and skirts swing in the clips, by the springs of the character, see sinew_character_springs(). */
  uint32_t springs;
  uint32_t reserved;
} sinew_character_animate_options;

typedef struct sinew_character_animate_result {
  uint32_t struct_size;
  /* Clips that were added. */
  uint32_t clip_count;
  /* Index of the first of them, for sinew_character_get_clip(). */
  uint32_t first_clip;
  /* Joints that move. */
  uint32_t mapped;
  /* 1: it was a bare mesh. */
  uint32_t rigged;
  /* Morph targets that were added. */
  uint32_t shape_count;
  /* 0..1, of front and sides, and no more than how much of both bodies the map reaches. */
  float certainty;
  /* With report: limbs in both arrays below. */
  uint32_t limb_count;
  /* [clip_count x limb_count] With report; or null. */
  const sinew_limb_quality* limbs_before;
  /* [clip_count x limb_count] With report; or null. */
  const sinew_limb_quality* limbs_after;
  /* "anatomy and names" */
  const char* mapped_by;
  /* [J] The map that was used: joint of the motion, -1 = none. */
  const int32_t* sources;
  /* [J] sinew_map_reason */
  const uint8_t* reasons;
  /* [source_count] 1: a mere end, which never turns. */
  const uint8_t* source_ends;
  /* Joints of the motion, a line each, '\n' between two. */
  const char* source_names;
  uint32_t source_count;
  /* With report: limb_count of each frame, one clip's after another's. */
  uint32_t spot_count;
  /* [spot_count] sinew_spot_kind */
  const uint8_t* spot_kinds;
  /* [spot_count x 3] See sinew_contact_spot, as the errors. */
  const float* spot_positions;
  /* [spot_count] */
  const float* spot_errors;
} sinew_character_animate_result;

/* Adds clips of another skeleton to a bound character, which are saved with it. A bare mesh is rigged first.
 *   motion  null: options->motion has a file, or a bundled clip of its class is played on the character of a picture */
SINEW_API sinew_status sinew_character_animate(sinew_character* character, sinew_character* motion,
                                               const sinew_character_animate_options* options,
                                               sinew_character_animate_result* result);

/* ---- pose ---- */

/* `sinew pose`: one of angles, rotations, matrices and clip says the pose. */
typedef struct sinew_character_pose_options {
  uint32_t struct_size;
  uint32_t thread_count;
  /* How the mesh follows; null = linear blend skinning. */
  const sinew_character_deformation* deform;
  /* [J x 3] Degrees about x, then y, then z. */
  const double* angles;
  /* [J x 4] x y z w, local, relative to the rest pose. */
  const double* rotations;
  /* [J x 12] Row-major 3x4, rest to posed space. */
  const double* matrices;
  /* Of the character's own, by name or number. */
  const char* clip;
  /* Second of the clip. */
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
  /* 1..12 influences a vertex; 0 = 4. */
  uint32_t influence_count;
  /* sinew_up; 0 = Y. */
  uint32_t target_up;
  /* sinew_up; 0 = Y. */
  uint32_t source_up;
  /* 1: the target is worn by the source. */
  uint32_t garment;
  /* 1: as its paper says, of SINEW_TRANSFER_BIHARMONIC. */
  uint32_t as_drawn;
  /* 1: binds by heat alone, without a model. */
  uint32_t heat;
  uint32_t pair_count;
  /* [pair_count] Of SINEW_TRANSFER_BIHARMONIC; or null. */
  const sinew_vertex_pair* pairs;
  /* [V] not 0: the target's vertex keeps the weights it has; or null. */
  const uint8_t* locked;
  /* A map file; null: found. */
  const char* map;
} sinew_character_transfer_options;

typedef struct sinew_character_transfer_result {
  uint32_t struct_size;
  /* Joints of the source. */
  uint32_t mapped_joints;
  /* 1: the target had no skeleton and has the source's. */
  uint32_t fitted;
  /* 1: something was bound anew. */
  uint32_t bound;
  /* sinew_method */
  uint32_t bound_by;
  uint32_t part_count;
  /* As in sinew_transfer_outputs, and the two below. */
  double carried;
  double style;
  double mismatch;
  double seconds;
  const char* mapped_by;
  /* [part_count] By falling size. */
  const sinew_transfer_part* parts;
} sinew_character_transfer_result;

/* Carries the weights of a bound character to the target's mesh, which keeps its skeleton or gets the source's, fitted. */
SINEW_API sinew_status sinew_character_transfer(const sinew_character* source, sinew_character* target,
                                                const sinew_character_transfer_options* options,
                                                sinew_character_transfer_result* result);

/* ---- simplify, lod ---- */

/* `sinew simplify` */
typedef struct sinew_character_simplify_options {
  uint32_t struct_size;
  /* 1: fingers and small parts too; 0: bone ends, helpers, faces, twists. */
  uint32_t low;
  /* So many joints are left; 0 = by the level. */
  uint32_t joint_count;
  uint32_t keep_count;
  /* [keep_count] Joints that stay; or null. */
  const char* const* keep;
  /* 1: only the published conditions say which joints go; see sinew/simplify.h. */
  uint32_t as_drawn;
  uint32_t reserved;
} sinew_character_simplify_options;

/* Removes joints; weights and the file's own animations follow. The body stays at both levels; at the high one vertices move by less than
 * 1 % of the height in these animations.
 *   into  out [J before] the joint, of those before, that each is part of now; or null */
SINEW_API sinew_status sinew_character_simplify(sinew_character* character,
                                                const sinew_character_simplify_options* options, uint32_t* into);

#define SINEW_MAX_LOD_LEVELS 8

/* `sinew lod` */
typedef struct sinew_character_lod_options {
  uint32_t struct_size;
  /* 1..SINEW_MAX_LOD_LEVELS; 0 = 3. */
  uint32_t level_count;
  /* Triangles of a level, as a share of the one before, 0.05..0.95; 0 = 0.5. */
  double ratio;
  /* 1: level 2 has the joints of sinew_character_simplify(), further ones of its low level. */
  uint32_t fewer_joints;
  uint32_t reserved;
} sinew_character_lod_options;

/* How far a level is from the whole character, shares of its height. */
typedef struct sinew_character_lod_level {
  /* Largest distance of a vertex from the level's surface. */
  double rest_error;
  /* The same in the worst of the poses that bodies are bent in. */
  double posed_error;
  /* The mean in that pose. */
  double mean_error;
  uint32_t triangle_count;
  uint32_t reserved;
} sinew_character_lod_level;

/* Makes copies of a bound character with fewer and fewer triangles; weights, shapes, seams and materials stay with what is left. One to
 * which a call has added clips or morph targets is SINEW_ERROR_INPUT: save and open it first.
 *   levels   out [level_count, 3 where it is 0], each closed by sinew_character_close(); untouched on failure
 *   figures  out, as many; or null */
SINEW_API sinew_status sinew_character_lod(sinew_character* character, const sinew_character_lod_options* options,
                                           sinew_character** levels, sinew_character_lod_level* figures);

/* ---- springs ---- */

/* `sinew springs`: names are those of chains, which are those of their first joints; NAME* stands for all that begin with NAME. */
typedef struct sinew_character_springs_options {
  uint32_t struct_size;
  /* 1: finds springs anew in place of the file's own. */
  uint32_t replace;
  uint32_t take_count;
  uint32_t drop_count;
  uint32_t preset_count;
  uint32_t value_count;
  /* [take_count] Chains that are kept although they are not sure, or beside the file's own; or null. */
  const char* const* take;
  /* [drop_count] Chains that are left out; or null. */
  const char* const* drop;
  /* [preset_count] NAME=KIND: numbers of another kind, hair, long-hair, skirt, tail, ear, cape, bust or ribbon; or null. */
  const char* const* presets;
  /* [value_count] NAME:FIELD=X, one number of a chain's joints, or NAME:FIELD=xF, F times what each has: stiffness, gravity, drag, radius or limit; or null. */
  const char* const* values;
} sinew_character_springs_options;

typedef struct sinew_character_springs_result {
  uint32_t struct_size;
  /* Chains that are kept. */
  uint32_t chain_count;
  /* Joints that swing. */
  uint32_t joint_count;
  /* Spheres and capsules that push them. */
  uint32_t collider_count;
  /* Chains that were proposed, with those that are not kept. */
  uint32_t proposal_count;
  /* The first of these are the file's own. */
  uint32_t own_count;
  /* [proposal_count] 1: kept. */
  const uint8_t* kept;
  /* [proposal_count] 0..1 */
  const float* certainties;
  /* Names of the proposals, a line each, '\n' between two. */
  const char* names;
  /* Kinds of the proposals, a line each, '\n' between two. */
  const char* kinds;
} sinew_character_springs_result;

/* Finds what swings on a bound character, hair, tails, ears and skirts, with colliders. They are saved with it (VRMC_springBone), and played by
 * sinew_character_animate(). */
SINEW_API sinew_status sinew_character_springs(sinew_character* character,
                                               const sinew_character_springs_options* options,
                                               sinew_character_springs_result* result);

/* ---- bake ---- */

/* `sinew bake` */
typedef struct sinew_character_bake_options {
  uint32_t struct_size;
  uint32_t reserved;
  sinew_progress progress;
  void* progress_user;
  /* The correction; null = SINEW_POSE_VOLUME. */
  const sinew_character_deformation* deform;
  /* Poses to learn from; 0 = 1500. */
  uint32_t poses;
  /* Most weights that drive a bend, each of which has one or two morph targets; 0 = 8. */
  uint32_t shapes;
  /* Of the random poses; 0 = 1. */
  uint64_t seed;
  /* Largest angle in degrees; 0 = 60. */
  double limit;
  /* Learns from a clip of the character's own; null: random poses. */
  const char* clip;
  /* What may be left out of a vertex's moves, root mean square over the poses, a share of the size; 0 = 0.002. */
  double error;
} sinew_character_bake_options;

typedef struct sinew_character_bake_result {
  uint32_t struct_size;
  uint32_t shape_count;
  uint32_t bend_count;
  uint32_t moved_vertices;
  uint32_t learnt_poses;
  uint32_t held_out_poses;
  /* Of the poses that were learned, shares of the size, and the one below. */
  double linear_error;
  double baked_error;
  /* Of other poses, and the one below. */
  double held_out_linear_error;
  double held_out_baked_error;
} sinew_character_bake_result;

/* Adds morph targets that correct bends, with what drives them, which are saved with the character. */
SINEW_API sinew_status sinew_character_bake(sinew_character* character, const sinew_character_bake_options* options,
                                            sinew_character_bake_result* result);

#ifdef __cplusplus
}
#endif
#endif
