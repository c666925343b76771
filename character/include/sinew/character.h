/* SPDX-License-Identifier: MIT
 * Characters: what the command `sinew` does with one, as calls of the shared library libsinew_character. The same defaults as the
 * command's, the same bytes in what is saved. The engine's own calls (sinew/sinew.h) are in this library too.
 *
 *   open, create, copy, close         a character from a file, from files in memory, from arrays, from a picture
 *   view, clip, notes                 its arrays, its motion, what the reader has to say
 *   bind, rig, map, animate, pose, transfer, simplify, lod, check, bake   one call for each command of that name
 *   transform, controls               --turn, --height and --floor of rig and bind; --controls
 *   save, write                       to a file, to memory
 *
 * Errors: a call that can fail returns a sinew_status; 0 is success. sinew_character_error() has one line of English then: what is
 * wrong, where, what was expected. What failed changes nothing: neither the character nor a file.
 * Structs begin with `struct_size` and grow at the end, as sinew/types.h describes; an options struct that is null asks for every
 * default, and so does every member that is 0.
 * Strings are UTF-8. Pointers that a call hands out belong to the character: they are good until the next call that changes it (its
 * comment has no const character), or sinew_character_close().
 * Threads: any number of characters at the same time; one character is used by one thread at a time. */
#ifndef SINEW_CHARACTER_H
#define SINEW_CHARACTER_H

#include "sinew/published.h"
#include "sinew/sinew.h"

