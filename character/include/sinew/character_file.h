/* SPDX-License-Identifier: MIT
 * Characters from files, memory and arrays, and back: include sinew/character.h, which describes what all calls
 * share. */
#ifndef SINEW_CHARACTER_FILE_H
#define SINEW_CHARACTER_FILE_H

#include "sinew/sinew.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Beside the numbers of sinew_status. Numbers are never reused. */
#define SINEW_ERROR_INPUT ((sinew_status)-30)  /* a file, an array or a name cannot be used: the error line says why */
#define SINEW_ERROR_MEMORY ((sinew_status)-31) /* memory is exhausted */

/* An open character. */
typedef struct sinew_character sinew_character;

/* Returns the line of this character's last call that failed; for null, of this thread's last call that failed, whatever its
 * character. Never null, "" where none failed. Valid until the next call that fails. */
SINEW_API const char* sinew_character_error(const sinew_character* character);

/* Returns the library's sizeof of a struct, for bindings: see sinew_struct_size() in sinew/abi.h.
 *   name  "sinew_character_clip"; null or an unknown name: 0 */
SINEW_API size_t sinew_character_struct_size(const char* name);

/* ---- files ---- */

/* A file in memory. */
typedef struct sinew_file {
  /* Name with the extension of its format: "hero.glb". */
  const char* name;
  const void* bytes;
  size_t size_bytes;
} sinew_file;

/* Uses of a file format. */
typedef enum sinew_file_use {
  SINEW_READ_MESH = 1,        /* a mesh, with or without a skeleton */
  SINEW_READ_SKELETON = 2,    /* joints */
  SINEW_READ_MOTION = 4,      /* clips */
  SINEW_READ_WHOLE = 8,       /* mesh, skeleton and weights in one file */
  SINEW_WRITE_CHARACTER = 16, /* mesh, skeleton and weights */
  SINEW_WRITE_MOTION = 32,    /* clips */
  SINEW_WRITE_MESH = 64,      /* a mesh alone: poses */
  SINEW_READ_PICTURE = 256    /* a drawing or a photograph: sinew_character_open_picture() */
} sinew_file_use;

/* Returns the extensions of files that have all of these uses, separated by spaces: ".obj .gltf .glb". For file
 * dialogs. Static; "" where no file has them.
 *   uses  bits of sinew_file_use */
SINEW_API const char* sinew_character_extensions(uint32_t uses);

/* Opens a file by its extension. A .obj is opened with the NAME.rig.txt beside it, a .rig.txt with its NAME.obj. A .bvh,
 * .vrma, .npz, .npy or .vmd, or a .rig.txt alone, is a skeleton without a mesh. A .png or .jpg is a picture of a character
 * with every default of sinew_character_open_picture(). builtin:NAME is a bundled clip for sinew_character_animate(), which
 * takes the one for the character's kind of body.
 *   character  out, closed by sinew_character_close(); untouched on failure */
SINEW_API sinew_status sinew_character_open(const char* path, sinew_character** character);

/* Opens a file in memory, without access to the disk. Bytes are copied.
 *   files  the file, then the files beside it (.bin, pictures, .mtl, .rig.txt) under the names that it has for them */
SINEW_API sinew_status sinew_character_open_files(const sinew_file* files, uint32_t file_count,
                                                  sinew_character** character);

/* Opens a person's keypoints (joint positions without rotations, as cameras record them) as a motion: a skeleton with bones
 * of the median length in these frames, and the frames as its clip. Up axis, mirrored coordinates and positions relative to
 * the hips are detected; sinew_character_notes() lists what was found. One frame is enough, a second or two are better.
 *   layout     "smpl24", "humanml3d22", "lafan22", "smplh52", "smplx55", "coco17", "h36m17", "h36m32", "kinect25",
 *              "openpose25" or "mediapipe33"
 *   keypoints  [frame_count x keypoint_count x 3] any unit; keypoint_count is the number in the layout's name
 *   character  out; untouched on failure */
SINEW_API sinew_status sinew_character_open_keypoints(const char* layout, const float* keypoints,
                                                      uint32_t keypoint_count, uint32_t frame_count,
                                                      sinew_character** character);
/* Converts a further frame, which does not depend on other frames, to the input of sinew_retarget_stream_frame() for a source
 * with this character's skeleton of J joints.
 *   character     of sinew_character_open_keypoints()
 *   keypoints     [keypoint_count x 3] in the units of the first ones
 *   rotations     out [J x 4] x y z w, local; untouched on failure
 *   translations  out [J x 3] in the parents' axes; untouched on failure */
SINEW_API sinew_status sinew_character_keypoints_frame(const sinew_character* character, const float* keypoints,
                                                       uint32_t keypoint_count, float* rotations, float* translations);

