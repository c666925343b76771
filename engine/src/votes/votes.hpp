// SPDX-License-Identifier: MIT
// Votes of surface points for the bones that move them: made from a "rig" network's rows, used to find joints.
#ifndef SINEW_VOTES_VOTES_HPP
#define SINEW_VOTES_VOTES_HPP

#include "core/fixed.hpp"
#include "votes/joint_class.hpp"

namespace sinew::rigging {

constexpr uint32_t kMaxRigPoints = 4096;

// Of N points, borrowed. Positions are in the mirror frame: grid units (core: the mesh's longest side is 2^20), floor at
// y = 0, the mirror plane at x = 0.
struct Votes {
  uint32_t points = 0;  // N, 1..kMaxRigPoints
  bool folded = false;  // the mesh is its own mirror image: votes count at |x|, a joint beside the plane is two
  const Vec3i* start = nullptr;            // [N] where the bone begins: the joint that owns the point
  const Vec3i* end = nullptr;              // [N] where it ends
  const uint16_t* start_spread = nullptr;  // [N] how far off the vote may be, Q16 of the side, at least 1
  const uint16_t* end_spread = nullptr;    // [N]
  const uint16_t* start_class = nullptr;   // [N x kJointClasses] probabilities, Q15
  const uint16_t* end_class = nullptr;     // [N x kEndClasses] probabilities, Q15
  const Vec3i* inside = nullptr;           // [N] a position in the body behind the point; null if unknown
  Vec3i mean = {0, 0, 0};                  // of the points
};

}  // namespace sinew::rigging
#endif