#ifdef __cplusplus
extern "C" {
#endif

/* What calls of this header return beside the numbers of sinew_status. Numbers are never reused. */
#define SINEW_ERROR_INPUT ((sinew_status)-30)  /* a file, an array or a name cannot be used: the error line says why */
#define SINEW_ERROR_MEMORY ((sinew_status)-31) /* there is no memory for it */

typedef struct sinew_character sinew_character;

/* The line of the last call with this character that failed; with null, of the last call on this thread that failed, whatever its
 * character. "" before one did. Never null. Good until the next call that fails. */
SINEW_API const char* sinew_character_error(const sinew_character* character);

/* sizeof of a struct of this header, as this library has it, for bindings: see sinew_struct_size() in sinew/abi.h.
 *   name  "sinew_character_clip"; null is allowed.  Returns 0 for a name that no struct has. */
SINEW_API size_t sinew_character_struct_size(const char* name);

/* ---- files ---- */

/* Bytes under a name. */
typedef struct sinew_file {
  const char* name; /* "hero.glb"; its extension says what it is */
  const void* bytes;
  size_t size_bytes;
} sinew_file;

typedef enum sinew_file_use {
  SINEW_READ_MESH = 1,        /* a mesh, with or without a skeleton */
  SINEW_READ_SKELETON = 2,    /* joints */
  SINEW_READ_MOTION = 4,      /* clips */
  SINEW_READ_WHOLE = 8,       /* mesh, skeleton and weights in one file */
  SINEW_WRITE_CHARACTER = 16, /* mesh, skeleton and weights */
  SINEW_WRITE_MOTION = 32,    /* clips */
  SINEW_WRITE_MESH = 64,      /* a mesh alone: poses */
  SINEW_READ_PICTURE = 256    /* a drawing or a photograph of a character: sinew_character_open_picture() */
} sinew_file_use;

/* Extensions of all files of a use (sinew_file_use, or several: those that have them all), a space between two: ".obj .gltf .glb". For
 * file dialogs. Static; "" where none has. */
SINEW_API const char* sinew_character_extensions(uint32_t uses);

/* Opens a file by its extension. A .obj comes with the NAME.rig.txt beside it, where there is one; a .rig.txt with its NAME.obj. A
 * .bvh, .vrma, .npz, .npy or .vmd, or a .rig.txt alone, is a skeleton without a mesh. builtin:NAME is a clip that ships, for sinew_character_animate(): of several
 * kinds of body the one that fits the character it is played on. A .png or .jpg is a drawing or a photograph of a character, opened by
 * sinew_character_open_picture() with every default.
 *   path       the file
 *   character  out; untouched on failure. Closed by sinew_character_close()
 * Returns SINEW_OK, SINEW_ERROR_ARGUMENT (a pointer is null), SINEW_ERROR_INPUT, SINEW_ERROR_MEMORY. */
SINEW_API sinew_status sinew_character_open(const char* path, sinew_character** character);

/* The same from memory: the first file is opened, the others are what lies beside it (a .bin, pictures, .mtl, .rig.txt), under the names
 * that it has for them. The disk is not looked at. All is copied. */
SINEW_API sinew_status sinew_character_open_files(const sinew_file* files, uint32_t file_count,
                                                  sinew_character** character);

/* Keypoints of a person's joints alone, as cameras and captures tell them, as a motion: a skeleton whose bones are as long as they mostly are
 * in these frames, which are its clip. Which way is up, a mirrored world and keypoints relative to the hips are found out, and told in the
 * notes; one frame will do, a second or two are better.
 *   layout       "smpl24", "humanml3d22", "coco17" or "mediapipe33"
 *   keypoints       [frame_count x keypoint_count x 3] any unit
 *   keypoint_count  of the layout: 24, 22, 17 or 33
 *   character    out; untouched on failure */
SINEW_API sinew_status sinew_character_open_keypoints(const char* layout, const float* keypoints,
                                                      uint32_t keypoint_count, uint32_t frame_count,
                                                      sinew_character** character);
/* The frames that come: what sinew_retarget_stream_frame() takes of a source with this character's skeleton. Each is made of its own keypoints
 * alone.
 *   character     of sinew_character_open_keypoints(), with the J joints of sinew_character_view()
 *   keypoints        [keypoint_count x 3] in the units of the first ones
 *   rotations     out [J x 4] x y z w, local; untouched on failure
 *   translations  out [J x 3] in the parents' axes; untouched on failure */
SINEW_API sinew_status sinew_character_keypoints_frame(const sinew_character* character, const float* keypoints,
                                                       uint32_t keypoint_count, float* rotations, float* translations);

/* ---- pictures ---- */

typedef enum sinew_body_class {
  SINEW_BODY_CLASS_FOUND =
      0, /* as the votes of the model say. Others: the numbers of sinew_category, and what is none of them */
  SINEW_BODY_CLASS_BIPED = 1,
  SINEW_BODY_CLASS_QUADRUPED = 2,
  SINEW_BODY_CLASS_BIRD = 3,
  SINEW_BODY_CLASS_FISH = 4,
  SINEW_BODY_CLASS_SNAKE = 5,
  SINEW_BODY_CLASS_MANY_LEGGED = 6,
  SINEW_BODY_CLASS_OTHER = 7
} sinew_body_class;

/* From where a picture shows its character. */
typedef enum sinew_picture_view {
  SINEW_PICTURE_VIEW_FRONT = 0,
  SINEW_PICTURE_VIEW_FACES_RIGHT = 1,
  SINEW_PICTURE_VIEW_FACES_LEFT = 2
} sinew_picture_view;

typedef struct sinew_character_picture_options {
  uint32_t struct_size; /* sizeof(sinew_character_picture_options) */
  uint32_t body_class;  /* sinew_body_class */
  uint32_t figure;      /* of several figures, from left to right, from 1 on; 0: the largest */
  uint32_t flat;        /* 1: a card instead of a body as thick as it is wide */
  uint32_t
      pixels; /* 1: positions are the picture's pixels, x right, y up from the bottom edge; else the longest side is 1 */
  uint32_t line_count; /* closed lines of the outline */
  const char*
      mask; /* a picture that is bright where the figure is, as a file or the name of one in memory; null: found */
  const uint32_t* line_offsets; /* [line_count + 1] CSR into the outline, rising from 0 */
  const float* outline; /* [line_offsets[line_count] x 2] the figure as sinew_character_picture_info has it, in place of
                                 * what is found; or null */
  uint32_t cut;         /* 1: the figure is opened along lines that are drawn into it from its outline, as a guess */
  uint32_t reserved;    /* 0 */
} sinew_character_picture_options;

/* Opens a drawing or a photograph of a character (PNG, JPEG): its figure as a mesh in the plane z = 0, seen from +z, with the picture as
 * its texture. sinew_character_rig() gives it a skeleton in that plane (its category may say the class, too);
 * sinew_character_animate() does so where it has none, and plays a clip of its class where no motion is given.
 *   options    null = all defaults
 *   character  out; untouched on failure */
SINEW_API sinew_status sinew_character_open_picture(const char* path, const sinew_character_picture_options* options,
                                                    sinew_character** character);
/* The same from memory, as sinew_character_open_files(): the picture first, a mask beside it. */
SINEW_API sinew_status sinew_character_open_picture_files(const sinew_file* files, uint32_t file_count,
                                                          const sinew_character_picture_options* options,
                                                          sinew_character** character);

/* What was found in the picture. */
typedef struct sinew_character_picture_info {
  uint32_t struct_size;         /* sizeof(sinew_character_picture_info) */
  uint32_t width, height;       /* pixels as the picture is seen */
  uint32_t figure_count;        /* in the picture */
  uint32_t figure;              /* the one that was taken, from 1 on */
  uint32_t body_class;          /* sinew_body_class; 0 before it is rigged */
  uint32_t view;                /* sinew_picture_view; 0 before it is rigged */
  float certainty;              /* 0..1, of class and view together; 0 before it is rigged */
  uint32_t line_count;          /* closed lines of the outline: the border, then those of holes and smaller parts */
  uint32_t reserved;            /* 0 */
  const uint32_t* line_offsets; /* [line_count + 1] */
  const float* outline;         /* [line_offsets[line_count] x 2] pixels, x right, y down from the top left corner */
} sinew_character_picture_info;

/* A character that is not of a picture is SINEW_ERROR_INPUT. */
SINEW_API sinew_status sinew_character_picture(sinew_character* character, sinew_character_picture_info* info);

/* From arrays, which are copied.
 *   mesh         null: a skeleton alone
 *   skeleton     null: a mesh alone. names: no name twice; null: joint0, joint1, ... flags: joints with SINEW_JOINT_NEVER do not
 *                deform, those with SINEW_JOINT_DEFORMS do. ends, rotations and up are not looked at
 * Returns SINEW_OK, SINEW_ERROR_ARGUMENT, SINEW_ERROR_COUNT, SINEW_ERROR_NOT_FINITE, SINEW_ERROR_INDEX, SINEW_ERROR_HIERARCHY,
 * SINEW_ERROR_INPUT (a name), SINEW_ERROR_MEMORY. */
SINEW_API sinew_status sinew_character_create(const sinew_mesh* mesh, const sinew_skeleton* skeleton,
                                              sinew_character** character);

SINEW_API sinew_status sinew_character_copy(const sinew_character* from, sinew_character** character);
/* Null is allowed. */
SINEW_API void sinew_character_close(sinew_character* character);

/* Saves by the extension: .glb; .gltf with NAME.bin beside it; .fbx; .vrm where the input was one; .obj with NAME.rig.txt where there are
 * joints; .rig.txt; .bvh, of the one clip. A glTF keeps all of its input that was not changed. The file is new or as it was.
 * Returns SINEW_OK, SINEW_ERROR_ARGUMENT, SINEW_ERROR_INPUT, SINEW_ERROR_MEMORY. */
SINEW_API sinew_status sinew_character_save(sinew_character* character, const char* path);

/* The same to memory.
 *   name        its extension says what is written: "hero.glb"
 *   files       out: what sinew_character_save() would write, the file itself first
 *   file_count  out */
SINEW_API sinew_status sinew_character_write(sinew_character* character, const char* name, const sinew_file** files,
                                             uint32_t* file_count);

/* `--for` of the command: what another program wants of a file. */
typedef struct sinew_character_profile_options {
  uint32_t struct_size; /* sizeof(sinew_character_profile_options) */
  uint32_t keep_axes;   /* 1: axes, names and roots of the skeleton stay as they are */
  const char* profile;  /* "mixamo", "vrm": one of sinew_character_profiles(); null = none, files as they were read */
  const char* licence;  /* of a VRM, in the words of its format; null = nothing is allowed */
  const char* title;    /* of a VRM; null = the character's name */
  const char* const* authors; /* [author_count] of a VRM, which has at least one; or null */
  uint32_t author_count;
  uint32_t controls; /* 1: a glTF's extras have what sinew_character_controls() says */
} sinew_character_profile_options;

/* What sinew_character_save() and sinew_character_write() write from now on: joint names and axes, a root, influences, facing, and what a
 * VRM says. The picture stays, and the rest pose too: that is to_pose of a bind or rig ("t" for most, "a" for unreal). Remarks go to
 * sinew_character_notes() as files are written. Returns SINEW_OK, SINEW_ERROR_ARGUMENT, SINEW_ERROR_INPUT for an unknown profile or a VRM
 * without an author, SINEW_ERROR_VERSION. */
SINEW_API sinew_status sinew_character_set_profile(sinew_character* character,
                                                   const sinew_character_profile_options* options);
/* Names of the profiles, a space between two. Static. */
SINEW_API const char* sinew_character_profiles(void);

/* `--controls`: which joints an animator's controls move, JSON as formats/spec/controls.md has it, of the skeleton as it would be saved.
 *   text  out: ends with a line break
 * A character without joints is SINEW_ERROR_INPUT. */
SINEW_API sinew_status sinew_character_controls(sinew_character* character, const char** text);

/* ---- arrays ---- */

/* A character's arrays, borrowed. */
typedef struct sinew_character_arrays {
  uint32_t struct_size;           /* sizeof(sinew_character_arrays) */
  uint32_t vertex_count;          /* V; 0: a skeleton alone */
  uint32_t face_count;            /* F */
  uint32_t corner_count;          /* length of face_vertices */
  uint32_t joint_count;           /* J; 0: a mesh alone */
  uint32_t mesh_count;            /* M; 0: not known (OBJ, arrays) */
  uint32_t influence_count;       /* joints of the longest row; 0: no weights */
  uint32_t reserved;              /* 0 */
  const char* name;               /* the file's, without its extension */
  const float* positions;         /* [V x 3] in the pose that the weights are meant for */
  const uint32_t* face_offsets;   /* [F + 1] CSR into face_vertices */
  const uint32_t* face_vertices;  /* [corner_count] */
  const float* joint_positions;   /* [J x 3] at rest, the mesh's units */
  const int32_t* parents;         /* [J] -1 = root; any order */
  const char* const* joint_names; /* [J] no name twice */
  const uint32_t* row_offsets;    /* [V + 1] CSR of the weights; null without weights. A row may be empty */
  const uint32_t* joint_indices;  /* [row_offsets[V]] */
  const float* weights;           /* [row_offsets[V]] */
  const uint8_t* confidence;      /* [V] of the last bind or transfer, 0..255; or null */
  const uint32_t* vertex_meshes;  /* [V] mesh of each vertex; or null */
  const char* const* mesh_names;  /* [M] */
  const int32_t* mesh_joints;     /* [M] of a mesh without a skin: the joint that it hangs on, or -1 */
  const uint8_t* mesh_skinned;    /* [M] 1: it has a skin */
} sinew_character_arrays;

SINEW_API sinew_status sinew_character_view(sinew_character* character, sinew_character_arrays* arrays);

/* Weights as the engine takes them: the strongest of each row, unorm16, rounded as sinew_bind() rounds. A row without weight is 0.
 *   influence_count  1..SINEW_MAX_INFLUENCES
 *   joint_indices, weights  out [V x influence_count] */
SINEW_API sinew_status sinew_character_skin(const sinew_character* character, uint32_t influence_count,
                                            uint16_t* joint_indices, uint16_t* weights);

/* A class for each joint as retargeting has it (sinew_joint_class).  classes  out [J] */
SINEW_API sinew_status sinew_character_joint_classes(const sinew_character* character, uint8_t* classes);

/* Remarks of the reader and of the jobs for the user, a line each, '\n' between two; "" for none. */
SINEW_API const char* sinew_character_notes(sinew_character* character);

/* Another skeleton for the mesh; weights go. As in sinew_character_create(). */
SINEW_API sinew_status sinew_character_set_skeleton(sinew_character* character, const sinew_skeleton* skeleton);
/* The skeleton of another character, as `sinew bind --skeleton FILE` takes the one of a file.
 *   with_weights  1: its weights too; it has as many vertices then */
SINEW_API sinew_status sinew_character_take_skeleton(sinew_character* character, const sinew_character* other,
                                                     uint32_t with_weights);

/* Weights from CSR arrays, which are copied; rows need not sum to 1.
 *   row_offsets  [V + 1] rising from 0.  joint_indices, weights  [row_offsets[V]]; weights 0 or more, no joint twice in a row
 * Returns SINEW_OK, SINEW_ERROR_ARGUMENT, SINEW_ERROR_INDEX (offsets fall), SINEW_ERROR_RANGE (a joint or a weight). */
SINEW_API sinew_status sinew_character_set_weights(sinew_character* character, const uint32_t* row_offsets,
                                                   const uint32_t* joint_indices, const float* weights);

/* ---- motion ---- */

/* A clip: poses of the character's skeleton and, in a file, of animated nodes around it. At rest every joint's axes are the world's. */
typedef struct sinew_character_clip {
  uint32_t struct_size; /* sizeof(sinew_character_clip) */
  uint32_t frame_count; /* F */
  uint32_t joint_count; /* N: the character's J joints in their order, then others */
  uint32_t reserved;    /* 0 */
  double frame_time;    /* seconds */
  const char* name;
  const double* rotations;        /* [F x N x 4] x y z w, against the rest pose, local */
  const double* translations;     /* [F x N x 3] from the parent */
  const char* const* joint_names; /* [N] */
  const int32_t* parents;         /* [N] */
} sinew_character_clip;

/* Clips of the file, then those that were added. 0 for a file without motion. */
SINEW_API sinew_status sinew_character_clip_count(sinew_character* character, uint32_t* count);
SINEW_API sinew_status sinew_character_get_clip(sinew_character* character, uint32_t index, sinew_character_clip* clip);
/* Adds a clip of the character's joints; joint_count is J, joint_names and parents are not looked at. It is saved as an animation. */
SINEW_API sinew_status sinew_character_add_clip(sinew_character* character, const sinew_character_clip* clip);

/* ---- where it stands ---- */

/* `--turn`, `--height` and `--floor`, in this order. */
typedef struct sinew_character_transform_options {
  uint32_t struct_size; /* sizeof(sinew_character_transform_options) */
  uint32_t turn_count;
  const char* const*
      turns;      /* [turn_count] quarters about the origin, one after the other: "x", "-x", "y", ...; or null */
  double height;  /* metres along up; 0 = as it is */
  uint32_t floor; /* 1: the lowest vertex is at 0 along up */
  uint32_t up;    /* sinew_up, afterwards; 0 = Y */
} sinew_character_transform_options;

/* Turns and scales the character as a whole: mesh, joints, the file's own animations. Weights stay. A picture, a character without a mesh, and
 * one that has clips or morph targets of other calls are SINEW_ERROR_INPUT. */
SINEW_API sinew_status sinew_character_transform(sinew_character* character,
                                                 const sinew_character_transform_options* options);

/* ---- jobs ---- */

/* Models in place of the bundled ones: the bytes of .sinew files, borrowed for the time of a call. Null members: the bundled one. */
typedef struct sinew_character_models {
  uint32_t struct_size; /* sizeof(sinew_character_models) */
  uint32_t reserved;    /* 0 */
  const void* bind;     /* of weights */
  size_t bind_size;
  const void* rig; /* of skeletons */
  size_t rig_size;
  const void* hands; /* of fingers */
  size_t hands_size;
  const void* slots; /* of SINEW_CHARACTER_RIG_SLOTS */
  size_t slots_size;
  const void* front; /* of where a mesh faces */
  size_t front_size;
} sinew_character_models;

/* Where it is known from which joints may get weight. */
typedef enum sinew_joints_from {
  SINEW_JOINTS_AUTO = 0,  /* OWN for a character with weights for its own skeleton, else NAMES */
  SINEW_JOINTS_OWN = 1,   /* mesh by mesh, those that have weight there already */
  SINEW_JOINTS_NAMES = 2, /* not controls, slots, roots and what stands beside the mesh */
  SINEW_JOINTS_ALL = 3
} sinew_joints_from;

/* `sinew bind`. thread_count, progress and progress_user mean the same in every options struct: threads that work, 0 = 1, the same bytes
 * for any number; progress is called on the calling thread and cancels by a value that is not 0. */
typedef struct sinew_character_bind_options {
  uint32_t struct_size; /* sizeof(sinew_character_bind_options) */
  uint32_t thread_count;
  sinew_progress progress;
  void* progress_user;
  const sinew_character_models* models; /* null: bundled */
  uint32_t method;                      /* sinew_method */
  uint32_t influence_count;             /* 1..12; 0 = 4 */
  uint32_t up;                          /* sinew_up; 0 = Y */
  uint32_t joints;                      /* sinew_joints_from */
  uint32_t rigid_parts;                 /* sinew_rigid_parts */
  uint32_t softness_percent;            /* 25..400; 0 = 100 */
  uint32_t surface_vertices;            /* 0 = 32768 */
  uint32_t keep_tips;                   /* 1: joints that only end a chain keep the weight they get */
  uint32_t bind_props;                  /* 1: meshes without a skin are bound too */
  uint32_t fit;                         /* 1: a skeleton in other units or beside the mesh is brought into it */
  uint32_t symmetric;                   /* 1: mirrored vertices get mirrored rows */
  uint32_t keep_confidence;             /* 1: a saved .glb has the confidence as _CONFIDENCE */
  uint32_t question_count;              /* list at most so many parts that are worth a question */
  uint32_t answer_count;
  const sinew_answer* answers; /* [answer_count]; or null */
  const uint8_t*
      joint_flags;       /* [J] SINEW_JOINT_NEVER, SINEW_JOINT_DEFORMS (if any has it, no other deforms); or null */
  const uint8_t* locked; /* [V] not 0: keeps the weights it has; or null */
  const uint8_t* hinted; /* [V] not 0: keeps the weights it has, which steer their surroundings; or null */
  const sinew_character*
      hints; /* weights of some vertices of the same mesh, joints by name: the same as hints; or null */
  const sinew_character* like; /* a bound character whose weights are carried over where they fit; or null */
  const char* style;           /* a .style file that answers what it knows; or null */
  const char*
      to_pose; /* rest pose of the result: "t", "a", or a file whose skeleton stands so; null = as it stands. Cuts, too */
  uint32_t cut;      /* 1: what has grown together is opened, its vertices doubled; the new ones come last */
  uint32_t reserved; /* 0 */
} sinew_character_bind_options;

/* A line along which two parts of the body that move apart have grown together. No weight crosses it. */
typedef struct sinew_character_seam {
  uint32_t joints[2]; /* that most of it lies between */
  float position[3];  /* its middle */
  float length;
} sinew_character_seam;

/* A joint that may get no weight. */
typedef struct sinew_character_left_out {
  const char* why; /* "control", "no weight in the file", ... */
  uint32_t joint;
  uint32_t reserved; /* 0 */
} sinew_character_left_out;

typedef struct sinew_character_bind_result {
  uint32_t struct_size;        /* sizeof(sinew_character_bind_result) */
  uint32_t symmetric_vertices; /* with symmetric */
  uint32_t kept_meshes;        /* that stayed attached */
  uint32_t folded_tips;        /* that gave their weight to their parents */
  uint32_t left_out_count;     /* joints that may get no weight */
  uint32_t question_count;     /* as asked for, at most */
  uint32_t answers_by_style;   /* that the style file gave */
  uint32_t seam_count;
  double seconds; /* in sinew_bind() */
  size_t workspace_bytes;
  const sinew_character_left_out* left_out; /* [left_out_count] */
  const sinew_question* questions;          /* [question_count] by falling gain */
  const uint32_t* vertex_questions;         /* [V] before a cut, or SINEW_NO_QUESTION; null without questions */
  const char* hash;                         /* of the weights, as `sinew bind --json` has it */
  const sinew_character_seam* seams;        /* [seam_count] longest first */
  uint32_t doubled_vertices;                /* with cut or to_pose */
  uint32_t reserved;                        /* 0 */
} sinew_character_bind_result;

/* Gives the mesh weights for its skeleton. A mesh without a skeleton is SINEW_ERROR_INPUT.
 *   options  null = all defaults.   result  or null
 * Returns SINEW_OK, SINEW_ERROR_ARGUMENT, SINEW_ERROR_VERSION, SINEW_ERROR_CANCELLED, SINEW_ERROR_INPUT, SINEW_ERROR_MEMORY, as do all
 * calls below. */
SINEW_API sinew_status sinew_character_bind(sinew_character* character, const sinew_character_bind_options* options,
                                            sinew_character_bind_result* result);

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
  SINEW_EDIT_MOVE = 0,   /* "JOINT=X,Y,Z" */
  SINEW_EDIT_ADD = 1,    /* "NAME=PARENT:X,Y,Z" */
  SINEW_EDIT_REMOVE = 2, /* "JOINT" */
  SINEW_EDIT_PARENT = 3, /* "JOINT=OTHER" */
  SINEW_EDIT_RENAME = 4, /* "JOINT=NAME" */
  SINEW_EDIT_AT = 5      /* "JOINT=X,Y,Z": as MOVE; a joint that was not found is added, as LeftHand with its arm */
} sinew_edit_kind;

