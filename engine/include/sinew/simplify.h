/* SPDX-License-Identifier: MIT
 * Simplification: a skeleton of fewer joints, for levels of detail. Which joint becomes part of which. */
#ifndef SINEW_SIMPLIFY_H
#define SINEW_SIMPLIFY_H

#include "sinew/skeleton.h"

#ifdef __cplusplus
extern "C" {
#endif

/* How much goes. Conditions as published: a joint may become part of its parent where one of the two has three bones or more
 * (`branch`), where it moves less of the surface than `area`, or where its bone is shorter than `length` (share of the
 * diagonal of the joints' box). Ours is what joints are, see sinew_joint_classes(): pelvis, the first and the last joint of
 * a spine, head, upper and lower arms and legs, hands and feet stay at both levels; bone ends, controls, slots, twists,
 * helpers and faces go first, then fingers; and `branch` takes of other joints leaves alone, and only small ones. */
typedef enum sinew_simplify_level {
  SINEW_SIMPLIFY_HIGH = 0, /* detail: `branch`, and bone ends. Small: below 1.2 % long and 0.1 % of the surface */
  SINEW_SIMPLIFY_LOW = 1   /* detail: `branch`, `area` 0.6 %, `length` 4 %; twists, helpers, faces and fingers all go.
                            * Small: below 8 % long and 2 % of the surface */
} sinew_simplify_level;

/* What a call is asked to do: inputs only. Start from SINEW_INIT(sinew_simplify_options). Later versions add members at the end;
 * see struct_size in sinew/types.h. */
typedef struct sinew_simplify_options {
  uint32_t struct_size; /* sizeof(sinew_simplify_options) */
  uint32_t level;       /* sinew_simplify_level */
  /* 0: as the level says; else so many stay, as far as roots and `keep` let; the body goes last. */
  uint32_t joint_count;
  /* 1: as published: `branch`, and at the low level `area` and `length`, take any joint, and the cheapest bone goes first
   * whatever its joint is. Takes limbs off. */
  uint32_t as_drawn;
  const float* centroids; /* [J x 3] middle of the surface that moves with each joint; null = the joint's position */
} sinew_simplify_options;

/* Bytes sinew_simplify() needs for so many joints. A pure function of its argument. Returns SINEW_OK, or SINEW_ERROR_ARGUMENT
 * or SINEW_ERROR_COUNT; size_bytes is 0 then. */
SINEW_API sinew_status sinew_simplify_workspace_size(uint32_t joint_count, size_t* size_bytes);

/* Collapses bones into their parents: details, fingers, other joints, the body; among these the cheapest first. A bone's
 * cost is a + 0.1 b:
 *   a  the squared distance of the bone's middle from the lines through the bones at its two ends
 *   b  the distance of the centroids of its two joints, times the sum of such distances of the bones at its joint
 * Joints of equal cost go together, so that both sides of a symmetric skeleton stay alike; not so where joint_count is given.
 *   skeleton   in   J joints. Names tell what joints are; where they tell of no limb, a body that is laid over up to 512
 *   areas      in   [J] share of the surface that moves with the joint (sums of weights will do), at least 0; null = not
 *                   known, no joint goes for it
 *   keep       in   [J] 1: the joint stays; null = none has to. Roots stay
 *   options         null = all defaults
 *   workspace       scratch, 64-byte aligned, size from sinew_simplify_workspace_size()
 *   into       out  [J] the joint that it is part of now: itself where it stays. Joints keep their indices. The parent of a
 *                   joint that stays is into[its parent]; weights of a joint that goes belong to into[it]
 *
 * Nothing may overlap the output or the workspace. The same bytes on every platform: doubles in one order, without libm.
 *
 * Returns SINEW_OK, or with `into` untouched
 *   SINEW_ERROR_ARGUMENT    a pointer that must be set is null, struct_size is too small or above 4096, an option is out of
 *                           its range
 *   SINEW_ERROR_NOT_BUILT   the library was built without it (SINEW_SMALL_CODE)
 *   SINEW_ERROR_VERSION     a member behind those that this library knows, or a reserved one, is not 0
 *   SINEW_ERROR_COUNT       no joint, or more than SINEW_MAX_JOINTS
 *   SINEW_ERROR_WORKSPACE   the workspace is too small or not aligned
 *   SINEW_ERROR_NOT_FINITE  a position, a centroid or an area is NaN or infinite
 *   SINEW_ERROR_RANGE       an area is below 0
 *   SINEW_ERROR_INDEX       a parent is no joint
 *   SINEW_ERROR_HIERARCHY   parents form a cycle
 * Source: edge collapse of curve skeletons by quadrics (Au et al. 2008, section 5), conditions as for skeleton mapping. */
SINEW_API sinew_status sinew_simplify(const sinew_skeleton* skeleton, const float* areas, const uint8_t* keep,
                                      const sinew_simplify_options* options, void* workspace, size_t workspace_bytes,
                                      uint32_t* into);

#ifdef __cplusplus
}
#endif
#endif
