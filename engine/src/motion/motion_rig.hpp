// SPDX-License-Identifier: MIT
// A skeleton of sinew/motion.h, checked and in doubles: parents first, rest pose, and poses of it in the world.
#ifndef SINEW_MOTION_MOTION_RIG_HPP
#define SINEW_MOTION_MOTION_RIG_HPP

#include "core/arena.hpp"
#include "motion/quaternion.hpp"
#include "sinew/motion.h"

namespace sinew::motion {

struct MotionRig {
  uint32_t count = 0;               // J
  int32_t* parents = nullptr;       // [J] also the joints that roots of one body are attached to
  int32_t* file_parents = nullptr;  // [J] what local poses refer to
  uint32_t* order = nullptr;        // [J] parents before children
  Vec3d* positions = nullptr;       // [J] at rest, world
  Quat* rotations = nullptr;        // [J] at rest, world, of length 1

  // Works with a measuring arena. Returns arena.ok().
  bool allocate(Arena& arena, uint32_t joint_count);
  // Fills what was allocated. `scratch` [2 count + 1].
  // Returns SINEW_OK, SINEW_ERROR_NOT_FINITE, SINEW_ERROR_INDEX or SINEW_ERROR_HIERARCHY.
  sinew_status fill(const sinew_skeleton& input, uint32_t* scratch);

  // Fills `order`. `scratch` as above. Returns SINEW_OK or SINEW_ERROR_HIERARCHY.
  sinew_status sort(uint32_t* scratch);

  uint32_t root_of(uint32_t joint) const {
    while (parents[joint] >= 0) joint = static_cast<uint32_t>(parents[joint]);
    return joint;
  }
  // The joint itself, or what is below it.
  bool is_below(uint32_t joint, uint32_t ancestor) const {
    for (int32_t at = static_cast<int32_t>(joint); at >= 0; at = parents[at]) {
      if (at == static_cast<int32_t>(ancestor)) return true;
    }
    return false;
  }
};

inline bool is_finite(double x) { return x - x == 0; }

}  // namespace sinew::motion
#endif
