// SPDX-License-Identifier: MIT
// A body for sinew/motion_clips.h in arrays of its own.
#ifndef SINEW_TESTS_SUPPORT_SKINNED_TRIANGLES_HPP
#define SINEW_TESTS_SUPPORT_SKINNED_TRIANGLES_HPP

#include <cstdint>
#include <vector>

#include "sinew/motion.h"

namespace sinew_test {

struct SkinnedTriangles {
  uint32_t influence_count;
  std::vector<float> positions;           // [V, 3]
  std::vector<uint16_t> joints, weights;  // [V, influence_count]
  std::vector<uint32_t> triangles;        // [T, 3]

  explicit SkinnedTriangles(uint32_t influences) : influence_count(influences) {}
  sinew_motion_body view() const {
    return {positions.data(),
            triangles.data(),
            {joints.data(), weights.data(), influence_count, SINEW_WEIGHT_UNORM16},
            static_cast<uint32_t>(positions.size() / 3),
            static_cast<uint32_t>(triangles.size() / 3)};
  }
};

}  // namespace sinew_test
#endif
