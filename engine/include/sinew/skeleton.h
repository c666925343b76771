/* SPDX-License-Identifier: MIT
 * Skeletons: the struct that all calls take, and the enum of the up axis. */
#ifndef SINEW_SKELETON_H
#define SINEW_SKELETON_H

#include "sinew/types.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The axis that points up. Numbers are never reused. */
typedef enum sinew_up {
  /* The call decides: sinew_map() guesses, sinew_retarget_create() takes the direction away from the legs, or Y
   * without legs. All other calls take Y */
  SINEW_UP_AUTO = 0,
  SINEW_UP_X = 1, /* for sinew_map() and sinew_retarget_create() only; SINEW_ERROR_ARGUMENT elsewhere */
  SINEW_UP_Y = 2,
  SINEW_UP_Z = 3
} sinew_up;

#define SINEW_JOINT_NEVER 1u   /* flag: this joint must get no weight */
#define SINEW_JOINT_DEFORMS 2u /* flag: this joint is known to deform. If any joint has it, all others are NEVER */

/* A skeleton at rest, borrowed for the duration of a call. Start from SINEW_INIT(sinew_skeleton). Later versions add
 * members at the end; see struct_size in sinew/types.h. A call reads positions and parents, and of the other members
 *   sinew_bind(), sinew_transfer()  flags, up
 *   sinew_map()                     names, ends, up
 *   sinew_retarget_create()         rotations, up
 *   sinew_simplify()                names
 *   sinew_deform_create()           nothing */
typedef struct sinew_skeleton {
  uint32_t struct_size;     /* sizeof(sinew_skeleton) */
  uint32_t joint_count;     /* J, 1 .. SINEW_MAX_JOINTS */
  const float* positions;   /* [J x 3] in the world, any unit; the same space as the mesh, if the call takes one */
  const int32_t* parents;   /* [J] parent index or -1; any order */
  const uint8_t* flags;     /* [J] SINEW_JOINT_* bits; null = 0 for all */
  const uint8_t* ends;      /* [J] 1: the joint only marks the end of a bone (a BVH End Site, a leaf without skin
                           * weight); null = not known: derived from names. Without names sinew_map() takes all leaves
                           * or none as ends, whichever makes the two skeletons more similar */
  const char* const* names; /* [J] UTF-8; null = not known */
  const float* rotations;   /* [J x 4] x y z w, from the joint's axes to world axes; null = all joints have world axes,
                           * as in a BVH file */
  uint32_t up;              /* sinew_up */
  uint32_t reserved;        /* 0 */
} sinew_skeleton;

#ifdef __cplusplus
}
#endif
#endif