/* Makes a character of arrays, which are copied.
 *   mesh       null: a skeleton alone
 *   skeleton   null: a mesh alone. Names are unique; null: joint0, joint1, ... Joints with SINEW_JOINT_NEVER do not deform,
 *              those with SINEW_JOINT_DEFORMS do. ends, rotations and up are ignored
 *   character  out; untouched on failure
 * Returns also SINEW_ERROR_COUNT, SINEW_ERROR_NOT_FINITE, SINEW_ERROR_INDEX and SINEW_ERROR_HIERARCHY. */
SINEW_API sinew_status sinew_character_create(const sinew_mesh* mesh, const sinew_skeleton* skeleton,
                                              sinew_character** character);

/* Makes an independent copy.  character  out; untouched on failure */
SINEW_API sinew_status sinew_character_copy(const sinew_character* from, sinew_character** character);
/* Frees a character; null is allowed. */
SINEW_API void sinew_character_close(sinew_character* character);

/* Saves by the extension: .glb; .gltf with NAME.bin beside it; .fbx; .vrm where the input was one; .obj with NAME.rig.txt
 * where there are joints; .rig.txt; .bvh of the one clip; .vrma of all clips, for any VRM. A glTF keeps everything in
 * its input that was not changed. */
SINEW_API sinew_status sinew_character_save(sinew_character* character, const char* path);

/* Saves to memory.
 *   name        with the extension of its format: "hero.glb"
 *   files       out: what sinew_character_save() would write, the file itself first
 *   file_count  out */
SINEW_API sinew_status sinew_character_write(sinew_character* character, const char* name, const sinew_file** files,
                                             uint32_t* file_count);

/* `--for`: options for the file of another program. */
typedef struct sinew_character_profile_options {
  uint32_t struct_size;
  /* 1: axes, names and roots of the skeleton stay as they are. */
  uint32_t keep_axes;
  /* One of sinew_character_profiles(): "mixamo", "vrm"; null = none, files as they were read. */
  const char* profile;
  /* License of a VRM, in the words of its format; null = nothing is allowed. */
  const char* license;
  /* Title of a VRM; null = the character's name. */
  const char* title;
  /* [author_count] Authors of a VRM; null: those of its file, else "unknown" with a note. */
  const char* const* authors;
  uint32_t author_count;
  /* 1: a glTF has the text of sinew_character_controls() in its extras. */
  uint32_t controls;
} sinew_character_profile_options;

/* Sets what sinew_character_save() and sinew_character_write() write: joint names and axes, a root, influences, facing, VRM
 * data. The rest pose stays: see to_pose of bind and rig ("t" for most programs, "a" for unreal). Remarks are added to
 * sinew_character_notes() as files are written. An unknown profile is SINEW_ERROR_INPUT. */
SINEW_API sinew_status sinew_character_set_profile(sinew_character* character,
                                                   const sinew_character_profile_options* options);
/* Returns the names of the profiles, separated by spaces. Static. */
SINEW_API const char* sinew_character_profiles(void);

/* `--controls`: lists the joints that an animator's controls move, in the skeleton as it would be saved.
 *   text  out: JSON as formats/spec/controls.md has it, with a final line break
 * A character without joints is SINEW_ERROR_INPUT. */
SINEW_API sinew_status sinew_character_controls(sinew_character* character, const char** text);

/* ---- arrays ---- */

/* A character's arrays, borrowed. */
typedef struct sinew_character_arrays {
  uint32_t struct_size;
  /* V: vertices; 0: a skeleton alone. */
  uint32_t vertex_count;
  /* F: faces. */
  uint32_t face_count;
  /* Length of face_vertices. */
  uint32_t corner_count;
  /* J: joints; 0: a mesh alone. */
  uint32_t joint_count;
  /* M: meshes of the file; 0: not known (OBJ, arrays). */
  uint32_t mesh_count;
  /* Influences of the longest row; 0: no weights. */
  uint32_t influence_count;
  uint32_t reserved;
  /* The file's name without its extension. */
  const char* name;
  /* [V x 3] Vertices in the pose that the weights are meant for. */
  const float* positions;
  /* [F + 1] CSR offsets into face_vertices. */
  const uint32_t* face_offsets;
  /* [corner_count] Vertices of the faces. */
  const uint32_t* face_vertices;
  /* [J x 3] Joints at rest, in the mesh's units. */
  const float* joint_positions;
  /* [J] Parents, in any order; -1 = a root. */
  const int32_t* parents;
  /* [J] Unique names. */
  const char* const* joint_names;
  /* [V + 1] CSR offsets of the weights; null without weights. A row may be empty. */
  const uint32_t* row_offsets;
  /* [row_offsets[V]] Joints of the weights. */
  const uint32_t* joint_indices;
  /* [row_offsets[V]] */
  const float* weights;
  /* [V] 0..255, of the last bind or transfer; or null. */
  const uint8_t* confidence;
  /* [V] Mesh of each vertex; or null. */
  const uint32_t* vertex_meshes;
  /* [M] */
  const char* const* mesh_names;
  /* [M] The joint that carries a mesh without a skin, or -1. */
  const int32_t* mesh_joints;
  /* [M] 1: the mesh has a skin. */
  const uint8_t* mesh_skinned;
} sinew_character_arrays;

