// SPDX-License-Identifier: MIT
// The C API: argument checks of springs.
#include "sinew/springs.h"

#include <stddef.h>

#include "api/arguments.hpp"
#include "core/struct_size.hpp"
#include "motion/motion_rig.hpp"
#include "springs/springs.hpp"

static_assert(sizeof(sinew_spring_joint) == 9 * sizeof(uint32_t), "sinew_spring_joint never changes");
static_assert(sizeof(sinew_spring_chain) == 5 * sizeof(uint32_t), "sinew_spring_chain never changes");
static_assert(sizeof(sinew_spring_collider) == 9 * sizeof(uint32_t), "sinew_spring_collider never changes");
static_assert(sizeof(sinew_spring_set) == 6 * sizeof(uint32_t) + 5 * sizeof(void*), "a hole in sinew_spring_set");
static_assert(sizeof(sinew_springs_options) == 6 * sizeof(uint32_t), "a hole in sinew_springs_options");

namespace {

bool allocate_springs(sinew::Arena& arena, sinew::springs::SpringState* state, sinew_springs** springs) {
  *springs = arena.alloc<sinew_springs>(1);
  return state->allocate(arena) && arena.ok();
}

// The caller's set, of any version.
sinew_status read_set(const sinew_spring_set* set, sinew_spring_set* own) {
  if (set == nullptr) return SINEW_ERROR_ARGUMENT;
  const sinew_status status = sinew::read_struct(set, offsetof(sinew_spring_set, hinges), sizeof *own, own);
  if (status != SINEW_OK) return status;
  if (own->reserved != 0) return SINEW_ERROR_VERSION;
  if ((own->joint_count > 0 && own->joints == nullptr) || (own->chain_count > 0 && own->chains == nullptr) ||
      (own->collider_count > 0 && own->colliders == nullptr) ||
      (own->chain_collider_count > 0 && own->chain_colliders == nullptr)) {
    return SINEW_ERROR_ARGUMENT;
  }
  return SINEW_OK;
}

sinew_status measure_springs(const sinew::springs::SpringCounts& counts, size_t* size_bytes) {
  *size_bytes = 0;
  const sinew_status status = counts.check();
  if (status != SINEW_OK) return status;
  return sinew::measure(size_bytes, [&](sinew::Arena& arena) {
    sinew::springs::SpringState state;
    state.counts = counts;
    sinew_springs* springs = nullptr;
    return allocate_springs(arena, &state, &springs) ? SINEW_OK : SINEW_ERROR_WORKSPACE;
  });
}

}  // namespace

extern "C" {

sinew_status sinew_springs_workspace_size(uint32_t skeleton_joints, uint32_t joint_count, uint32_t chain_count,
                                          uint32_t collider_count, uint32_t chain_collider_count, size_t* size_bytes) {
  if (size_bytes == nullptr) return SINEW_ERROR_ARGUMENT;
  return measure_springs({skeleton_joints, joint_count, chain_count, collider_count, chain_collider_count}, size_bytes);
}

sinew_status sinew_springs_create(const sinew_skeleton* skeleton, const sinew_spring_set* set,
                                  const sinew_springs_options* options, void* memory, size_t memory_bytes,
                                  sinew_springs** springs) {
  if (memory == nullptr || springs == nullptr) return SINEW_ERROR_ARGUMENT;
  sinew_skeleton joints;
  sinew_spring_set own;
  sinew::springs::SpringState state;
  sinew_status status = sinew::read_skeleton(skeleton, &joints);
  if (status == SINEW_OK) status = read_set(set, &own);
  if (status == SINEW_OK) status = sinew::springs::read_springs_options(options, &state.options);
  if (status != SINEW_OK) return status;
  state.counts = {joints.joint_count, own.joint_count, own.chain_count, own.collider_count, own.chain_collider_count};
  size_t bytes = 0;
  status = measure_springs(state.counts, &bytes);
  if (status != SINEW_OK) return status;
  if (memory_bytes < bytes || !sinew::is_aligned(memory)) return SINEW_ERROR_WORKSPACE;
  sinew::Arena arena(memory, memory_bytes);
  sinew_springs* made = nullptr;
  (void)allocate_springs(arena, &state, &made);
  status = sinew::springs::fill(joints, own, &state);
  if (status != SINEW_OK) return status;
  made->state = state;
  *springs = made;
  return SINEW_OK;
}

sinew_status sinew_springs_frame(sinew_springs* springs, float seconds, const float* rotations,
                                 const float* translations, float* out_rotations) {
  if (springs == nullptr || rotations == nullptr || translations == nullptr || out_rotations == nullptr || seconds < 0)
    return SINEW_ERROR_ARGUMENT;
  if (!sinew::motion::is_finite(static_cast<double>(seconds))) return SINEW_ERROR_NOT_FINITE;
  const size_t joints = springs->state.counts.skeleton_joints;
  for (size_t i = 0; i < 4 * joints; ++i)
    if (!sinew::motion::is_finite(static_cast<double>(rotations[i]))) return SINEW_ERROR_NOT_FINITE;
  for (size_t i = 0; i < 3 * joints; ++i)
    if (!sinew::motion::is_finite(static_cast<double>(translations[i]))) return SINEW_ERROR_NOT_FINITE;
  sinew::springs::play_frame(&springs->state, static_cast<double>(seconds), rotations, translations, out_rotations);
  return SINEW_OK;
}

sinew_status sinew_springs_restart(sinew_springs* springs) {
  if (springs == nullptr) return SINEW_ERROR_ARGUMENT;
  springs->state.started = false;
  return SINEW_OK;
}

}  // extern "C"
