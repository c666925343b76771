/* SPDX-License-Identifier: MIT
 * Mapping: matches the joints of one skeleton to those of another, whatever their names, counts and poses. */
#ifndef SINEW_MAP_H
#define SINEW_MAP_H

#include "sinew/skeleton.h"

#ifdef __cplusplus
extern "C" {
#endif

/* How joints are matched. */
typedef enum sinew_map_method {
  SINEW_MAP_AUTO = 0, /* SINEW; but if published methods are built, SINEW_MAP_BRANCHES for two nearly equal skeletons
                       * without a body that SINEW recognizes */
  SINEW_MAP_SINEW = 1 /* by anatomy: mirror plane, torso, limbs in mirrored pairs, the long bones of arms and legs */
} sinew_map_method;   /* 2: sinew/published.h */

/* Reason for a joint's source, or for having none. Numbers are never reused. */
typedef enum sinew_map_reason {
  SINEW_MAP_FOUND = 0,          /* it has a source */
  SINEW_MAP_PINNED = 1,         /* given by the caller, a source or none */
  SINEW_MAP_NO_COUNTERPART = 2, /* the source has no matching limb, tail or torso part */
  SINEW_MAP_FEWER_JOINTS = 3,   /* the source's chain has fewer joints, and others are nearer to them */
  SINEW_MAP_END = 4,            /* an end marker: it only marks the end of a bone */
  SINEW_MAP_OUTSIDE = 5,        /* beside the body: roots on the floor, controls */
  SINEW_MAP_TAKEN = 6,          /* its source matched another joint, or the pairs would cross */
  SINEW_MAP_BESIDE_LIMITS = 7   /* beyond the limits of the method: more than SINEW_MAX_MAP_LIMBS limbs */
} sinew_map_reason;

/* Maximum number of limbs of a skeleton that are matched: chains off the torso, and their branches. */
#define SINEW_MAX_MAP_LIMBS 1024u

/* A pair that the caller knows. */
typedef struct sinew_map_pin {
  uint32_t target; /* joint of the target */
  int32_t source;  /* joint of the source; -1 = none */
} sinew_map_pin;

/* Options of a map: inputs only. Start from SINEW_INIT(sinew_map_options). */
typedef struct sinew_map_options {
  uint32_t struct_size;      /* sizeof(sinew_map_options) */
  uint32_t method;           /* sinew_map_method */
  uint32_t pin_count;        /* pins: fixed pairs that the rest must agree with */
  uint32_t reserved;         /* 0 */
  const sinew_map_pin* pins; /* [pin_count] every target once, every source once; null for none */
  /* The members below are for SINEW_MAP_BRANCHES only (sinew/published.h). */
  uint32_t branches_first;        /* sinew_branches_first */
  uint32_t branches_cost;         /* sinew_branches_cost */
  const float* target_areas;      /* [target J] share of the surface that moves with the joint, 0 or more */
  const float* source_areas;      /* [source J] the same; if one of both is null no surface is compared */
  const uint8_t* source_animated; /* [source J] 1: it moves; null = all do */
} sinew_map_options;

/* Outputs of a map: the caller's arrays, and numbers that the call writes. Start from SINEW_INIT(sinew_map_outputs). */
typedef struct sinew_map_outputs {
  uint32_t struct_size; /* sizeof(sinew_map_outputs) */
  uint32_t method;      /* written: sinew_map_method that was used, SINEW_MAP_SINEW or SINEW_MAP_BRANCHES */
  /* [target J] joint of the source, -1 = none. With SINEW_MAP_SINEW each source occurs at most once, and a joint's
   * source is never an ancestor of the source of the joint's ancestor. Pins may break both rules */
  int32_t* sources;
  uint16_t* confidence; /* [target J] confidence of the source, 0..32768, 0 without one; null = not wanted */
  uint8_t* reasons;     /* [target J] sinew_map_reason; null = not wanted */
  uint32_t mapped;      /* written: joints with a source */
  uint32_t certainty;   /* written: 0..32768, certainty of the front, sides and torso of both skeletons; check the map
                         * if it is low */
  size_t used_bytes;    /* written: high-water mark of the workspace */
} sinew_map_outputs;

/* Returns the bytes that sinew_map() needs for two skeletons of at most these counts. A pure function of its
 * arguments: the same on every host.
 * Returns SINEW_OK, or like sinew_map() SINEW_ERROR_ARGUMENT or SINEW_ERROR_COUNT with size_bytes 0. */
SINEW_API sinew_status sinew_map_workspace_size(uint32_t target_count, uint32_t source_count, size_t* size_bytes);

/* Finds a source for each joint of the target that has a match. The same bytes on every platform: doubles in a fixed
 * order, without libm.
 *   options    null = all defaults
 *   workspace  scratch, 64-byte aligned, size from sinew_map_workspace_size(); its content is undefined afterwards
 *   outputs    sources must be set
 *
 * Nothing may overlap the outputs or the workspace. Calls may run at the same time, each with its own workspace.
 *
 * Returns SINEW_OK, or with outputs untouched
 *   SINEW_ERROR_ARGUMENT    a pointer that must be set is null, struct_size is too small or above 4096, an option is
 *                           out of range
 *   SINEW_ERROR_NOT_BUILT   the library was built without a requested feature
 *   SINEW_ERROR_VERSION     a reserved member, or one unknown to this library, is not 0
 *   SINEW_ERROR_COUNT       no joint or more than SINEW_MAX_JOINTS in a skeleton; with SINEW_MAP_BRANCHES more than 2^18 pairs
 *                           of branches, or more than 2^30 pairs of joints in them
 *   SINEW_ERROR_WORKSPACE   the workspace is too small or not aligned
 *   SINEW_ERROR_NOT_FINITE  a position or an area is NaN or infinite
 *   SINEW_ERROR_INDEX       a parent does not exist
 *   SINEW_ERROR_HIERARCHY   parents form a cycle
 *   SINEW_ERROR_RANGE       a pin names a joint that does not exist, or a joint twice; an area is below 0 */
SINEW_API sinew_status sinew_map(const sinew_skeleton* target, const sinew_skeleton* source,
                                 const sinew_map_options* options, void* workspace, size_t workspace_bytes,
                                 sinew_map_outputs* outputs);

#ifdef __cplusplus
}
#endif
#endif
