/* SPDX-License-Identifier: MIT
 * Simplification: merges joints of a skeleton into their parents, for levels of detail. */
#ifndef SINEW_SIMPLIFY_H
#define SINEW_SIMPLIFY_H

#include "sinew/skeleton.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Level of detail. Published conditions: a joint may be merged into its parent if one of the two has three bones or
 * more (`branch`), if it moves less of the surface than `area`, or if its bone is shorter than `length` (share of the
 * diagonal of the joints' box). Added by sinew: anatomy, see sinew_joint_classes(). Pelvis, the first and the last
 * joint of a spine, head, upper and lower arms and legs, hands and feet stay at both levels. Bone ends, controls,
 * slots, twists, helpers and faces are merged first, then fingers. Of other joints `branch` merges only small leaves. */
typedef enum sinew_simplify_level {
  SINEW_SIMPLIFY_HIGH = 0, /* details: `branch`, and bone ends. Small: length below 1.2 % and below 0.1 % of the
                            * surface */
  SINEW_SIMPLIFY_LOW = 1   /* details: `branch`, `area` 0.6 %, `length` 4 %; all twists, helpers, faces and fingers.
                            * Small: length below 8 % and below 2 % of the surface */
} sinew_simplify_level;

/* Options of simplification: inputs only. Start from SINEW_INIT(sinew_simplify_options). Later versions add members
 * at the end; see struct_size in sinew/types.h. */
typedef struct sinew_simplify_options {
  uint32_t struct_size; /* sizeof(sinew_simplify_options) */
  uint32_t level;       /* sinew_simplify_level */
  /* 0: by the level; else the number of joints to keep, if roots and `keep` allow; the body is merged last. */
  uint32_t joint_count;
  /* 1: as published: `branch`, and at the low level `area` and `length`, apply to any joint, and the cheapest bone is
   * merged first, whatever its anatomy. May remove limbs. */
  uint32_t as_drawn;
  const float* centroids; /* [J x 3] center of the surface that moves with each joint; null = the joint's position */
} sinew_simplify_options;

/* Returns the bytes that sinew_simplify() needs for this many joints. A pure function of its argument. Returns
 * SINEW_OK, or SINEW_ERROR_ARGUMENT or SINEW_ERROR_COUNT with size_bytes 0. */
SINEW_API sinew_status sinew_simplify_workspace_size(uint32_t joint_count, size_t* size_bytes);

/* Collapses bones into their parents: first details, then fingers, other joints and the body; within each group the
 * cheapest first. The cost of a bone is a + 0.1 b:
 *   a  squared distance of the bone's center from the lines through the bones at its two ends
 *   b  distance of the centroids of its two joints, times the sum of such distances of the bones at its joint
 * Joints of equal cost are merged together, which keeps a symmetric skeleton symmetric; except with joint_count.
 *   skeleton   in   J joints. Names give their anatomy; if they name no limb, a body is fitted to up to 512 joints
 *   areas      in   [J] share of the surface that moves with the joint (or sums of weights), 0 or more; null =
 *                   unknown, and `area` merges no joint
 *   keep       in   [J] 1: the joint stays; null = no such joints. Roots always stay
 *   options         null = all defaults
 *   workspace       scratch, 64-byte aligned, size from sinew_simplify_workspace_size()
 *   into       out  [J] joint that each joint was merged into: itself if it stays. Joints keep their indices. The
 *                   parent of a joint that stays is into[its parent]; weights of a merged joint belong to into[it]
 *
 * Nothing may overlap the output or the workspace. The same bytes on every platform: doubles in a fixed order,
 * without libm.
 *
 * Returns SINEW_OK, or with `into` untouched
 *   SINEW_ERROR_ARGUMENT    a pointer that must be set is null, struct_size is too small or above 4096, an option is
 *                           out of range
 *   SINEW_ERROR_NOT_BUILT   the library was built without it (SINEW_SMALL_CODE)
 *   SINEW_ERROR_VERSION     a reserved member, or one unknown to this library, is not 0
 *   SINEW_ERROR_COUNT       no joint, or more than SINEW_MAX_JOINTS
 *   SINEW_ERROR_WORKSPACE   the workspace is too small or not aligned
 *   SINEW_ERROR_NOT_FINITE  a position, a centroid or an area is NaN or infinite
 *   SINEW_ERROR_RANGE       an area is below 0
 *   SINEW_ERROR_INDEX       a parent does not exist
 *   SINEW_ERROR_HIERARCHY   parents form a cycle
 * Source: edge collapse of curve skeletons by quadrics (Au et al. 2008, section 5), conditions as for skeleton mapping. */
SINEW_API sinew_status sinew_simplify(const sinew_skeleton* skeleton, const float* areas, const uint8_t* keep,
                                      const sinew_simplify_options* options, void* workspace, size_t workspace_bytes,
                                      uint32_t* into);

#ifdef __cplusplus
}
#endif
#endif