/* A change of a predicted skeleton, before the mesh is bound to it; to both sides where it is symmetric. */
typedef struct sinew_skeleton_edit {
  uint32_t kind; /* sinew_edit_kind */
  uint32_t reserved;
  const char* text;
} sinew_skeleton_edit;

/* `sinew rig` */
typedef struct sinew_character_rig_options {
  uint32_t struct_size; /* sizeof(sinew_character_rig_options) */
  uint32_t thread_count;
  sinew_progress progress;
  void* progress_user;
  const sinew_character_models* models; /* null: bundled */
  uint32_t method;                      /* sinew_character_rig_method */
  uint32_t detail;                      /* sinew_character_detail */
  uint32_t mirror;                      /* sinew_mirror */
  uint32_t up;                          /* sinew_up; 0 = found, or as the file's format says */
  uint32_t spine_count;                 /* 1..16; 0 = as the model says */
  uint32_t no_toes, no_ends;            /* 1: without */
  uint32_t no_bind;                     /* 1: the skeleton alone */
  uint32_t keep_lengths;                /* 1: with a skeleton, its bones are turned and all scaled alike */
  uint32_t influence_count;             /* of the bind, and the three below */
  uint32_t rigid_parts;                 /* sinew_rigid_parts */
  uint32_t softness_percent;
  uint32_t surface_vertices;
  uint32_t edit_count;
  const sinew_skeleton_edit* edits;          /* [edit_count] */
  const char* skeleton;                      /* a file, or template:NAME, that is put into the mesh; or null */
  const sinew_character* skeleton_character; /* the same of a character; or null */
  uint32_t category;                         /* sinew_category: what kind of body it is; 0 = as the model says */
  uint32_t front;                            /* sinew_front; 0 = found */
  uint32_t gate; /* 1: the result is measured; what fails is a note that begins with "gate: " */
  uint32_t cut;  /* 1: what has grown together is opened, as of a bind; to_pose does so, too */
  const char*
      to_pose; /* rest pose of the result: "t", "a", or a file whose skeleton stands so; null = as the mesh stands */
} sinew_character_rig_options;

