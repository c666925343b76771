// SPDX-License-Identifier: MIT
// Chains that swing behind a motion: the state of all of them and their steps. Behind sinew_springs_*().
#ifndef SINEW_SPRINGS_SPRINGS_HPP
#define SINEW_SPRINGS_SPRINGS_HPP

#include "core/arena.hpp"
#include "motion/quaternion.hpp"
#include "sinew/springs.h"

namespace sinew::springs {

using motion::Quat;

// The counts that memory is a function of.
struct SpringCounts {
  uint32_t skeleton_joints = 0;  // J
  uint32_t joints = 0;           // P
  uint32_t chains = 0;           // C
  uint32_t colliders = 0;        // S
  uint32_t chain_colliders = 0;  // L
  sinew_status check() const;    // SINEW_OK or SINEW_ERROR_COUNT
};

struct SpringOptions {
  double step = 1.0 / 60;  // seconds
  double unit = 1;         // lengths in a meter
  double teleport = 0;     // 0: by the skeleton
  double gap = 0.5;        // seconds
};
// Returns SINEW_OK, SINEW_ERROR_ARGUMENT, SINEW_ERROR_NOT_FINITE or SINEW_ERROR_VERSION.
sinew_status read_springs_options(const sinew_springs_options* options, SpringOptions* out);

// A joint of a chain that rotates, its parameters, and the position of its tail.
struct SpringHead {
  uint32_t joint = 0, tail = 0, chain = 0;
  double hit_radius = 0, stiffness = 0, gravity_power = 0, keep = 0;  // keep: 1 - drag
  Vec3d gravity;                                                      // of length 1 or 0
  Vec3d hinge;                                                        // in the joint's axes; of length 0: none
  bool limited = false;
  double cosine = -1, sine = 0;  // of the limit
  Vec3d previous, current;       // in the space of the chain's center
};

struct SpringChain {
  uint32_t first_collider = 0, collider_count = 0;
  int32_t center = -1;
};

struct SpringCollider {
  uint32_t joint = 0, shape = 0;
  Vec3d offset, tail;
  double radius = 0;
  int32_t next = -1;   // the next one of the same joint
  Vec3d start, along;  // in the world: offset; from there to the tail, or the normal
};

struct Placement {
  Quat rotation;
  Vec3d position;
};

struct SpringState {
  SpringCounts counts;
  SpringOptions options;
  int32_t* parents = nullptr;  // [J]
  uint32_t* order = nullptr;   // [J] of joints that matter: parents first, colliders before what touches them
  uint32_t order_count = 0;
  int32_t* heads_of = nullptr;      // [J] the head that rotates a joint, or -1
  int32_t* colliders_of = nullptr;  // [J] the first collider of a joint, or -1
  SpringHead* heads = nullptr;      // [P]
  uint32_t head_count = 0;
  SpringChain* chains = nullptr;        // [C]
  SpringCollider* colliders = nullptr;  // [S]
  uint32_t* chain_colliders = nullptr;  // [L]
  Placement* before = nullptr;          // [J] the last frame's pose, local
  Placement* now = nullptr;             // [J] this frame's pose, local
  Placement* between = nullptr;         // [J] the pose of a step, local
  Placement* worlds = nullptr;          // [J] in the world, chains rotated
  Quat* turned = nullptr;               // [P] local rotations of heads
  bool started = false;
  double time = 0;  // since the last step, below one

  bool allocate(Arena& arena);
};

// As sinew_springs_create(), after its checks of pointers, counts and memory.
sinew_status fill(const sinew_skeleton& skeleton, const sinew_spring_set& set, SpringState* state);
// The order of joints and what of them matters: springs/order.cpp. `needed` [J] and `done` [J] are scratch.
void sort_joints(SpringState* state, uint8_t* needed, uint8_t* done);
// One step at a local pose, or a share of one: springs/step.cpp. keep: the state is the step's afterwards; else it stays.
void step(SpringState* state, const Placement* pose, double share, bool keep);
// The state of chains at rest in a local pose, without velocity.
void settle(SpringState* state, const Placement* pose);
// As sinew_springs_frame() after its checks.
void play_frame(SpringState* state, double seconds, const float* rotations, const float* translations,
                float* out_rotations);

}  // namespace sinew::springs

// The type of the interface: one block of memory, this is its beginning.
struct sinew_springs {
  sinew::springs::SpringState state;
};
#endif
