/* SPDX-License-Identifier: MIT
 * Motion: plays what was recorded on one skeleton on another one. A plan is made once per pair of skeletons and map, then
 * one call per frame. Same bytes on every platform. */
#ifndef SINEW_MOTION_H
#define SINEW_MOTION_H

#include "sinew/skeleton.h"
#include "sinew/skin.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A pose of a skeleton is an array of local rotations [J x 4], x y z w, and one of local translations [J x 3], both in the
 * axes of the joint's parent, or of the world for a root. */

typedef enum sinew_retarget_method {
  SINEW_RETARGET_AUTO = 0, /* the best that this library has for the inputs */
  /* A mapped joint rotates as its source does. Upper and lower arms and legs point in the directions of the source's,
   * whatever the rest poses are. Joints without a source follow their parents. Feet and hands that hang elsewhere than on
   * their limbs, for inverse kinematics, go with them where the source's hang on theirs. Translations of the hips, and of joints that
   * move against their parents but are no bone of trunk, arms or legs, are scaled by the ratio of the legs. Contacts come after it: sinew_retarget_contacts() */
  SINEW_RETARGET_COPY = 1,
  /* The published node alignment, for comparison: at rest, every mapped joint has an offset, a rotation and a scaled
   * translation, from its source; the frame of the moving source times that offset is the joint's frame. Bones keep no length,
   * and the floor is the source's */
  SINEW_RETARGET_NODE_OFFSETS = 2
} sinew_retarget_method;

/* What a plan is asked to do: inputs only. Start from SINEW_INIT(sinew_retarget_options), which asks for every default. Later
 * versions add members at the end, and 0 asks for what this version does; see struct_size in sinew/types.h. */
typedef struct sinew_retarget_options {
  uint32_t struct_size; /* sizeof(sinew_retarget_options) */
  uint32_t method;      /* sinew_retarget_method */
  uint32_t in_place;    /* 1: the target stays above where it stands at rest */
  float scale;          /* lengths of the target per length of the source; 0 = by their legs, else by all mapped
                         * bones */
  uint32_t
      translations; /* 1: bones of trunk, arms and legs stretch as the source's do. Between rigs that lie alike they do
                          * anyway */
} sinew_retarget_options;

/* A plan; it lies in the caller's memory, holds pointers into it and must not be moved. */
typedef struct sinew_retarget sinew_retarget;

/* Bytes sinew_retarget_create() needs for skeletons of these counts. A pure function of its arguments: the same on every host
 * with pointers of one size.
 *   size_bytes  out, 0 on failure
 * Returns SINEW_OK, SINEW_ERROR_ARGUMENT or SINEW_ERROR_COUNT. */
SINEW_API sinew_status sinew_retarget_create_workspace_size(uint32_t source_joints, uint32_t target_joints,
                                                            size_t* size_bytes);

/* Makes a plan.
 *   map             [target->joint_count] the source joint that a target joint moves as, or -1. Several may have one source
 *   target_classes  [target->joint_count] sinew_joint_class: which bones are arms and legs. What is no joint of a body has
 *                   SINEW_CLASS_OTHER. null = all have it: rest poses must agree then
 *   options         null = all defaults
 *   memory          64-byte aligned, size from sinew_retarget_create_workspace_size(); the plan's until the last call with it
 *   plan            out; untouched on failure
 * The two skeletons' up axes may differ. Of the rotations by quarters that bring one up axis to the other, the one is taken
 * that brings mapped joints nearest to each other at rest. Where legs begin elsewhere round the up axis even so, by more than 3 degrees,
 * the source is turned by that as well: it may face any direction.
 *
 * Returns SINEW_OK, or
 *   SINEW_ERROR_ARGUMENT    a pointer that must be set is null, struct_size is too small or above 4096, an option is out
 *                           of its range
 *   SINEW_ERROR_NOT_BUILT   the library was built without it (SINEW_SMALL_CODE), as of all calls below
 *   SINEW_ERROR_VERSION     a member behind those that this library knows is not 0
 *   SINEW_ERROR_COUNT       no joint, or more than SINEW_MAX_JOINTS
 *   SINEW_ERROR_NOT_FINITE  a position or rotation is NaN or infinite
 *   SINEW_ERROR_INDEX       a parent or a mapped joint does not exist
 *   SINEW_ERROR_HIERARCHY   parents form a cycle
 *   SINEW_ERROR_NO_JOINT    no joint is mapped
 *   SINEW_ERROR_WORKSPACE   the memory is too small or not aligned */
SINEW_API sinew_status sinew_retarget_create(const sinew_skeleton* source, const sinew_skeleton* target,
                                             const int32_t* map, const uint8_t* target_classes,
                                             const sinew_retarget_options* options, void* memory, size_t memory_bytes,
                                             sinew_retarget** plan);

/* How high the lower ankle of one source frame is, in the source's units; of the lowest mapped joint where there are no
 * legs. What sinew_retarget_ground() is made from.
 * Returns SINEW_OK, SINEW_ERROR_ARGUMENT or SINEW_ERROR_NOT_FINITE. */
SINEW_API sinew_status sinew_retarget_height(sinew_retarget* plan, const float* rotations, const float* translations,
                                             float* height);

/* How high a standing ankle of a clip is: the 5th percentile of its frames' heights. The source's own at rest where it
 * stands on the clip's floor: its lowest joint is within 20 % of a leg of the origin's height, or the two heights are
 * within 5 % of a leg of each other. Not so where its feet never come down to that: from 25 % of a leg over it, and less than a whole
 * one, the clip stands on a floor of its own.
 *   heights  [count] of sinew_retarget_height(); sorted on return. None: the source's own at rest
 * Returns SINEW_OK, SINEW_ERROR_ARGUMENT or SINEW_ERROR_NOT_FINITE. */