/* A limb that may be wrong. */
typedef struct sinew_character_doubt {
  const char* name; /* of the joint that the limb is called by: LeftArm, RightUpLeg, Tail */
  float doubt;      /* how likely the limb is wrong, 0..1 */
  uint32_t reserved;
} sinew_character_doubt;

typedef struct sinew_character_rig_result {
  uint32_t struct_size; /* sizeof(sinew_character_rig_result) */
  uint32_t mirrored;    /* 1: the skeleton is its own mirror image */
  uint32_t matched;     /* with a skeleton: joints that have a like in the prediction */
  uint32_t joint_count; /* N, of the arrays below */
  float spread;         /* how far off the votes think they are, see sinew_rig_outputs */
  float reserved;       /* 0 */
  double scale;         /* with a skeleton: how much larger it became */
  double seconds, bind_seconds;
  const uint8_t* ends;            /* [N] 1: a bone end */
  const float* confidence;        /* [N] 0..1 */
  const float* parent_confidence; /* [N] 0..1 */
  float front[3];                 /* the direction that it faces, unit vector */
  uint32_t up;                    /* sinew_up, Y or Z */
  float front_confidence;         /* 0..1, see sinew_rig_outputs; below 0.7 a coin toss */
  float up_confidence;
  uint32_t seam_count;
  const sinew_character_seam* seams; /* [seam_count] longest first */
  uint32_t doubtful_count;
  const sinew_character_doubt* doubtful; /* [doubtful_count] most doubtful first; of votes */
} sinew_character_rig_result;

