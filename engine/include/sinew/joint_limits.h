/* SPDX-License-Identifier: MIT
 * Rotation limits of joints: hinges, as of robots, and ball joints with swing and twist. Same bytes on every
 * platform. */
#ifndef SINEW_JOINT_LIMITS_H
#define SINEW_JOINT_LIMITS_H

#include "sinew/types.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef enum sinew_limit_kind {
  SINEW_LIMIT_HINGE = 1, /* rotates about `axis` only, like a robot's revolute joint; with equal limits it is fixed */
  SINEW_LIMIT_BALL = 2   /* rotates about `axis`, its bone, then swings across it */
} sinew_limit_kind;

/* Limit of a joint's rotation relative to `zero`, in the joint's axes at `zero`. Angles are in degrees. */
typedef struct sinew_joint_limit {
  uint32_t joint;
  uint32_t kind; /* sinew_limit_kind */
  float zero[4]; /* local rotation, x y z w, at which all angles are 0; length 0 = identity */
  float axis[3]; /* of any length but 0 */
  /* For a ball: swing axis, not along `axis`; the other swing axis is axis x side. Its component along `axis` is removed */
  float side[3];
  /* Minimum about axis, side, axis x side; a hinge uses the first. -180 to `most`; at most 0 for a swing */
  float least[3];
  /* Maximum, `least` to 180; at least 0 for a swing. Both swings together stay inside the ellipse of their limits */
  float most[3];
} sinew_joint_limit;

/* Clamps joint rotations to their limits: in a clip after contacts, or in each frame of a stream. A limit takes
 * precedence over a contact. A twist out of range is set to the nearer limit; a swing is reduced to its limit.
 * Rotations in range stay equal bit for bit, except that hinges lose rotation about other axes. Allocates no memory.
 *   limits     [limit_count]; of several limits for one joint the last one counts
 *   rotations  in and out, [frame_count x joint_count x 4] local
 * Returns SINEW_OK, or with rotations untouched
 *   SINEW_ERROR_ARGUMENT    a pointer that must be set is null, a kind or a range is invalid, an axis has length 0
 *   SINEW_ERROR_COUNT       no joint, or more than SINEW_MAX_JOINTS
 *   SINEW_ERROR_INDEX       a limit's joint does not exist
 *   SINEW_ERROR_NOT_FINITE  a number is NaN or infinite
 *   SINEW_ERROR_NOT_BUILT   the library was built without this call */
SINEW_API sinew_status sinew_keep_joint_limits(const sinew_joint_limit* limits, uint32_t limit_count,
                                               uint32_t joint_count, uint32_t frame_count, float* rotations);

#ifdef __cplusplus
}
#endif
#endif
