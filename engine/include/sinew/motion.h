/* SPDX-License-Identifier: MIT
 * Retargeting: plays a motion of one skeleton on another. A plan is created once per pair of skeletons and map; then
 * each frame takes one call. Same bytes on every platform. */
#ifndef SINEW_MOTION_H
#define SINEW_MOTION_H

#include "sinew/skeleton.h"
#include "sinew/skin.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A pose is an array of local rotations [J x 4], x y z w, and an array of local translations [J x 3], both in the
 * axes of the joint's parent, or of the world for a root. */

typedef enum sinew_retarget_method {
  SINEW_RETARGET_AUTO = 0, /* the best method for the inputs */
  /* A mapped joint rotates like its source. Upper and lower arms and legs point in the directions of the source's,
   * whatever the rest poses are. Joints without a source follow their parents. Feet and hands that are not children
   * of their limbs (as for inverse kinematics) follow these if the source's are. Translations of the hips, and of
   * joints that move relative to their parents and are not bones of the torso, arms or legs, are scaled by the ratio
   * of the leg lengths. Contacts are a separate step: sinew_retarget_contacts() */
  SINEW_RETARGET_COPY = 1,
  /* The published node alignment, for comparison: at rest, each mapped joint has an offset (a rotation and a scaled
   * translation) from its source; the moving source's frame times that offset is the joint's frame. Bone lengths
   * change, and the floor is the source's */
  SINEW_RETARGET_NODE_OFFSETS = 2
} sinew_retarget_method;

/* Options of a plan: inputs only. Start from SINEW_INIT(sinew_retarget_options), which sets every default. Later
 * versions add members at the end, whose value 0 keeps this version's behavior; see struct_size in sinew/types.h. */
typedef struct sinew_retarget_options {
  uint32_t struct_size;  /* sizeof(sinew_retarget_options) */
  uint32_t method;       /* sinew_retarget_method */
  uint32_t in_place;     /* 1: the target stays above its rest position */
  float scale;           /* target length per source length; 0 = from the legs, or without legs from all mapped bones */
  uint32_t translations; /* 1: bones of the torso, arms and legs stretch like the source's. Between rigs with equal rest
                     * poses they always do */
  float arm_spread; /* degrees, -90..90, by which both arms rotate at the shoulders, in every frame, away from the plane
                     * between left and right, or towards it if below 0; fades to none for an arm that points sideways.
                     * 0 = as in the source. Contacts are kept afterwards */
} sinew_retarget_options;

/* A plan in the caller's memory. It holds pointers into that memory, which must not be moved. */
typedef struct sinew_retarget sinew_retarget;

/* Returns the bytes that sinew_retarget_create() needs for skeletons of these counts. A pure function of its
 * arguments: the same on every host with the same pointer size.
 *   size_bytes  out, 0 on failure
 * Returns SINEW_OK, SINEW_ERROR_ARGUMENT or SINEW_ERROR_COUNT. */
SINEW_API sinew_status sinew_retarget_create_workspace_size(uint32_t source_joints, uint32_t target_joints,
                                                            size_t* size_bytes);

/* Creates a plan.
 *   map             [target->joint_count] source joint of each target joint, or -1. Several may share a source
 *   target_classes  [target->joint_count] sinew_joint_class, to find arms and legs. Joints outside the body have
 *                   SINEW_CLASS_OTHER. null = all have it; rest poses must then agree
 *   options         null = all defaults
 *   memory          64-byte aligned, size from sinew_retarget_create_workspace_size(); in use until the last call
 *                   with the plan
 *   plan            out; untouched on failure
 * The up axes of the two skeletons may differ. Of the rotations by multiples of 90 degrees that align the up axes,
 * the plan uses the one that brings mapped joints nearest to each other at rest. If the legs then still differ in
 * direction by more than 3 degrees around the up axis, the source is rotated by that angle too: it may face any
 * direction.
 *
 * Returns SINEW_OK, or
 *   SINEW_ERROR_ARGUMENT    a pointer that must be set is null, struct_size is too small or above 4096, an option is
 *                           out of range
 *   SINEW_ERROR_NOT_BUILT   the library was built without it (SINEW_SMALL_CODE), as for all calls below
 *   SINEW_ERROR_VERSION     a member unknown to this library is not 0
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

/* Returns the height of the lower ankle in one source frame, in the source's units; without legs, of the lowest
 * mapped joint. Input of sinew_retarget_ground().
 * Returns SINEW_OK, SINEW_ERROR_ARGUMENT or SINEW_ERROR_NOT_FINITE. */
SINEW_API sinew_status sinew_retarget_height(sinew_retarget* plan, const float* rotations, const float* translations,
                                             float* height);

/* Returns the height of a standing ankle in a clip: the 5th percentile of its frames' heights. If the source at rest
 * stands on the clip's floor, returns its ankle height at rest. It does so if its lowest joint is within 20 % of a
 * leg length of the origin's height, or if the two heights are within 5 % of a leg length. An exception is a clip
 * whose feet stay 25 % to 100 % of a leg length above that height: it has its own floor.
 *   heights  [count] from sinew_retarget_height(); sorted on return. None: the height of the source at rest
 * Returns SINEW_OK, SINEW_ERROR_ARGUMENT or SINEW_ERROR_NOT_FINITE. */