/* Makes a skeleton for a mesh and binds the mesh to it. A skeleton that the character has is left out. */
SINEW_API sinew_status sinew_character_rig(sinew_character* character, const sinew_character_rig_options* options,
                                           sinew_character_rig_result* result);

/* Names of the skeletons that template:NAME knows, a space between two. Static. */
SINEW_API const char* sinew_character_templates(void);

/* `sinew map` */
typedef struct sinew_character_map_options {
  uint32_t struct_size;       /* sizeof(sinew_character_map_options) */
  uint32_t method;            /* sinew_map_method */
  uint32_t no_names, no_ends; /* 1: not read */
  uint32_t target_up;         /* sinew_up; 0 = along the legs of a body that has two, else Y */
  uint32_t source_up;         /* sinew_up; 0 = as the target's, Y for a template */
  uint32_t guess_up;          /* 1: as with target_up 0, whatever it is */
  uint32_t pin_count;
  const sinew_map_pin* pins; /* [pin_count] pairs that are kept; or null */
  const char* pins_file;     /* a map whose lines are kept; or null */
  uint32_t branches_first;   /* sinew_branches_first, of SINEW_MAP_BRANCHES */
  uint32_t branches_cost;    /* sinew_branches_cost, of SINEW_MAP_BRANCHES */
  const char* layout;        /* of the source, as in sinew_character_animate_options */
  const char* actor;         /* of the source, as in sinew_character_animate_options */
} sinew_character_map_options;