SINEW_API sinew_status sinew_retarget_ground(const sinew_retarget* plan, float* heights, size_t count, float* ground);

/* One frame. A plan has its scratch in its memory: one thread at a time.
 *   rotations, translations          [source joints x 4], [source joints x 3] the source's pose. Rotations need not be of
 *                                    length 1; one of length 0 is none
 *   ground                           height of a standing ankle in this clip, of sinew_retarget_ground()
 *   out_rotations, out_translations  [target joints x 4], [target joints x 3] the target's pose; must not overlap inputs
 * Returns SINEW_OK, or with outputs untouched SINEW_ERROR_ARGUMENT or SINEW_ERROR_NOT_FINITE. */
SINEW_API sinew_status sinew_retarget_frame(sinew_retarget* plan, const float* rotations, const float* translations,
                                            float ground, float* out_rotations, float* out_translations);

/* A skinned mesh of a skeleton, borrowed for the time of a call. */
typedef struct sinew_motion_body {
  const float* positions;    /* [vertex_count x 3] at rest, in the world */
  const uint32_t* triangles; /* [triangle_count x 3] */
  sinew_skin skin;           /* of SINEW_WEIGHT_UNORM16 */
  uint32_t vertex_count;
  uint32_t triangle_count;
} sinew_motion_body;

#define SINEW_MAX_FLOOR_SIDE 4096u

/* An uneven floor: heights on a regular grid over the two axes of the target's world that are not up, in the order x, y, z; in
 * between by bilinear interpolation, beyond the edges as at them. A grid and no callback, so that every language gives it in the
 * same way and it is checked once. Never changes. */
typedef struct sinew_floor {
  const float* heights; /* [rows x columns] over the level floor, on which the target stands at rest */
  uint32_t columns;     /* along the first axis, 1..SINEW_MAX_FLOOR_SIDE */
  uint32_t rows;        /* along the second */
  float first[2];       /* where the first height is, along the two axes */
  float step;           /* from one height to the next, above 0 */
  uint32_t reserved;    /* 0 */
} sinew_floor;

/* Start from SINEW_INIT(sinew_contact_options). Later versions add members at the end, as in sinew_retarget_options. */
typedef struct sinew_contact_options {
  uint32_t struct_size;    /* sizeof(sinew_contact_options) */
  float fps;               /* frames a second; 0 = 30 */
  sinew_progress progress; /* or null */
  void* progress_user;
  const sinew_floor* floor; /* of the target, the source's is level; null: level as well */
} sinew_contact_options;

/* A clip's frames, one behind the other. */
typedef struct sinew_motion_clip {
  const float* source_rotations;    /* [frame_count x source joints x 4] as in sinew_retarget_frame() */
  const float* source_translations; /* [frame_count x source joints x 3] */
  float* rotations;                 /* [frame_count x target joints x 4] in: of sinew_retarget_frame(); out: changed */
  float* translations;              /* [frame_count x target joints x 3] the same */
  uint32_t frame_count;
  float ground; /* of sinew_retarget_ground() */
} sinew_motion_clip;

/* Bytes sinew_retarget_contacts() needs.
 *   size_bytes  out, 0 on failure
 * Returns SINEW_OK, SINEW_ERROR_ARGUMENT, or SINEW_ERROR_COUNT where that is more than memory can hold. */
SINEW_API sinew_status sinew_retarget_contacts_workspace_size(const sinew_retarget* plan,
                                                              const sinew_motion_body* target, uint32_t frame_count,
                                                              size_t* size_bytes);

/* Keeps contacts in a clip that sinew_retarget_frame() made, by bending arms and legs:
 *   feet   a foot that stands in the source stands still in the target, as high above the floor as the source's
 *   floor  what else of the source is on its floor is on the target's: hands, knees, elbows, seat, chest and head, by the height of the
 *          body and the pitch of its trunk, then limb by limb. Nothing moves where feet alone are near it
 *   hands  a hand near a point of the source's body goes near the same point of the target's body
 *   depth  hands and forearms that are in the target's body come out, but for the depth that they have in the source's body
 * On an uneven floor the body goes as much higher as the floor is under the lower foot.
 * Bones keep their lengths, hands and feet their rotations. Frames before and after are looked at, so it works on whole clips.
 *   source  the body that moved, of the same vertices and triangles as the target's (its `triangles` are not looked at);
 *           null: feet are seen by their joints alone, and arms may be in the target's body as deep as at rest
 * Limbs are found by the plan's map and classes: both bones of a limb must be mapped.
 * Returns SINEW_OK, or with the clip untouched
 *   SINEW_ERROR_ARGUMENT    a pointer that must be set is null, the two bodies have not as many vertices, struct_size,
 *                           fps or weight_format is out of its range
 *   SINEW_ERROR_VERSION     a member behind those that this library knows is not 0
 *   SINEW_ERROR_COUNT       a body without vertices, or more of anything than the limits
 *   SINEW_ERROR_RANGE       a weight's joint does not exist
 *   SINEW_ERROR_INDEX       a triangle's vertex does not exist
 *   SINEW_ERROR_NOT_FINITE  a number is NaN or infinite
 *   SINEW_ERROR_WORKSPACE   the workspace is too small or not aligned
 * or with the clip in an undefined state SINEW_ERROR_CANCELLED. */
SINEW_API sinew_status sinew_retarget_contacts(sinew_retarget* plan, const sinew_motion_body* source,
                                               const sinew_motion_body* target, const sinew_motion_clip* clip,
                                               const sinew_contact_options* options, void* workspace,
                                               size_t workspace_bytes);

#ifdef __cplusplus
}
#endif
#endif
