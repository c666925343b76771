// SPDX-License-Identifier: MIT
// Rotations that fit vectors: known turns come back, vectors on a line say so, half turns and nothing give a rotation as well.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "transfer/align.hpp"

namespace sinew::transferring {
namespace {

void expect_rotation(const Mat3& r) {
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) {
      double sum = 0;
      for (int e = 0; e < 3; ++e) sum += r.m[3 * i + e] * r.m[3 * k + e];
      EXPECT_NEAR(sum, i == k ? 1 : 0, 1e-12);
    }
  }
}

void add(Mat3* sums, Vec3d v, Vec3d u) {
  const double vs[3] = {v.x, v.y, v.z}, us[3] = {u.x, u.y, u.z};
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) sums->m[3 * i + k] += vs[i] * us[k];
}

TEST(BestRotation, KnownTurnsComeBack) {
  std::mt19937 random(3);
  std::normal_distribution<double> draw;
  for (int i = 0; i < 200; ++i) {
    double q[4], square = 0;
    for (double& x : q) {
      x = draw(random);
      square += x * x;
    }
    for (double& x : q) x /= std::sqrt(square);
    const Mat3 turn = rotation(q[0], q[1], q[2], q[3]);
    Mat3 sums = {{0, 0, 0, 0, 0, 0, 0, 0, 0}};
    for (int k = 0; k < 5; ++k) {
      const Vec3d u = {draw(random), draw(random), draw(random)};
      add(&sums, turn * u, u);
    }
    double gap = 0;
    const Mat3 found = best_rotation(sums, &gap);
    expect_rotation(found);
    EXPECT_GT(gap, 0);
    for (int e = 0; e < 9; ++e) EXPECT_NEAR(found.m[e], turn.m[e], 1e-9);
  }
}

TEST(BestRotation, VectorsOnALineLeaveATurnOpen) {
  Mat3 sums = {{0, 0, 0, 0, 0, 0, 0, 0, 0}};
  add(&sums, {0, 0, 2}, {0, 1, 0});
  add(&sums, {0, 0, 4}, {0, 2, 0});
  double gap = 1;
  const Mat3 found = best_rotation(sums, &gap);
  expect_rotation(found);
  EXPECT_LT(gap, 1e-9);
  EXPECT_NEAR((found * Vec3d{0, 1, 0}).z, 1, 1e-9);
}

TEST(BestRotation, NothingIsNoTurn) {
  double gap = 1;
  const Mat3 found = best_rotation({{0, 0, 0, 0, 0, 0, 0, 0, 0}}, &gap);
  for (int e = 0; e < 9; ++e) EXPECT_EQ(found.m[e], Mat3().m[e]);
  EXPECT_EQ(gap, 0);
}

TEST(RotationBetween, TurnsOneDirectionIntoTheOther) {
  const Vec3d directions[] = {{1, 0, 0}, {-1, 0, 0}, {0, 3, 0}, {0.2, -0.4, 5}, {1, 1e-7, 0}, {0, 0, -2}};
  for (const Vec3d& u : directions) {
    for (const Vec3d& v : directions) {
      const Mat3 turn = rotation_between(u, v);
      expect_rotation(turn);
      EXPECT_NEAR(length(turn * unit(u) - unit(v)), 0, 1e-6);
    }
  }
}

}  // namespace
}  // namespace sinew::transferring