/* Gives the arrays.  arrays  out */
SINEW_API sinew_status sinew_character_view(sinew_character* character, sinew_character_arrays* arrays);

/* Copies the strongest weights of each row, as unorm16, rounded as sinew_bind() rounds. A row without weight is all 0.
 *   influence_count  1..SINEW_MAX_INFLUENCES
 *   joint_indices, weights  out [V x influence_count] */
SINEW_API sinew_status sinew_character_skin(const sinew_character* character, uint32_t influence_count,
                                            uint16_t* joint_indices, uint16_t* weights);

/* Classifies each joint as retargeting does.  classes  out [J] sinew_joint_class */
SINEW_API sinew_status sinew_character_joint_classes(const sinew_character* character, uint8_t* classes);

/* Returns notes and warnings of the reader and the jobs for the user, one per line; "" for none. */
SINEW_API const char* sinew_character_notes(sinew_character* character);

/* Replaces the skeleton and removes the weights.  skeleton  as in sinew_character_create() */
SINEW_API sinew_status sinew_character_set_skeleton(sinew_character* character, const sinew_skeleton* skeleton);
/* Replaces the skeleton by another character's, as `sinew bind --skeleton FILE` does.
 *   with_weights  1: with its weights; it has as many vertices */
SINEW_API sinew_status sinew_character_take_skeleton(sinew_character* character, const sinew_character* other,
                                                     uint32_t with_weights);

/* Sets weights from CSR arrays, which are copied. Rows need not sum to 1.
 *   row_offsets    [V + 1] rising from 0, else SINEW_ERROR_INDEX
 *   joint_indices  [row_offsets[V]] no joint twice in a row, else SINEW_ERROR_RANGE
 *   weights        [row_offsets[V]] 0 or more, else SINEW_ERROR_RANGE */
SINEW_API sinew_status sinew_character_set_weights(sinew_character* character, const uint32_t* row_offsets,
                                                   const uint32_t* joint_indices, const float* weights);

/* ---- clips ---- */

/* A clip: poses of the character's skeleton and, in a file, of animated nodes around it. At rest all joints have the axes of
 * the world. */
typedef struct sinew_character_clip {
  uint32_t struct_size;
  /* F: frames. */
  uint32_t frame_count;
  /* N: the character's J joints in their order, then other nodes. */
  uint32_t joint_count;
  uint32_t reserved;
  /* Seconds from one frame to the next. */
  double frame_time;
  const char* name;
  /* [F x N x 4] x y z w, local, relative to the rest pose. */
  const double* rotations;
  /* [F x N x 3] from the parent. */
  const double* translations;
  /* [N] */
  const char* const* joint_names;
  /* [N] */
  const int32_t* parents;
} sinew_character_clip;

/* Counts the file's clips and those that were added.  count  out; 0 for a file without motion */
SINEW_API sinew_status sinew_character_clip_count(sinew_character* character, uint32_t* count);
/* Gives a clip: the file's come first.  clip  out */
SINEW_API sinew_status sinew_character_get_clip(sinew_character* character, uint32_t index, sinew_character_clip* clip);
/* Adds a clip, which is saved as an animation.  clip  joint_count is J; joint_names and parents are ignored */
SINEW_API sinew_status sinew_character_add_clip(sinew_character* character, const sinew_character_clip* clip);

/* ---- transform ---- */

/* `--turn`, `--height` and `--floor`, in this order. */
typedef struct sinew_character_transform_options {
  uint32_t struct_size;
  uint32_t turn_count;
  /* [turn_count] Rotations by 90 degrees about an axis through the origin, in order: "x", "-x", "y", ...; or null. */
  const char* const* turns;
  /* Height in meters along up; 0 = unchanged. */
  double height;
  /* 1: the lowest vertex is moved to 0 along up. */
  uint32_t floor;
  /* sinew_up after the rotations; 0 = Y. */
  uint32_t up;
} sinew_character_transform_options;

/* Rotates and scales the whole character: mesh, joints, the file's own animations. Weights stay. A picture, a
 * character without a mesh, and one to which a call has added clips or morph targets are SINEW_ERROR_INPUT. */
SINEW_API sinew_status sinew_character_transform(sinew_character* character,
                                                 const sinew_character_transform_options* options);

#ifdef __cplusplus
}
#endif
#endif
