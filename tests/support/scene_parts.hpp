// SPDX-License-Identifier: MIT
// What every scene of the tests has: positions of vertices and a skeleton.
#ifndef SINEW_TESTS_SUPPORT_SCENE_PARTS_HPP
#define SINEW_TESTS_SUPPORT_SCENE_PARTS_HPP

#include <cstdint>
#include <vector>

#include "sinew/types.h"
#include "skeleton_of.hpp"

namespace sinew_test {

struct SceneParts {
  std::vector<float> positions;  // [V x 3]
  std::vector<float> joints;     // [J x 3]
  std::vector<int32_t> parents;
  std::vector<uint8_t> flags;  // empty: none
  uint32_t up = SINEW_UP_AUTO;

  uint32_t vertex_count() const { return static_cast<uint32_t>(positions.size() / 3); }
  uint32_t joint_count() const { return static_cast<uint32_t>(parents.size()); }
  uint32_t add_vertex(double x, double y, double z) {
    positions.insert(positions.end(), {static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)});
    return vertex_count() - 1;
  }
  uint32_t add_joint(double x, double y, double z, int32_t parent) {
    joints.insert(joints.end(), {static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)});
    parents.push_back(parent);
    return joint_count() - 1;
  }
  // A view of the scene, which must outlive it.
  sinew_skeleton skeleton_view() const {
    sinew_skeleton view = skeleton_of(joints.data(), parents.data(), joint_count());
    view.flags = flags.empty() ? nullptr : flags.data();
    view.up = up;
    return view;
  }
};

}  // namespace sinew_test
#endif
