/* SPDX-License-Identifier: MIT
 * Mapping: which joint of one skeleton stands for which joint of another, whatever their names, counts and poses. */
#ifndef SINEW_MAP_H
#define SINEW_MAP_H

#include "sinew/skeleton.h"

#ifdef __cplusplus
extern "C" {
#endif

/* How joints are compared. */
typedef enum sinew_map_method {
  SINEW_MAP_AUTO = 0, /* SINEW; but where published methods are built, SINEW_MAP_BRANCHES for two nearly equal skeletons
                       * that have no body SINEW could read */
  SINEW_MAP_SINEW = 1 /* by anatomy: mirror plane, trunk, limbs in mirrored pairs, the long bones of arms and legs */
} sinew_map_method;   /* 2: sinew/published.h */

/* Why a joint has its source, or none. Numbers are never reused. */
typedef enum sinew_map_reason {
  SINEW_MAP_FOUND = 0,          /* it has a source */
  SINEW_MAP_PINNED = 1,         /* the caller said so, a source or none */
  SINEW_MAP_NO_COUNTERPART = 2, /* the source has no limb, tail or trunk part like its own */
  SINEW_MAP_FEWER_JOINTS = 3,   /* the source's chain has fewer joints, and others are nearer to them */
  SINEW_MAP_END = 4,            /* an end marker: it only says where a bone ends */
  SINEW_MAP_OUTSIDE = 5,        /* beside the body: roots on the floor, controls */
  SINEW_MAP_TAKEN = 6,          /* its source went to another joint, or would have crossed another's chain */
  SINEW_MAP_BESIDE_LIMITS = 7   /* behind the limits of the method: more than SINEW_MAX_MAP_LIMBS limbs */
} sinew_map_reason;

/* Limbs of a skeleton that are looked at: chains off the trunk, and what branches off them. */
#define SINEW_MAX_MAP_LIMBS 1024u

/* A pair that the caller knows. */
typedef struct sinew_map_pin {
  uint32_t target; /* joint of the target */
  int32_t source;  /* joint of the source; -1 = the target's joint gets none */
} sinew_map_pin;

/* What a call is asked to do: inputs only. Start from SINEW_INIT(sinew_map_options). */
typedef struct sinew_map_options {
  uint32_t struct_size;      /* sizeof(sinew_map_options) */
  uint32_t method;           /* sinew_map_method */
  uint32_t pin_count;        /* pins: kept as they are, and the rest follows them */
  uint32_t reserved;         /* 0 */
  const sinew_map_pin* pins; /* [pin_count] every target once, every source once; null for none */
  /* The rest is for SINEW_MAP_BRANCHES alone (sinew/published.h). */
  uint32_t branches_first;        /* sinew_branches_first */
  uint32_t branches_cost;         /* sinew_branches_cost */
  const float* target_areas;      /* [target J] share of the surface that moves with the joint, at least 0 */
  const float* source_areas;      /* [source J] the same; where one of both is null no surface is compared */
  const uint8_t* source_animated; /* [source J] 1: it moves; null = all do */
} sinew_map_options;

/* What a call gives: the caller's arrays and numbers that the call writes. Start from SINEW_INIT(sinew_map_outputs). */
typedef struct sinew_map_outputs {
  uint32_t struct_size; /* sizeof(sinew_map_outputs) */
  uint32_t method;      /* written: sinew_map_method that was used, SINEW_MAP_SINEW or SINEW_MAP_BRANCHES */
  /* [target J] joint of the source, -1 = none. With SINEW_MAP_SINEW every source at most once, and a joint's source is never
   * above that of the joint's ancestor. Pins may break both rules */
  int32_t* sources;
  uint16_t* confidence; /* [target J] how sure the source is, 0..32768, 0 without one; null = not wanted */
  uint8_t* reasons;     /* [target J] sinew_map_reason; null = not wanted */
  uint32_t mapped;      /* written: joints with a source */
  uint32_t certainty;   /* written: 0..32768, how sure front, sides and trunk of both skeletons are; low: look at it */
  size_t used_bytes;    /* written: high-water mark of the workspace */
} sinew_map_outputs;

/* Bytes sinew_map() needs for two skeletons of at most these counts. A pure function of its arguments: the same on every host.
 * Returns SINEW_OK, or as sinew_map() does SINEW_ERROR_ARGUMENT or SINEW_ERROR_COUNT; size_bytes is 0 then. */
SINEW_API sinew_status sinew_map_workspace_size(uint32_t target_count, uint32_t source_count, size_t* size_bytes);

/* Finds a source for every joint of the target that has a counterpart. The same bytes on every platform: doubles in one
 * order, without libm.
 *   options    null = all defaults
 *   workspace  scratch, 64-byte aligned, size from sinew_map_workspace_size(); its content is undefined afterwards
 *   outputs    sources must be set
 *
 * Nothing may overlap the outputs or the workspace. Calls may run at the same time, each with its own workspace.
 *
 * Returns SINEW_OK, or with outputs untouched
 *   SINEW_ERROR_ARGUMENT    a pointer that must be set is null, struct_size is too small or above 4096, an option is out
 *                           of its range
 *   SINEW_ERROR_NOT_BUILT   the library was built without what is asked for
 *   SINEW_ERROR_VERSION     a member behind those that this library knows, or a reserved one, is not 0
 *   SINEW_ERROR_COUNT       no joint or more than SINEW_MAX_JOINTS in a skeleton; with SINEW_MAP_BRANCHES more than 2^18 pairs
 *                           of branches, or more than 2^30 pairs of joints in them
 *   SINEW_ERROR_WORKSPACE   the workspace is too small or not aligned
 *   SINEW_ERROR_NOT_FINITE  a position or an area is NaN or infinite
 *   SINEW_ERROR_INDEX       a parent is no joint
 *   SINEW_ERROR_HIERARCHY   parents form a cycle
 *   SINEW_ERROR_RANGE       a pin names a joint that does not exist, or a joint twice; an area is below 0 */
SINEW_API sinew_status sinew_map(const sinew_skeleton* target, const sinew_skeleton* source,
                                 const sinew_map_options* options, void* workspace, size_t workspace_bytes,
                                 sinew_map_outputs* outputs);

#ifdef __cplusplus
}
#endif
#endif