typedef struct sinew_character_map_result {
  uint32_t struct_size; /* sizeof(sinew_character_map_result) */
  uint32_t method;      /* sinew_map_method that was used */
  uint32_t joint_count; /* J of the target */
  uint32_t mapped;      /* of them with a source */
  float certainty;      /* 0..1, of front, sides and trunk */
  float cover;          /* 0..1, how much of both bodies it reaches; below 0.5 sinew_character_animate() refuses it */
  double seconds;
  const int32_t* sources;  /* [J] joint of the source, -1 = none */
  const float* confidence; /* [J] 0..1 */
  const uint8_t* reasons;  /* [J] sinew_map_reason */
  const char* text;        /* the map as `sinew map -o` writes it */
} sinew_character_map_result;

/* Which joint of the source stands for which of the target. Changes neither; the result's arrays are the target's. The source is read as
 * sinew_character_animate() reads it as a motion: in a stance that is guessed where its rest pose is none. A joint of its motion that it
 * has beside its own (an animated node without skin) is counted behind them. */
SINEW_API sinew_status sinew_character_map(sinew_character* target, const sinew_character* source,
                                           const sinew_character_map_options* options,
                                           sinew_character_map_result* result);
/* The same with a file or template:NAME as the source. */
SINEW_API sinew_status sinew_character_map_file(sinew_character* target, const char* source,
                                                const sinew_character_map_options* options,
                                                sinew_character_map_result* result);

typedef enum sinew_animate_method {
  SINEW_ANIMATE_AUTO = 0, /* contacts */
  SINEW_ANIMATE_COPY = 1, /* every joint turns as its source does */
  SINEW_ANIMATE_CONTACTS = 2,
  SINEW_ANIMATE_REFERENCE_POINTS = 3, /* the published method, for comparison */
  SINEW_ANIMATE_STREAM = 4            /* every frame of those before it alone, see sinew/motion_stream.h */
} sinew_animate_method;

/* How a posed mesh follows its joints. */
typedef enum sinew_pose_deform {
  SINEW_POSE_LINEAR = 0, /* linear blend skinning; for sinew_character_animate() and _bake(): none, volume */
  SINEW_POSE_DUAL_QUATERNION = 1,
  SINEW_POSE_VOLUME = 2, /* bends keep their volume and do not pass through themselves */
  SINEW_POSE_XPBD = 3,   /* the published correction */
  SINEW_POSE_DELTA_MUSH = 4
} sinew_pose_deform;

/* `sinew animate` */
typedef struct sinew_character_animate_options {
  uint32_t struct_size; /* sizeof(sinew_character_animate_options) */
  uint32_t thread_count;
  sinew_progress progress;
  void* progress_user;
  const sinew_character_models* models; /* for a bare mesh, which is rigged first; null: bundled */
  uint32_t method;                      /* sinew_animate_method */
  uint32_t in_place;                    /* 1: stays above where it stands at rest */
  uint32_t no_range;                    /* 1: knees and elbows may leave their natural range */
  uint32_t target_up, motion_up;        /* sinew_up */
  uint32_t deform;            /* sinew_pose_deform: every frame is corrected by morph targets, VOLUME and above */
  uint32_t cells, rounds;     /* of the deformer; 0 = its own */
  uint32_t body_contact;      /* 1: with SINEW_POSE_VOLUME or SINEW_POSE_XPBD, limbs keep out of the body */
  uint32_t shapes;            /* most morph targets a clip; 0 = 16 */
  double fps;                 /* 0 = as the motion has */
  double from, to;            /* seconds; to 0 = the end */
  const char* clip;           /* by name or number; null: all */
  const char* map;            /* a map file; null: found */
  const int32_t* sources;     /* [J] joint of the motion or -1, in place of a map; or null */
  uint32_t area_power;        /* reference points: 1..4, or SINEW_NO_AREA; 0 = 3 */
  uint32_t no_own_limb, legs; /* 1: reference points */
  uint32_t report;            /* 1: limbs are measured before and after */
  double falloff;             /* reference points; 0 = 0.05, SINEW_NO_FALLOFF: none */
  uint32_t own_limb, head, torso, source_points; /* 1: reference points, as in sinew_reference_options */
  uint32_t force;        /* 1: plays a motion that does not fit, such as a person's on a horse; else an error */
  uint32_t translations; /* 1: bones stretch as the source's do, as in sinew_retarget_options */
  double stiffness;      /* SINEW_POSE_XPBD: of the springs in the lattice's tetrahedra, 0.001 to 1000; 0 = 0.2 */
  uint32_t tet_weights;  /* SINEW_POSE_XPBD: sinew_tet_weights */
  uint32_t no_smoothing; /* SINEW_POSE_XPBD: 1: bends are not smoothed */
  const char* layout;    /* which joints places alone are (.npy, .npz): "smpl24", ...; null: guessed by their count */
  const char*
      actor; /* of a file of several people, by the root's name or number; null: the first where all are alike */
  const char*
      limits; /* what joints stay within, contacts or not: a .urdf, a file of formats/spec/limits.md, or "human" for what
                       * bodies can do; null: nothing but the natural range */
  uint32_t depth;    /* 1: bones of a picture's character leave its plane as the motion's do */
  uint32_t reserved; /* 0 */
} sinew_character_animate_options;

