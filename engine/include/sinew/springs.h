/* SPDX-License-Identifier: MIT
 * Springs: chains of joints that swing behind a motion, such as hair, tails, ears and skirts. Reference algorithm of
 * VRM 1.0 (github.com/vrm-c/vrm-specification, VRMC_springBone-1.0: Verlet integration of each bone's end). Same
 * bytes on every platform. */
#ifndef SINEW_SPRINGS_H
#define SINEW_SPRINGS_H

#include "sinew/skeleton.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Numbers are never reused. Planes and shapes that hold chains inside are those of VRMC_springBone_extended_collider-1.0. */
typedef enum sinew_collider_shape {
  SINEW_COLLIDER_SPHERE = 1,         /* about `offset` */
  SINEW_COLLIDER_CAPSULE = 2,        /* about the segment from `offset` to `tail` */
  SINEW_COLLIDER_INSIDE_SPHERE = 3,  /* keeps chains inside it */
  SINEW_COLLIDER_INSIDE_CAPSULE = 4, /* keeps chains inside it */
  SINEW_COLLIDER_PLANE = 5           /* through `offset`; chains stay on the side that `tail`, its normal, points to */
} sinew_collider_shape;

/* A joint of a chain. It rotates so that the next joint of the chain, its tail, lags behind the motion. */
typedef struct sinew_spring_joint {
  uint32_t joint; /* of the skeleton */
  /* Radius of the sphere around its tail that colliders push, 0 or more. */
  float hit_radius;
  /* Speed in meters per second at which the tail is drawn to its position in the pose; 0 or more. */
  float stiffness;
  /* Speed in meters per second at which the tail is drawn along `gravity`. */
  float gravity_power;
  /* Direction in the world, of any length; length 0: none. */
  float gravity[3];
  /* Share of its motion that the tail loses in each step, 0..1. */
  float drag;
  /* Maximum angle between the bone and its direction in the pose, degrees, 0..180; 0: no limit. */
  float limit;
} sinew_spring_joint;

/* A chain of joints, each a descendant of the one before. The last one is the tail of the one before it and does not
 * rotate: its parameters are ignored. Joints of the skeleton between two of the chain keep the pose. */
typedef struct sinew_spring_chain {
  uint32_t first_joint;    /* of sinew_spring_set::joints */
  uint32_t joint_count;    /* 2 or more */
  uint32_t first_collider; /* of sinew_spring_set::chain_colliders */
  uint32_t collider_count;
  /* The joint in whose space the chain keeps its velocity, so that motion of that joint does not move it; -1: the
   * world. */
  int32_t center;
} sinew_spring_chain;

typedef struct sinew_spring_collider {
  uint32_t joint;  /* parent joint */
  uint32_t shape;  /* sinew_collider_shape */
  float offset[3]; /* in the joint's axes */
  float tail[3];   /* in the joint's axes: the other end of a capsule, the normal of a plane */
  float radius;    /* length, 0 or more; ignored for a plane */
} sinew_spring_collider;

/* All chains of a character. Start from SINEW_INIT(sinew_spring_set); borrowed for the duration of a call. */
typedef struct sinew_spring_set {
  uint32_t struct_size;          /* sizeof(sinew_spring_set) */
  uint32_t joint_count;          /* P, at most SINEW_MAX_JOINTS */
  uint32_t chain_count;          /* C, at most P */
  uint32_t collider_count;       /* S, at most SINEW_MAX_JOINTS */
  uint32_t chain_collider_count; /* L, at most SINEW_MAX_CHAIN_COLLIDERS */
  uint32_t reserved;             /* 0 */
  /* [P] */
  const sinew_spring_joint* joints;
  /* [C] */
  const sinew_spring_chain* chains;
  /* [S]; may be null if S is 0 */
  const sinew_spring_collider* colliders;
  /* [L] indices of colliders, in the order in which they push; null if L is 0 */
  const uint32_t* chain_colliders;
  /* [P x 3] hinge axes in the joints' own axes, or null. A joint with an axis rotates about it only, so that panels
   * of a skirt move out and in and do not slip past a leg. The component of the axis along the bone is ignored;
   * length 0: no hinge. */
  const float* hinges;
} sinew_spring_set;

#define SINEW_MAX_CHAIN_COLLIDERS 65536u

