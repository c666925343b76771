// SPDX-License-Identifier: MIT
// A rig of a few joints without names, read as mapping reads it.
#ifndef SINEW_TESTS_MAPPING_SMALL_RIG_HPP
#define SINEW_TESTS_MAPPING_SMALL_RIG_HPP

#include <gtest/gtest.h>

#include <vector>

#include "mapping/hierarchy.hpp"
#include "sinew/sinew.hpp"
#include "skeleton_of.hpp"

namespace sinew::mapping {

// A trunk of three along y, two arms of two joints and a leaf above: hips, chest, head; left, right.
struct SmallRig {
  std::vector<float> positions = {0, 1, 0, 0, 2, 0, 0, 3, 0, 1, 2, 0.5f, 2, 2, 0.5f, -1, 2, 0.5f, -2, 2, 0.5f};
  std::vector<int32_t> parents = {-1, 0, 1, 1, 3, 1, 5};
  std::vector<uint8_t> ends;  // empty: not told
  Workspace memory = Workspace(1 << 20);
  Arena arena = Arena(memory.data(), memory.size());
  Hierarchy rig;

  sinew_skeleton view() const {
    sinew_skeleton view = sinew_test::skeleton_of(positions, parents);
    if (!ends.empty()) view.ends = ends.data();
    return view;
  }
  sinew_status build() {
    EXPECT_TRUE(rig.allocate(arena, static_cast<uint32_t>(parents.size())));
    return rig.build(view(), false);
  }
};

}  // namespace sinew::mapping
#endif
