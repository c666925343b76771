// SPDX-License-Identifier: MIT
// Bends are where vertices follow two joints; drivers find the turns that move them, and few shapes.
#include "bake/bake_steps.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace sinew {

// Bends are where vertices follow what is below a joint and something else.

namespace {

TEST(Bends, NearestFirst) {
  Character c;
  c.joints = {
      {"root", {0, 0, 0}, -1}, {"a", {0, 1, 0}, 0}, {"b", {0, 2, 0}, 1}, {"c", {0, 3, 0}, 2}, {"d", {0, 4, 0}, 3}};
  c.influences = {{{0, 0.5f}, {1, 0.5f}}, {{1, 0.5f}, {2, 0.5f}}, {{2, 0.2f}, {3, 0.8f}}, {{1, 1.0f}}, {{3, 1.0f}}};
  c.vertices.resize(5);
  const Bends bends = find_bends(c, 2);
  EXPECT_EQ(bends.joints, (std::vector<size_t>{1, 2, 3})) << "nothing follows d, nothing is before the root";
  EXPECT_EQ(bends.distances[1], (std::vector<double>{1.5, 0.5, 0, 1, 2}));
  EXPECT_EQ(bends.of_vertex[0], (std::vector<size_t>{0, 1}));
  EXPECT_EQ(bends.of_vertex[2], (std::vector<size_t>{2, 1}));
  EXPECT_EQ(bends.of_vertex[3], (std::vector<size_t>{0, 1})) << "first the one that moves it";
  EXPECT_EQ(bends.of_vertex[4], (std::vector<size_t>{2, 1}));
}

TEST(Bends, NoneWhereEachVertexFollowsOneRigidPart) {
  Character c;
  c.joints = {{"root", {0, 0, 0}, -1}, {"a", {0, 1, 0}, 0}};
  c.influences = {{{0, 1.0f}}, {{1, 1.0f}}};
  c.vertices.resize(2);
  const Bends bends = find_bends(c, 2);
  EXPECT_TRUE(bends.joints.empty());
  EXPECT_TRUE(bends.of_vertex[1].empty());
}

TEST(Bends, BetweenVerticesOfRigidParts) {
  Character c;
  c.joints = {{"root", {0, 0, 0}, -1}, {"a", {0, 1, 0}, 0}};
  c.influences = {{{0, 1.0f}}, {{1, 1.0f}}, {{1, 1.0f}}};
  c.vertices.resize(3);
  c.face_offsets = {0, 3};
  c.face_vertices = {0, 1, 2};
  EXPECT_EQ(find_bends(c, 2).joints, std::vector<size_t>{1});
}

// Drivers find the turns that move a region, two together too, and as few shapes as tell it.

constexpr size_t kPoses = 300;

Character chain() {
  Character c;
  c.joints = {{"root", {0, 0, 0}, -1}, {"a", {0, 1, 0}, 0}, {"b", {0, 2, 0}, 1}, {"c", {0, 3, 0}, 2}};
  return c;
}

// One vertex that goes along x by a value of the turns.
Eigen::MatrixXf moves_by(const PoseRotations& turns, const MorphTerm& term, size_t value) {
  Eigen::MatrixXf moves = Eigen::MatrixXf::Zero(kPoses, 3);
  for (size_t p = 0; p < kPoses; ++p)
    moves(static_cast<Eigen::Index>(p), 0) = static_cast<float>(term_values(term, turns.poses()[p])[value]);
  return moves;
}

// How much of the moves the first sum leaves, where both are of mean square 1.
double left_over(const MorphDriver& driver, const PoseRotations& turns, const Eigen::MatrixXf& moves) {
  double product = 0, weights = 0, wanted = 0;
  for (size_t p = 0; p < kPoses; ++p) {
    const double w = driver_sums(driver, turns.poses()[p]).at(0);
    const double m = static_cast<double>(moves(static_cast<Eigen::Index>(p), 0));
    product += w * m, weights += w * w, wanted += m * m;
  }
  return 1 - product * product / (weights * wanted);
}

TEST(DriverFit, OneTurnNeedsOneShape) {
  const Character c = chain();
  const PoseRotations turns(c, random_palettes(c, kPoses, 60, 1));
  EXPECT_EQ(turns.joints(), (std::vector<size_t>{1, 2, 3}));
  const Eigen::MatrixXf moves = moves_by(turns, {2, 2, {}}, 5);
  const MorphDriver driver = fit_driver(turns, {0.5, 0.5, 0, 1}, moves, 8);
  EXPECT_EQ(driver.sum_count(), 1u);
  EXPECT_EQ(driver.weights.size(), 2u) << "it turns both ways";
  EXPECT_EQ(driver.terms[0].joint, 2u) << "the one that explains most is first";
  EXPECT_LT(left_over(driver, turns, moves), 0.01);
}

TEST(DriverFit, WhatIsNegligibleGetsNoSum) {
  const Character c = chain();
  const PoseRotations turns(c, random_palettes(c, kPoses, 60, 1));
  const Eigen::MatrixXf moves = moves_by(turns, {2, 2, {}}, 5);
  const double all = moves.cast<double>().squaredNorm();
  EXPECT_EQ(fit_driver(turns, {0.5, 0.5, 0, 1}, moves, 8, 0.2 * all).sum_count(), 1u);
  EXPECT_TRUE(fit_driver(turns, {0.5, 0.5, 0, 1}, moves, 8, 1.1 * all).weights.empty());
}

TEST(DriverFit, TwoTurnsTogetherAreFound) {
  const Character c = chain();
  const PoseRotations turns(c, random_palettes(c, kPoses, 60, 1));
  const Eigen::MatrixXf alone = moves_by(turns, {1, 1, {}}, 1), too = moves_by(turns, {3, 3, {}}, 2);
  const Eigen::MatrixXf moves = alone + too + 2 * moves_by(turns, {1, 3, {}}, 5);
  const MorphDriver driver = fit_driver(turns, {1, 0.5, 0, 1}, moves, 8);
  EXPECT_LT(left_over(driver, turns, moves), 0.02);
}

TEST(DriverFit, NothingThatTurnsDrivesNothing) {
  const Character c = chain();
  const PoseRotations turns(c, std::vector<Palette>(5, Palette(4, kIdentity)));
  EXPECT_TRUE(fit_driver(turns, {1, 0.5, 0, 1}, Eigen::MatrixXf::Ones(5, 3), 8).weights.empty());
}

}  // namespace
}  // namespace sinew