/* Start from SINEW_INIT(sinew_springs_options). Later versions add members at the end. */
typedef struct sinew_springs_options {
  uint32_t struct_size; /* sizeof(sinew_springs_options) */
  /* Steps per second, 10..1000; 0 = 60. Drag is a share of the motion in a step, so that another step rate swings
   * differently. */
  float steps;
  /* Units of the skeleton per meter: 100 for centimeters; 0 = 1. */
  float unit;
  /* Chains restart if a joint's translation changes by more within a frame, as when the root or the hips are moved to
   * another position; 0 = the longest side of the skeleton at rest. */
  float teleport;
  /* Chains restart after a frame longer than this in seconds, at most 10; 0 = 0.5. */
  float gap;
  uint32_t reserved; /* 0 */
} sinew_springs_options;

/* Springs with their state in the caller's memory. They hold pointers into that memory, which must not be moved. */
typedef struct sinew_springs sinew_springs;

/* Returns the bytes that sinew_springs_create() needs. A pure function of its arguments: the same on every host with
 * the same pointer size.
 *   skeleton_joints                       J of the skeleton
 *   joint_count .. chain_collider_count   of the set
 *   size_bytes                            out, 0 on failure
 * Returns SINEW_OK, SINEW_ERROR_ARGUMENT or SINEW_ERROR_COUNT. */
SINEW_API sinew_status sinew_springs_workspace_size(uint32_t skeleton_joints, uint32_t joint_count,
                                                    uint32_t chain_count, uint32_t collider_count,
                                                    uint32_t chain_collider_count, size_t* size_bytes);

/* Creates springs from chains and colliders.
 *   skeleton  only positions and parents are used
 *   set       copied
 *   options   null = all defaults
 *   memory    64-byte aligned, size from sinew_springs_workspace_size(); in use until the last call with the springs
 *   springs   out; untouched on failure
 * Returns SINEW_OK, or
 *   SINEW_ERROR_ARGUMENT    a pointer is null, an option is out of range, a shape is invalid
 *   SINEW_ERROR_COUNT       no chain, a chain of one joint, or a count above the limits
 *   SINEW_ERROR_INDEX       a joint, a collider or a center that does not exist
 *   SINEW_ERROR_CHAIN       joints of a chain are not descendants of one another, or two chains rotate one joint
 *   SINEW_ERROR_RANGE       a radius or a stiffness below 0, drag outside 0..1, a limit outside 0..180
 *   SINEW_ERROR_HIERARCHY   the skeleton's parents form a cycle
 *   SINEW_ERROR_NOT_FINITE, SINEW_ERROR_WORKSPACE, SINEW_ERROR_VERSION, SINEW_ERROR_NOT_BUILT */
SINEW_API sinew_status sinew_springs_create(const sinew_skeleton* skeleton, const sinew_spring_set* set,
                                            const sinew_springs_options* options, void* memory, size_t memory_bytes,
                                            sinew_springs** springs);

/* Simulates the next frame of a motion. The first frame shows the pose unchanged, and so does one that restarts the
 * chains: after sinew_springs_restart(), a gap or a jump. Chains advance in steps of fixed length, at poses
 * interpolated between the last frame and this one. The output also includes a part of a step up to the frame's time,
 * which the state does not keep: the state depends on the motion, not on the number of frames. In a step a tail keeps
 * its motion less its drag, is drawn to the pose and along gravity, kept at its bone's length and within its limit,
 * and then pushed by colliders, possibly beyond the limit. Colliders on joints of chains are moved before the chains
 * that touch them.
 *   seconds        since the frame before, 0 or more; ignored for the first frame
 *   rotations      [J x 4] local, as in sinew/motion.h: the pose that chains follow
 *   translations   [J x 3] local
 *   out_rotations  [J x 4] the pose with joints of chains rotated; may be `rotations`. Translations are unchanged
 * One thread at a time. Returns SINEW_OK, or with output and state untouched SINEW_ERROR_ARGUMENT or SINEW_ERROR_NOT_FINITE. */
SINEW_API sinew_status sinew_springs_frame(sinew_springs* springs, float seconds, const float* rotations,
                                           const float* translations, float* out_rotations);

/* Resets the springs: the next frame is the first. Returns SINEW_OK or SINEW_ERROR_ARGUMENT. */
SINEW_API sinew_status sinew_springs_restart(sinew_springs* springs);

#ifdef __cplusplus
}
#endif
#endif