SINEW_API sinew_status sinew_retarget_ground(const sinew_retarget* plan, float* heights, size_t count, float* ground);

/* Retargets one frame. A plan has its scratch in its memory: one thread at a time.
 *   rotations, translations          [source joints x 4], [source joints x 3] the source's pose. Rotations need not have
 *                                    length 1; length 0 is the identity
 *   ground                           height of a standing ankle in this clip, from sinew_retarget_ground()
 *   out_rotations, out_translations  [target joints x 4], [target joints x 3] the target's pose; must not overlap inputs
 * Returns SINEW_OK, or with outputs untouched SINEW_ERROR_ARGUMENT or SINEW_ERROR_NOT_FINITE. */
SINEW_API sinew_status sinew_retarget_frame(sinew_retarget* plan, const float* rotations, const float* translations,
                                            float ground, float* out_rotations, float* out_translations);

/* A skinned mesh of a skeleton, borrowed for the duration of a call. */
typedef struct sinew_motion_body {
  const float* positions;    /* [vertex_count x 3] at rest, in the world */
  const uint32_t* triangles; /* [triangle_count x 3] */
  sinew_skin skin;           /* of SINEW_WEIGHT_UNORM16 */
  uint32_t vertex_count;
  uint32_t triangle_count;
} sinew_motion_body;

#define SINEW_MAX_FLOOR_SIDE 4096u

/* An uneven floor: heights on a regular grid over the two horizontal axes of the target's world, in the order x, y,
 * z. Heights are interpolated bilinearly, and constant beyond the edges. A grid works equally from every language,
 * unlike a callback, and is checked once. This struct never changes. */
typedef struct sinew_floor {
  const float* heights; /* [rows x columns] above the level floor that the target stands on at rest */
  uint32_t columns;     /* along the first axis, 1..SINEW_MAX_FLOOR_SIDE */
  uint32_t rows;        /* along the second */
  float first[2];       /* position of the first height along the two axes */
  float step;           /* distance between heights, above 0 */
  uint32_t reserved;    /* 0 */
} sinew_floor;

/* Start from SINEW_INIT(sinew_contact_options). Later versions add members at the end, as in sinew_retarget_options. */
typedef struct sinew_contact_options {
  uint32_t struct_size;    /* sizeof(sinew_contact_options) */
  float fps;               /* frames per second; 0 = 30 */
  sinew_progress progress; /* or null */
  void* progress_user;
  const sinew_floor* floor; /* floor of the target (the source's is level); null: level */
} sinew_contact_options;

/* Consecutive frames of a clip. */
typedef struct sinew_motion_clip {
  const float* source_rotations;    /* [frame_count x source joints x 4] as in sinew_retarget_frame() */
  const float* source_translations; /* [frame_count x source joints x 3] */
  float* rotations;    /* [frame_count x target joints x 4] in: from sinew_retarget_frame(); out: changed */
  float* translations; /* [frame_count x target joints x 3] the same */
  uint32_t frame_count;
  float ground; /* of sinew_retarget_ground() */
} sinew_motion_clip;

/* Returns the bytes that sinew_retarget_contacts() needs.
 *   size_bytes  out, 0 on failure
 * Returns SINEW_OK, SINEW_ERROR_ARGUMENT, or SINEW_ERROR_COUNT if the size does not fit into size_t. */
SINEW_API sinew_status sinew_retarget_contacts_workspace_size(const sinew_retarget* plan,
                                                              const sinew_motion_body* target, uint32_t frame_count,
                                                              size_t* size_bytes);

/* Keeps contacts in a clip that sinew_retarget_frame() made, by bending arms and legs:
 *   feet   a foot that is planted in the source stays in place in the target, at the source's height above the floor
 *   floor  other parts on the source's floor are on the target's too: hands, knees, elbows, seat, chest and head, by
 *          the height of the body and the pitch of its torso, then limb by limb. No correction if only feet are near
 *          the floor
 *   hands  a hand near a point of the source's body is moved near the same point of the target's body
 *   depth  hands and forearms inside the target's body are moved out, except for the depth that they have in the
 *          source's body
 * On an uneven floor the body is raised by the floor height under the lower foot. Bones keep their lengths, hands and
 * feet their rotations. Whole clips only: each frame depends on the frames before and after it.
 *   source  the source's body, with the same vertices and triangles as the target's (its `triangles` are ignored);
 *           null: feet are tracked by their joints only, and arms may be as deep in the target's body as at rest
 * Limbs are found by the plan's map and classes: both bones of a limb must be mapped.
 * Returns SINEW_OK, or with the clip untouched
 *   SINEW_ERROR_ARGUMENT    a pointer that must be set is null, the vertex counts of the two bodies differ,
 *                           struct_size, fps or weight_format is out of range
 *   SINEW_ERROR_VERSION     a member behind those that this library knows is not 0
 *   SINEW_ERROR_COUNT       a body without vertices, or a count above the limits
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
