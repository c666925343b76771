/* SPDX-License-Identifier: MIT
 * Limits of joints: robots' hinges, and balls that swing and twist. Same bytes on every platform. */
#ifndef SINEW_JOINT_LIMITS_H
#define SINEW_JOINT_LIMITS_H

#include "sinew/types.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef enum sinew_limit_kind {
  SINEW_LIMIT_HINGE = 1, /* turns about `axis` alone, as a robot's revolute joint; equal ends: it is fixed */
  SINEW_LIMIT_BALL = 2   /* turns about `axis`, its bone, then swings across it */
} sinew_limit_kind;

/* How far a joint may turn. The rotation that is looked at is the one from `zero` to the joint's, in the axes of the joint as `zero` has
 * them. Degrees. */
typedef struct sinew_joint_limit {
  uint32_t joint;
  uint32_t kind; /* sinew_limit_kind */
  float zero[4]; /* local rotation, x y z w, from which angles count; of length 0: none */
  float axis[3]; /* of any length but 0 */
  float side
      [3]; /* of a ball, not along `axis`: what swings count about, with axis x side; a part along `axis` is taken out */
  float least
      [3]; /* about axis, side, axis x side; of a hinge the first alone. -180 to `most`, of a swing no more than 0 */
  float most[3]; /* `least` to 180, of a swing no less than 0. Both swings at once: within the ellipse of their ends */
} sinew_joint_limit;

/* Holds joints within their limits, whatever made the pose: after contacts, where a limit wins over them, or frame by frame behind a
 * stream. A twist out of its range goes to the nearer end of it; a swing goes straight back. What is within stays bit for bit, but for
 * hinges, which lose what is not about their axis. Allocates nothing.
 *   limits     [limit_count]; of several of one joint the later ones have the last word
 *   rotations  in and out, [frame_count x joint_count x 4] local
 * Returns SINEW_OK, or with rotations untouched
 *   SINEW_ERROR_ARGUMENT    a pointer that must be set is null, a kind or a range is none of the above, an axis has no length
 *   SINEW_ERROR_COUNT       no joint, or more than SINEW_MAX_JOINTS
 *   SINEW_ERROR_INDEX       a limit's joint does not exist
 *   SINEW_ERROR_NOT_FINITE  a number is NaN or infinite
 *   SINEW_ERROR_NOT_BUILT   as of all calls here */
SINEW_API sinew_status sinew_keep_joint_limits(const sinew_joint_limit* limits, uint32_t limit_count,
                                               uint32_t joint_count, uint32_t frame_count, float* rotations);

#ifdef __cplusplus
}
#endif
#endif
