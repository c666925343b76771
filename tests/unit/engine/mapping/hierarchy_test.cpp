// SPDX-License-Identifier: MIT
// The order of a rig's joints: parents first, every subtree in one run; what is no hierarchy is refused.
#include "mapping/hierarchy.hpp"

#include <limits>

#include "small_rig.hpp"

namespace sinew::mapping {
namespace {

TEST(MapHierarchy, SubtreesAreRunsAndParentsComeFirst) {
  SmallRig small;
  small.parents = {1, -1, 1, 4, 0, 1, 5};  // any order of numbers
  ASSERT_EQ(small.build(), SINEW_OK);
  const Hierarchy& rig = small.rig;
  for (int32_t i = 0; i < rig.n; ++i) {
    const int32_t up = rig.parent[i];
    EXPECT_EQ(rig.order[rig.position[i]], i);
    EXPECT_TRUE(up < 0 || rig.position[up] < rig.position[i]);
    EXPECT_EQ(rig.depth[i], up < 0 ? 0 : rig.depth[up] + 1);
    int32_t held = 0;
    for (int32_t k = 0; k < rig.n; ++k) {
      bool below = false;
      for (int32_t a = k; a >= 0; a = rig.parent[a]) below = below || a == i;
      EXPECT_EQ(rig.holds(i, k), below) << i << " " << k;
      held += below;
    }
    EXPECT_EQ(rig.count[i], held);
  }
  EXPECT_EQ(rig.first_root(), 1);
  EXPECT_EQ(rig.common(3, 6), 1);
  EXPECT_EQ(rig.common(3, 0), 0);
}

TEST(MapHierarchy, ReachIsTheLongestPathDown) {
  SmallRig small;
  ASSERT_EQ(small.build(), SINEW_OK);
  const double arm = small.rig.bone(1, 3) + small.rig.bone(3, 4);
  EXPECT_NEAR(small.rig.reach[0], 1 + arm, 1e-12);
  EXPECT_EQ(small.rig.reach[4], 0);
}

// A root and a target beside the body do not make it larger; a joint or two of a small rig are not left out.
TEST(MapHierarchy, SizeIsThatOfTheBody) {
  SmallRig small;
  const size_t body = small.parents.size();
  for (int32_t& parent : small.parents) ++parent;
  small.parents.insert(small.parents.begin(), -1);
  small.positions.insert(small.positions.begin(), {0, 0, 9});
  ASSERT_EQ(small.build(), SINEW_OK);
  const double diagonal = length(Point{4, 2, 0.5});
  EXPECT_NEAR(small.rig.size, diagonal, 1e-9);
  EXPECT_EQ(small.rig.apart[0], 1);
  for (size_t j = 1; j <= body; ++j) EXPECT_EQ(small.rig.apart[j], 0);
  EXPECT_EQ(small.rig.first_of_body(), 1);
  EXPECT_EQ(small.rig.end[0], 0) << "it carries the body";
  SmallRig pair;
  pair.parents = {-1, 0};
  pair.positions = {0, 0, 0, 0, 0, 5};
  ASSERT_EQ(pair.build(), SINEW_OK);
  EXPECT_EQ(pair.rig.size, 5);
}

TEST(MapHierarchy, CirclesAndWrongParentsAreRefused) {
  SmallRig circle;
  circle.parents[3] = 4;
  EXPECT_EQ(circle.build(), SINEW_ERROR_HIERARCHY);
  SmallRig far;
  far.parents[3] = 7;
  EXPECT_EQ(far.build(), SINEW_ERROR_INDEX);
  SmallRig nowhere;
  nowhere.positions[4] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(nowhere.build(), SINEW_ERROR_NOT_FINITE);
}

}  // namespace
}  // namespace sinew::mapping
