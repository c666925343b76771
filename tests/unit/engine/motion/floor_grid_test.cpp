// SPDX-License-Identifier: MIT
// Heights of an uneven floor between the points of its grid, and beyond them.
#include <gtest/gtest.h>

#include "motion/clip_scene.hpp"

namespace {

using sinew::motion::FloorGrid;

TEST(FloorGrid, HeightsAreBetweenThoseOfTheGrid) {
  const float heights[] = {0, 1, 2, 4, 5, 6};  // 3 x 2
  const sinew_floor floor = {heights, 3, 2, {10, 20}, 0.5f, 0};
  FloorGrid grid;
  EXPECT_EQ(grid.height({0, 1, 0}, {10, 0, 20}), 0) << "level without a floor";
  ASSERT_EQ(grid.take(&floor), SINEW_OK);
  EXPECT_DOUBLE_EQ(grid.height({0, 1, 0}, {10, 7, 20}), 0);
  EXPECT_DOUBLE_EQ(grid.height({0, 1, 0}, {10.25, 7, 20}), 0.5);
  EXPECT_DOUBLE_EQ(grid.height({0, 1, 0}, {10.5, 7, 20.25}), 3);
  EXPECT_DOUBLE_EQ(grid.height({0, 1, 0}, {12, 7, 25}), 6) << "beyond the corner";
  EXPECT_DOUBLE_EQ(grid.height({0, 1, 0}, {0, 7, 0}), 0);
  EXPECT_DOUBLE_EQ(grid.height({0, 0, 1}, {10.5, 20.25, 7}), 3) << "x and y where z is up";
  EXPECT_DOUBLE_EQ(grid.height({1, 0, 0}, {7, 10.5, 20.25}), 3) << "y and z where x is up";
}

TEST(FloorGrid, OnePointIsALevelFloor) {
  const float height = 3;
  const sinew_floor floor = {&height, 1, 1, {0, 0}, 1, 0};
  FloorGrid grid;
  ASSERT_EQ(grid.take(&floor), SINEW_OK);
  EXPECT_EQ(grid.height({0, 1, 0}, {5, 5, 5}), 3);
}

}  // namespace
