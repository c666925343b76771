// SPDX-License-Identifier: MIT
// Checks a skeleton and sorts its joints by depth.
#include "motion/motion_rig.hpp"

namespace sinew::motion {

bool MotionRig::allocate(Arena& arena, uint32_t joint_count) {
  count = joint_count;
  parents = arena.alloc<int32_t>(count);
  file_parents = arena.alloc<int32_t>(count);
  order = arena.alloc<uint32_t>(count);
  positions = arena.alloc<Vec3d>(count);
  rotations = arena.alloc<Quat>(count);
  return arena.ok();
}

sinew_status MotionRig::fill(const sinew_skeleton& input, uint32_t* scratch) {
  const int32_t joints = static_cast<int32_t>(count);
  for (uint32_t j = 0; j < count; ++j) {
    const float* const p = input.positions + size_t{3} * j;
    positions[j] = {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])};
    if (!is_finite(positions[j].x + positions[j].y + positions[j].z)) return SINEW_ERROR_NOT_FINITE;
    rotations[j] = kNoRotation;
    if (input.rotations != nullptr) {
      const float* const q = input.rotations + size_t{4} * j;
      const Quat given = {static_cast<double>(q[0]), static_cast<double>(q[1]), static_cast<double>(q[2]),
                          static_cast<double>(q[3])};
      if (!is_finite(given.x + given.y + given.z + given.w)) return SINEW_ERROR_NOT_FINITE;
      rotations[j] = normalized(given);
    }
    parents[j] = file_parents[j] = input.parents[j];
    if (parents[j] < -1 || parents[j] >= joints) return SINEW_ERROR_INDEX;
  }
  return sort(scratch);
}

sinew_status MotionRig::sort(uint32_t* scratch) {
  // Depth by depth, in the caller's order within one.
  uint32_t* const depths = scratch;
  uint32_t* const starts = scratch + count;  // [count + 1]
  for (uint32_t d = 0; d <= count; ++d) starts[d] = 0;
  for (uint32_t j = 0; j < count; ++j) {
    uint32_t depth = 0;
    for (int32_t at = parents[j]; at >= 0; at = parents[at]) {
      if (++depth >= count) return SINEW_ERROR_HIERARCHY;
    }
    depths[j] = depth;
    ++starts[depth + 1];
  }
  for (uint32_t d = 1; d <= count; ++d) starts[d] += starts[d - 1];
  for (uint32_t j = 0; j < count; ++j) order[starts[depths[j]]++] = j;
  return SINEW_OK;
}

}  // namespace sinew::motion
