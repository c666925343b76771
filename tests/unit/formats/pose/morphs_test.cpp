// SPDX-License-Identifier: MIT
// Weights of corrective shapes by turns of joints, and meshes under them.
#include "sinew_formats/morphs.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "motion/turns.hpp"
#include "sinew_formats/pose.hpp"

namespace sinew {
namespace {

Character two_points() {
  Character c;
  c.joints = {{"a", {0, 0, 0}, -1}, {"b", {0, 2, 0}, 0}};
  c.vertices = {{0, 1, 0}, {1, 3, 0}};
  c.influences = {{{0, 1.0f}}, {{1, 1.0f}}};
  return c;
}

Morphs one_shape() {
  Morphs morphs;
  morphs.shapes = {{"b.1", {1}, {{0, 0.5f, 0}}}};
  morphs.drivers = {{1, 0.8, {axis_turn(2, 1)}, {0}}};
  return morphs;
}

TEST(Morphs, NothingAtRestAndMostAtTheCentre) {
  const MorphDriver driver = one_shape().drivers[0];
  EXPECT_EQ(driver_weights(driver, kNoTurn4)[0], 0);
  EXPECT_NEAR(driver_weights(driver, axis_turn(2, 1))[0], 1 - std::exp(-1 / 0.64), 1e-9);
  EXPECT_NEAR(driver_weights(driver, axis_turn(2, 1.4))[0], std::exp(-0.25) - std::exp(-1 / 0.64), 1e-9);
  EXPECT_LT(driver_weights(driver, axis_turn(2, -1))[0], 0) << "further from the centre than rest";
  Quaternion other = axis_turn(2, 1);
  for (double& x : other) x = -x;
  EXPECT_NEAR(driver_weights(driver, other)[0], 1 - std::exp(-1 / 0.64), 1e-9) << "the same turn";
}

TEST(Morphs, TurnsAreAgainstTheParent) {
  const Character c = two_points();
  const std::vector<Affine> palette = pose_palette(c, {{0, 0, 90, 0}, {1, 0, 0, 30}});
  EXPECT_NEAR(dot(joint_turn(c.joints, palette, 1), axis_turn(2, std::acos(-1.0) / 6)), 1, 1e-9);
  EXPECT_NEAR(dot(joint_turn(c.joints, palette, 0), axis_turn(1, std::acos(0.0))), 1, 1e-9);
}

TEST(Morphs, ShapesMoveBeforeSkinning) {
  const Character c = two_points();
  const Morphs morphs = one_shape();
  const std::vector<Affine> palette = pose_palette(c, {{1, 0, 0, 90}});
  const std::vector<float> weights = shape_weights(c.joints, morphs, palette);
  ASSERT_EQ(weights.size(), 1u);
  const std::vector<Vec3> posed = morphed_pose(c, morphs, weights, palette);
  EXPECT_NEAR(posed[1].x, -1 - 0.5f * weights[0], 1e-6);  // (1, 3) about (0, 2) becomes (-1, 3)
  EXPECT_NEAR(posed[1].y, 3, 1e-6);
  EXPECT_NEAR(posed[0].y, 1, 1e-6);
}

}  // namespace
}  // namespace sinew
