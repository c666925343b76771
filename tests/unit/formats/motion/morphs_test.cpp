// SPDX-License-Identifier: MIT
// Weights of corrective shapes by turns of joints, and meshes under them.
#include "sinew_formats/morphs.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "sinew_character/pose/pose.hpp"
#include "sinew_formats/base/affine.hpp"

namespace sinew {
namespace {

Character two_points() {
  Character c;
  c.joints = {{"a", {0, 0, 0}, -1}, {"b", {0, 2, 0}, 0}};
  c.vertices = {{0, 1, 0}, {1, 3, 0}};
  c.influences = {{{0, 1.0f}}, {{1, 1.0f}}};
  return c;
}

// Weight: 0.5 (R10 - 0) of the turn of b, and 2 u_z(a) u_x(b).
Morphs one_shape() {
  Morphs morphs;
  morphs.shapes = {{"b.1", {1}, {{0, 0.5f, 0}}}};
  MorphTerm one{1, 1, {{}}}, two{0, 1, {{}}};
  one.factors[0][3] = 0.5;
  two.factors[0][6] = 2;
  morphs.drivers = {{1, {{0, 0, 1}}, {one, two}}};
  return morphs;
}

TEST(Morphs, NothingAtRestAndSmoothAtHalfATurn) {
  const MorphDriver driver = one_shape().drivers[0];
  EXPECT_EQ(driver_weights(driver, {kNoRotation4, kNoRotation4})[0], 0);
  EXPECT_NEAR(driver_weights(driver, {kNoRotation4, axis_rotation(2, 1)})[0], 0.5 * std::sin(1), 1e-9);
  EXPECT_NEAR(driver_weights(driver, {axis_rotation(2, 0.5), axis_rotation(0, 1)})[0], 2 * std::sin(0.5) * std::sin(1),
              1e-9);
  EXPECT_NEAR(driver_weights(driver, {axis_rotation(2, 0.5), axis_rotation(1, 1)})[0], 0, 1e-9);
  Quaternion other = axis_rotation(2, 1);
  for (double& x : other) x = -x;
  EXPECT_NEAR(driver_weights(driver, {kNoRotation4, other})[0], 0.5 * std::sin(1), 1e-9) << "the same turn";
  const double half = std::acos(-1.0);
  EXPECT_NEAR(driver_weights(driver, {axis_rotation(2, 0.5), axis_rotation(0, half - 1e-6)})[0],
              driver_weights(driver, {axis_rotation(2, 0.5), axis_rotation(0, half + 1e-6)})[0], 1e-5);
}

// Blender, gltfpack and others clamp weights to 0..1.
TEST(Morphs, EachDirectionIsAShapeOfItsOwnAndNoWeightIsBelow0OrAbove1) {
  MorphDriver driver = one_shape().drivers[0];
  driver.weights = {{0, 0, 3}, {1, 0, -2}};
  const std::vector<double> one = driver_weights(driver, {kNoRotation4, axis_rotation(2, 0.3)}),
                            other = driver_weights(driver, {kNoRotation4, axis_rotation(2, -0.3)}),
                            far = driver_weights(driver, {kNoRotation4, axis_rotation(2, 1.5)});
  EXPECT_NEAR(one[0], 1.5 * std::sin(0.3), 1e-9);
  EXPECT_EQ(one[1], 0);
  EXPECT_EQ(other[0], 0);
  EXPECT_NEAR(other[1], std::sin(0.3), 1e-9);
  EXPECT_EQ(far[0], 1);
}

TEST(Morphs, ValuesOfOneTurnAreItsMatrixLessNone) {
  const std::array<double, 9> values = term_values({0, 0, {}}, {axis_rotation(2, 1)});
  EXPECT_NEAR(values[0], std::cos(1) - 1, 1e-9);
  EXPECT_NEAR(values[1], -std::sin(1), 1e-9);
  EXPECT_NEAR(values[3], std::sin(1), 1e-9);
  EXPECT_NEAR(values[8], 0, 1e-9);
}

TEST(Morphs, TurnsAreAgainstTheParent) {
  const Character c = two_points();
  const std::vector<Affine> palette = pose_palette(c, {{0, 0, 90, 0}, {1, 0, 0, 30}});
  EXPECT_NEAR(dot(joint_rotation(c.joints, palette, 1), axis_rotation(2, std::acos(-1.0) / 6)), 1, 1e-9);
  EXPECT_NEAR(dot(joint_rotation(c.joints, palette, 0), axis_rotation(1, std::acos(0.0))), 1, 1e-9);
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
