// SPDX-License-Identifier: MIT
// Joints never leave their limits, and what is within stays bit for bit.
#include "sinew/joint_limits.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

namespace {

constexpr double kDegree = 3.14159265358979323846 / 180;

std::array<float, 4> turned(double x, double y, double z, double degrees) {
  const double s = std::sin(degrees * kDegree / 2);
  return {static_cast<float>(s * x), static_cast<float>(s * y), static_cast<float>(s * z),
          static_cast<float>(std::cos(degrees * kDegree / 2))};
}

sinew_joint_limit hinge(float least, float most) { return {0, SINEW_LIMIT_HINGE, {}, {0, 0, 2}, {}, {least}, {most}}; }

// Bone along y, swings about x and -z.
sinew_joint_limit ball() { return {0, SINEW_LIMIT_BALL, {}, {0, 1, 0}, {1, 0.5f, 0}, {-40, -10, -30}, {20, 120, 0}}; }

std::array<double, 3> angles(const std::array<float, 4>& q) {  // twist about y, then swing about x and -z, degrees
  const double y = static_cast<double>(q[1]), w = static_cast<double>(q[3]), n = std::sqrt(y * y + w * w);
  const double sign = w < 0 ? -1 : 1, ty = sign * y / n, tw = sign * w / n;
  // swing = q * conj(twist)
  const double x = static_cast<double>(q[0]), z = static_cast<double>(q[2]);
  const double sx = x * tw + z * ty, sz = z * tw - x * ty;
  return {2 * std::asin(ty) / kDegree, 2 * std::asin(sign * sx) / kDegree, 2 * std::asin(-sign * sz) / kDegree};
}

TEST(JointLimits, AHingeKeepsItsAxisAndItsRange) {
  const sinew_joint_limit limit = hinge(-30, 100);
  for (const auto& [given, wanted] : {std::pair<double, double>{50, 50},
                                      {-29, -29},
                                      {150, 100},
                                      {-60, -30},
                                      {-170, 100},
                                      {-150, 100},
                                      {-140, -30},
                                      {179, 100}}) {
    std::array<float, 4> q = turned(0, 0, 1, given);
    ASSERT_EQ(sinew_keep_joint_limits(&limit, 1, 1, 1, q.data()), SINEW_OK);
    EXPECT_NEAR(2 * std::asin(static_cast<double>(q[2])) / kDegree, wanted, 1e-4) << given;
  }
  std::array<float, 4> aside = turned(1, 0, 0, 70);
  ASSERT_EQ(sinew_keep_joint_limits(&limit, 1, 1, 1, aside.data()), SINEW_OK);
  EXPECT_EQ(aside[0], 0);
  EXPECT_EQ(aside[3], 1);
  const sinew_joint_limit fixed = hinge(90, 90);
  ASSERT_EQ(sinew_keep_joint_limits(&fixed, 1, 1, 1, aside.data()), SINEW_OK);
  EXPECT_NEAR(static_cast<double>(aside[2]), std::sqrt(0.5), 1e-7);
}

TEST(JointLimits, ABallNeverGoesOver) {
  const sinew_joint_limit limit = ball();
  std::mt19937 random(7);
  size_t within = 0;
  for (int i = 0; i < 4000; ++i) {
    std::array<float, 4> q;
    for (float& x : q) x = static_cast<float>(static_cast<int>(random() % 2001) - 1000) / 1000;
    if (i % 2 == 0) q[3] = 3;  // near the rest pose
    const float norm = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    for (float& x : q) x /= norm;
    std::array<float, 4> held = q;
    ASSERT_EQ(sinew_keep_joint_limits(&limit, 1, 1, 1, held.data()), SINEW_OK);
    const std::array<double, 3> at = angles(held);
    EXPECT_GE(at[0], -40.001);
    EXPECT_LE(at[0], 20.001);
    EXPECT_GE(at[1], -10.001);
    EXPECT_LE(at[1], 120.001);
    EXPECT_GE(at[2], -30.001);
    EXPECT_LE(at[2], 0.001);
    std::array<float, 4> again = held;
    ASSERT_EQ(sinew_keep_joint_limits(&limit, 1, 1, 1, again.data()), SINEW_OK);
    for (size_t k = 0; k < 4; ++k) EXPECT_NEAR(static_cast<double>(again[k]), static_cast<double>(held[k]), 1e-6);
    within += held == q ? 1 : 0;
  }
  EXPECT_GT(within, 100u) << "what is within stays";
  EXPECT_LT(within, 2000u);
}

TEST(JointLimits, AnglesCountFromZero) {
  sinew_joint_limit limit = hinge(-10, 10);
  const std::array<float, 4> zero = turned(0, 0, 1, 90);
  std::copy(zero.begin(), zero.end(), limit.zero);
  std::array<float, 4> q = turned(0, 0, 1, 150);
  ASSERT_EQ(sinew_keep_joint_limits(&limit, 1, 1, 1, q.data()), SINEW_OK);
  EXPECT_NEAR(2 * std::asin(static_cast<double>(q[2])) / kDegree, 100, 1e-4);
}

TEST(JointLimits, OtherJointsAndOtherFramesStay) {
  sinew_joint_limit limit = hinge(0, 10);
  limit.joint = 1;
  std::vector<float> rotations;
  for (int i = 0; i < 6; ++i)
    for (const float x : turned(0, 0, 1, 40)) rotations.push_back(x);
  const std::vector<float> before = rotations;
  ASSERT_EQ(sinew_keep_joint_limits(&limit, 1, 3, 2, rotations.data()), SINEW_OK);
  for (size_t i = 0; i < rotations.size(); ++i) {
    if ((i / 4) % 3 == 1) continue;
    EXPECT_EQ(rotations[i], before[i]);
  }
  EXPECT_NE(rotations[6], before[6]);
  EXPECT_NE(rotations[18], before[18]);
}

TEST(JointLimits, WrongOnesAreRefusedAndNothingMoves) {
  std::array<float, 4> q = turned(0, 0, 1, 90);
  const std::array<float, 4> before = q;
  const auto status = [&](const sinew_joint_limit& limit) {
    return sinew_keep_joint_limits(&limit, 1, 1, 1, q.data());
  };
  EXPECT_EQ(status(hinge(20, 10)), SINEW_ERROR_ARGUMENT);
  EXPECT_EQ(status(hinge(-200, 10)), SINEW_ERROR_ARGUMENT);
  sinew_joint_limit wrong = hinge(-10, 10);
  wrong.kind = 0;
  EXPECT_EQ(status(wrong), SINEW_ERROR_ARGUMENT);
  wrong = hinge(-10, 10);
  wrong.axis[2] = 0;
  EXPECT_EQ(status(wrong), SINEW_ERROR_ARGUMENT);
  wrong = hinge(-10, 10);
  wrong.joint = 1;
  EXPECT_EQ(status(wrong), SINEW_ERROR_INDEX);
  wrong = ball();
  wrong.least[1] = 5;
  EXPECT_EQ(status(wrong), SINEW_ERROR_ARGUMENT);
  wrong = ball();
  wrong.side[0] = 0;
  EXPECT_EQ(status(wrong), SINEW_ERROR_ARGUMENT) << "along the axis";
  wrong = hinge(-10, NAN);
  EXPECT_EQ(status(wrong), SINEW_ERROR_NOT_FINITE);
  EXPECT_EQ(sinew_keep_joint_limits(nullptr, 1, 1, 1, q.data()), SINEW_ERROR_ARGUMENT);
  EXPECT_EQ(sinew_keep_joint_limits(nullptr, 0, 0, 0, q.data()), SINEW_ERROR_COUNT);
  EXPECT_EQ(q, before);
}

}  // namespace