typedef struct sinew_character_animate_result {
  uint32_t struct_size; /* sizeof(sinew_character_animate_result) */
  uint32_t clip_count;  /* that were added */
  uint32_t first_clip;  /* index of the first of them, for sinew_character_get_clip() */
  uint32_t mapped;      /* joints that move */
  uint32_t rigged;      /* 1: was a bare mesh */
  uint32_t shape_count; /* morph targets that were added */
  float certainty;      /* 0..1, of front and sides, and no more than how much of both bodies the map reaches */
  uint32_t limb_count;  /* with report: [clip_count x limb_count] of both below */
  const sinew_limb_quality* limbs_before; /* [clip_count x limb_count] with report; or null */
  const sinew_limb_quality* limbs_after;  /* [clip_count x limb_count] with report; or null */
  const char* mapped_by;                  /* "anatomy and names" */
  const int32_t* sources;                 /* [J] the map that was used */
} sinew_character_animate_result;

/* Adds clips of another skeleton to a bound character, which are saved with it. A bare mesh is rigged first.
 *   motion  null: a clip that ships, for a character that is of a picture (sinew_character_open_picture()) alone: that of its class */
SINEW_API sinew_status sinew_character_animate(sinew_character* character, sinew_character* motion,
                                               const sinew_character_animate_options* options,
                                               sinew_character_animate_result* result);

/* `sinew pose`: one of four says the pose, the others are null (a clip: null name). */
typedef struct sinew_character_pose_options {
  uint32_t struct_size; /* sizeof(sinew_character_pose_options) */
  uint32_t thread_count;
  uint32_t deform;         /* sinew_pose_deform */
  uint32_t cells, rounds;  /* of the deformer; 0 = its own */
  uint32_t body_contact;   /* 1: with SINEW_POSE_VOLUME or SINEW_POSE_XPBD */
  const double* angles;    /* [J x 3] joints turned about x, then y, then z, in degrees */
  const double* rotations; /* [J x 4] x y z w, local, against the rest pose */
  const double* matrices;  /* [J x 12] row-major 3x4, rest to posed space */
  const char* clip;        /* of the character's own, by name or number */
  double time;             /* second of the clip */
  double stiffness;        /* SINEW_POSE_XPBD, as in sinew_character_animate_options, and the two below */
  uint32_t tet_weights;    /* sinew_tet_weights */
  uint32_t no_smoothing;
} sinew_character_pose_options;

/* A copy of a bound character in a pose; saved as .obj, or viewed.
 *   posed  out, closed by sinew_character_close() */
SINEW_API sinew_status sinew_character_pose(sinew_character* character, const sinew_character_pose_options* options,
                                            sinew_character** posed);

/* `sinew transfer` */
typedef struct sinew_character_transfer_options {
  uint32_t struct_size; /* sizeof(sinew_character_transfer_options) */
  uint32_t thread_count;
  sinew_progress progress;
  void* progress_user;
  const sinew_character_models* models; /* null: bundled */
  uint32_t method;                      /* sinew_transfer_method */
  uint32_t influence_count;             /* 1..12; 0 = 4 */
  uint32_t target_up, source_up;        /* sinew_up; 0 = Y */
  uint32_t garment;                     /* 1: the target is worn by the source */
  uint32_t as_drawn;                    /* 1: of SINEW_TRANSFER_BIHARMONIC */
  uint32_t heat;                        /* 1: binds by heat alone, without a model */
  uint32_t pair_count;
  const sinew_vertex_pair* pairs; /* [pair_count] of SINEW_TRANSFER_BIHARMONIC; or null */
  const uint8_t* locked;          /* [V] of the target; or null */
  const char* map;                /* a map file; null: found */
} sinew_character_transfer_options;

typedef struct sinew_character_transfer_result {
  uint32_t struct_size;   /* sizeof(sinew_character_transfer_result) */
  uint32_t mapped_joints; /* of the source */
  uint32_t fitted;        /* 1: the target had no skeleton and has the source's */
  uint32_t bound;         /* 1: something was bound anew */
  uint32_t bound_by;      /* sinew_method */
  uint32_t part_count;
  double carried, style, mismatch; /* see sinew_transfer_outputs, as numbers */
  double seconds;
  const char* mapped_by;
  const sinew_transfer_part* parts; /* [part_count] by falling size */
} sinew_character_transfer_result;

/* Carries the weights of a bound character to the target's mesh, which keeps its skeleton or gets the source's, fitted. */
SINEW_API sinew_status sinew_character_transfer(const sinew_character* source, sinew_character* target,
                                                const sinew_character_transfer_options* options,
                                                sinew_character_transfer_result* result);

/* `sinew simplify` */
typedef struct sinew_character_simplify_options {
  uint32_t struct_size; /* sizeof(sinew_character_simplify_options) */
  uint32_t low;         /* 0 = high: bone ends, helpers, faces, twists; 1: fingers and small parts too */
  uint32_t joint_count; /* not 0: so many are left */
  uint32_t keep_count;
  const char* const* keep; /* [keep_count] joints that stay; or null */
} sinew_character_simplify_options;

/* Leaves joints out; weights and the file's own animations follow. The body stays at both levels; at the high one vertices move
 * by less than 1 % of the height in these animations.
 *   into  out [J before] the joint, of those before, that each is part of now; or null */
SINEW_API sinew_status sinew_character_simplify(sinew_character* character,
                                                const sinew_character_simplify_options* options, uint32_t* into);

