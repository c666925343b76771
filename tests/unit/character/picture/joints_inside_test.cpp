// SPDX-License-Identifier: MIT
// Joints beside a figure go into its middle; others stay.
#include "picture/joints_inside.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "sinew_character/picture/picture_mesh.hpp"
#include "small_pictures.hpp"

namespace sinew {
namespace {

// A trunk of radius 50 with an arm, 20 wide, to the right; y runs down in pictures, up in meshes.
bool in_body(int x, int y) { return test::in_disc(x, y, 80, 100, 50) || (x >= 100 && x < 250 && y >= 90 && y < 110); }

TEST(JointsInside, WhatLiesBesideTheFigureGoesIn) {
  const PictureFile picture =
      test::picture_of(270, 200, [](int x, int y) { return in_body(x, y) ? test::kRed : test::kClear; });
  PictureMeshOptions options;
  options.pixels = true;
  const Character mesh = picture_mesh(picture, find_figure(picture), options);
  PredictedSkeleton skeleton;
  skeleton.joints = {{"Hips", {80, 100, 1}, -1, {}},
                     {"Elbow", {180, 118, 2}, 0, {}},
                     {"Hand", {256, 96, 2}, 1, {}},
                     {"Tail", {18, 100, 0}, 0, {}},
                     {"Shoulder", {150, 93, 0}, 0, {}}};
  move_joints_inside(mesh, &skeleton);
  const auto at = [&](size_t j) { return skeleton.joints[j].position; };
  EXPECT_EQ(at(0).x, 80);
  EXPECT_EQ(at(4).y, 93) << "it is inside";
  EXPECT_NEAR(at(1).x, 180, 8);
  EXPECT_NEAR(at(1).y, 100, 4) << "the middle of the arm";
  EXPECT_EQ(at(1).z, 2);
  EXPECT_LT(at(2).x, 250);
  EXPECT_GT(at(2).x, 225);
  EXPECT_NEAR(at(3).x, 80, 12) << "the middle of the trunk";
  EXPECT_NEAR(at(3).y, 100, 12);
}

}  // namespace
}  // namespace sinew
