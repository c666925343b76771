// SPDX-License-Identifier: MIT
// The engine's skeleton of arrays: where joints are and on which others they hang; all else as by default. The arrays must outlive it.
#ifndef SINEW_TESTS_SUPPORT_SKELETON_OF_HPP
#define SINEW_TESTS_SUPPORT_SKELETON_OF_HPP

#include <cstdint>
#include <vector>

#include "sinew/sinew.h"

namespace sinew_test {

inline sinew_skeleton skeleton_of(const float* positions, const int32_t* parents, uint32_t joint_count) {
  sinew_skeleton skeleton = SINEW_INIT(sinew_skeleton);
  skeleton.positions = positions;
  skeleton.parents = parents;
  skeleton.joint_count = joint_count;
  return skeleton;
}

inline sinew_skeleton skeleton_of(const std::vector<float>& positions, const std::vector<int32_t>& parents) {
  return skeleton_of(positions.data(), parents.data(), static_cast<uint32_t>(parents.size()));
}

}  // namespace sinew_test
#endif