#define SINEW_MAX_LOD_LEVELS 8

/* `sinew lod` */
typedef struct sinew_character_lod_options {
  uint32_t struct_size;  /* sizeof(sinew_character_lod_options) */
  uint32_t level_count;  /* 1..SINEW_MAX_LOD_LEVELS; 0 = 3 */
  double ratio;          /* triangles of a level, as a share of the one before, 0.05..0.95; 0 = 0.5 */
  uint32_t fewer_joints; /* 1: level 2 has the joints of sinew_character_simplify(), further ones of its low level */
  uint32_t reserved;     /* 0 */
} sinew_character_lod_options;

/* How far a level is from the whole character, shares of its height. */
typedef struct sinew_character_lod_level {
  double rest_error;  /* largest distance of a vertex from the level's surface */
  double posed_error; /* the same in the worst of the poses that bodies are bent in */
  double mean_error;  /* the mean in that pose */
  uint32_t triangle_count;
  uint32_t reserved; /* 0 */
} sinew_character_lod_level;

/* Copies of a bound character with fewer and fewer triangles; weights, shapes, seams and materials stay with what is left.
 *   levels   out [level_count, 3 where it is 0], each closed by sinew_character_close(); untouched on failure
 *   figures  out, as many; or null
 * One that has clips or morph targets of other calls is SINEW_ERROR_INPUT: it is saved and opened first. */
SINEW_API sinew_status sinew_character_lod(sinew_character* character, const sinew_character_lod_options* options,
                                           sinew_character** levels, sinew_character_lod_level* figures);

/* `sinew check` */
typedef enum sinew_check_severity {
  SINEW_CHECK_NOTE = 0,
  SINEW_CHECK_WARNING = 1,
  SINEW_CHECK_ERROR = 2
} sinew_check_severity;

/* Something that is wrong with a rig. */
typedef struct sinew_character_finding {
  const char* rule;         /* "left-right"; sinew_character_check_rules() lists them */
  const char* what;         /* one line of English */
  const char* cure;         /* what to do, one line */
  const char* pose;         /* test pose in which it shows; "": none */
  const char* clip;         /* animation in which it shows; "": none */
  double seconds;           /* in the clip */
  double value, bound;      /* what was measured, and above which it is a finding */
  const uint32_t* vertices; /* [vertex_count] ascending; null where it is about joints or clips */
  uint32_t vertex_count;
  uint32_t severity;    /* sinew_check_severity */
  int32_t joint, other; /* that it is about, and that it is compared with; -1: none */
  int32_t mesh;         /* where all its vertices lie in one; -1: none */
  float position[3];    /* where to look, and how far around it, the mesh's units */
  float radius;
  uint32_t reserved; /* 0 */
} sinew_character_finding;

typedef struct sinew_character_check_options {
  uint32_t struct_size; /* sizeof(sinew_character_check_options) */
  uint32_t no_poses;    /* 1: the mesh is not posed: no tears, lost volume, flips, crossings */
  uint32_t no_clips;    /* 1: animations are not looked at */
  uint32_t bound_count;
  const char* const* bound_rules; /* [bound_count] rules that get other bounds; or null */
  const double* bounds;           /* [bound_count] */
  uint32_t score;                 /* 1: the result has a score */
  uint32_t reserved;              /* 0 */
} sinew_character_check_options;

typedef struct sinew_character_check_result {
  uint32_t struct_size; /* sizeof(sinew_character_check_result) */
  uint32_t finding_count;
  uint32_t errors, warnings, notes;
  uint32_t reserved;                       /* 0 */
  const sinew_character_finding* findings; /* [finding_count] errors first */
  const char* line;                        /* "checked: 0 findings" */
  double
      score; /* with score: how near the weights are to those of three methods, 0..100; -1 where it was not asked for */
} sinew_character_check_result;

/* Looks for what is wrong with the skeleton, the weights, the matrices and the animations; changes nothing. A character without joints is
 * SINEW_ERROR_INPUT. */
SINEW_API sinew_status sinew_character_check(sinew_character* character, const sinew_character_check_options* options,
                                             sinew_character_check_result* result);
/* Names of the rules, a space between two. Static. */
SINEW_API const char* sinew_character_check_rules(void);

/* `sinew bake` */
typedef struct sinew_character_bake_options {
  uint32_t struct_size; /* sizeof(sinew_character_bake_options) */
  uint32_t reserved;    /* 0 */
  sinew_progress progress;
  void* progress_user;
  uint32_t deform;        /* sinew_pose_deform; 0 = SINEW_POSE_VOLUME */
  uint32_t cells, rounds; /* of the deformer; 0 = its own */
  uint32_t body_contact;  /* 1: as in sinew_character_animate_options */
  uint32_t poses;         /* to learn from; 0 = 1500 */
  uint32_t shapes;        /* a bend; 0 = 8 */
  uint64_t seed;          /* of the poses; 0 = 1 */
  double limit;           /* largest angle, degrees; 0 = 60 */
  const char* clip;       /* learn from a clip of the character's own; null: random poses */
  double stiffness;       /* SINEW_POSE_XPBD, as in sinew_character_animate_options, and the two below */
  uint32_t tet_weights;   /* sinew_tet_weights */
  uint32_t no_smoothing;
} sinew_character_bake_options;

typedef struct sinew_character_bake_result {
  uint32_t struct_size; /* sizeof(sinew_character_bake_result) */
  uint32_t shape_count, bend_count, moved_vertices;
  uint32_t learnt_poses, held_out_poses;
  double linear_error, baked_error;                   /* of the poses that were learnt, shares of the size */
  double held_out_linear_error, held_out_baked_error; /* of others */
} sinew_character_bake_result;

/* Adds morph targets that correct bends, with what drives them, which are saved with the character. */
SINEW_API sinew_status sinew_character_bake(sinew_character* character, const sinew_character_bake_options* options,
                                            sinew_character_bake_result* result);

#ifdef __cplusplus
}
#endif
#endif
