// SPDX-License-Identifier: MIT
// A segment through a triangle, beside it and short of it.
#include <gtest/gtest.h>

#include "core/triangle.hpp"

namespace sinew {
namespace {

bool through(Vec3d from, Vec3d to) { return goes_through(from, to, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}); }

TEST(SegmentTriangle, OnlyWhatCrossesTheInsideGoesThrough) {
  EXPECT_TRUE(through({0.2, 0.2, -1}, {0.2, 0.2, 1}));
  EXPECT_TRUE(through({0.2, 0.2, 1}, {0.2, 0.2, -1})) << "from either side";
  EXPECT_TRUE(through({-0.3, 0.25, 1}, {0.8, 0.25, -1})) << "aslant";
  EXPECT_FALSE(through({0.6, 0.6, -1}, {0.6, 0.6, 1})) << "beyond the long edge";
  EXPECT_FALSE(through({-0.1, 0.5, -1}, {-0.1, 0.5, 1}));
  EXPECT_FALSE(through({0.5, -0.1, -1}, {0.5, -0.1, 1}));
  EXPECT_FALSE(through({0.2, 0.2, 0.1}, {0.2, 0.2, 1})) << "ends before the plane";
  EXPECT_FALSE(through({-1, 0.2, 0}, {1, 0.2, 0})) << "in the plane";
}

}  // namespace
}  // namespace sinew
