// SPDX-License-Identifier: MIT
// Linear blend and dual quaternion skinning: identity, rigid motions, blends with known results, refused joint indices.
#include "deform/skinning.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <vector>

namespace sinew::deform {
namespace {

using Palette = std::vector<float>;
using Vec = std::array<double, 3>;

// Rotation about an axis by an angle (Rodrigues), then a translation; row-major 3x4.
void add_motion(Palette* palette, Vec axis, double angle, Vec move) {
  const double n = std::sqrt(axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2]);
  for (double& a : axis) a /= n;
  const double c = std::cos(angle), s = std::sin(angle), x = axis[0], y = axis[1], z = axis[2];
  const double m[12] = {c + x * x * (1 - c),     x * y * (1 - c) - z * s, x * z * (1 - c) + y * s, move[0],
                        y * x * (1 - c) + z * s, c + y * y * (1 - c),     y * z * (1 - c) - x * s, move[1],
                        z * x * (1 - c) - y * s, z * y * (1 - c) + x * s, c + z * z * (1 - c),     move[2]};
  for (double e : m) palette->push_back(static_cast<float>(e));
}

Vec apply(const float* m, const float* p) {
  Vec out;
  for (size_t r = 0; r < 3; ++r)
    out[r] = double{m[4 * r]} * p[0] + double{m[4 * r + 1]} * p[1] + double{m[4 * r + 2]} * p[2] + m[4 * r + 3];
  return out;
}

const std::vector<float> kPoints = {0.3f, -1.2f, 0.7f, 2.0f, 0.1f, -0.4f, 0.0f, 0.0f, 0.0f};

TEST(Skinning, OneJointMovesRigidlyBothWays) {
  std::mt19937 random(1);
  const auto uniform = [&] { return static_cast<double>(random()) / 2147483648.0 - 1; };
  for (int i = 0; i < 500; ++i) {
    Palette palette;
    // Half turns and near-identity included: all four branches of the matrix-to-quaternion conversion.
    const double angle = i % 5 == 0 ? 3.141592653589793 : i % 5 == 1 ? 1e-4 : uniform() * 6;
    add_motion(&palette, {uniform(), uniform(), uniform()}, angle, {uniform() * 5, uniform() * 5, uniform() * 5});
    const std::vector<uint16_t> joints(3, 0), weights(3, 65535);
    for (const bool dual : {false, true}) {
      std::vector<float> out(9);
      ASSERT_EQ((dual ? skin_dual_quaternion : skin_linear)(kPoints.data(), 3, joints.data(), weights.data(), 1,
                                                            palette.data(), 1, out.data()),
                SINEW_OK);
      for (size_t v = 0; v < 3; ++v) {
        const Vec want = apply(palette.data(), &kPoints[3 * v]);
        for (size_t a = 0; a < 3; ++a) ASSERT_NEAR(out[3 * v + a], want[a], 5e-6) << (dual ? "dual " : "linear ") << i;
      }
    }
  }
}

TEST(Skinning, LinearBlendsMatrices) {
  Palette palette;
  add_motion(&palette, {0, 0, 1}, 0.5, {1, 0, 0});
  add_motion(&palette, {1, 0, 0}, -0.8, {0, 2, 0});
  const std::vector<uint16_t> joints = {1, 0}, weights = {45535, 20000};
  float out[3];
  ASSERT_EQ(skin_linear(kPoints.data(), 1, joints.data(), weights.data(), 2, palette.data(), 2, out), SINEW_OK);
  const Vec a = apply(&palette[0], kPoints.data()), b = apply(&palette[12], kPoints.data());
  for (size_t c = 0; c < 3; ++c) EXPECT_NEAR(out[c], (a[c] * 20000 + b[c] * 45535) / 65535, 2e-6);
}

TEST(Skinning, DualQuaternionHalfwayIsHalfTheTurn) {
  Palette palette;
  add_motion(&palette, {0, 0, 1}, 0.0, {0, 0, 0});
  add_motion(&palette, {0, 0, 1}, 2.0, {0, 0, 0});
  const std::vector<uint16_t> joints = {0, 1}, weights = {32768, 32767};
  const float point[3] = {1, 0, 0.5f};
  float out[3];
  ASSERT_EQ(skin_dual_quaternion(point, 1, joints.data(), weights.data(), 2, palette.data(), 2, out), SINEW_OK);
  EXPECT_NEAR(out[0], std::cos(1.0), 3e-5);
  EXPECT_NEAR(out[1], std::sin(1.0), 3e-5);
  EXPECT_NEAR(out[2], 0.5, 1e-6);
}

TEST(Skinning, DualQuaternionKeepsVolumeWhereLinearCollapses) {
  // A tube twisted by half a turn about its axis: the middle ring keeps its radius, or falls onto the axis.
  Palette palette;
  add_motion(&palette, {0, 1, 0}, 0.0, {0, 0, 0});
  add_motion(&palette, {0, 1, 0}, 3.1, {0, 0, 0});
  const std::vector<uint16_t> joints = {0, 1}, weights = {32768, 32767};
  for (int i = 0; i < 12; ++i) {
    const float point[3] = {static_cast<float>(std::cos(i * 0.5)), 0.2f, static_cast<float>(std::sin(i * 0.5))};
    float linear[3], dual[3];
    ASSERT_EQ(skin_linear(point, 1, joints.data(), weights.data(), 2, palette.data(), 2, linear), SINEW_OK);
    ASSERT_EQ(skin_dual_quaternion(point, 1, joints.data(), weights.data(), 2, palette.data(), 2, dual), SINEW_OK);
    EXPECT_LT(std::hypot(linear[0], linear[2]), 0.05);
    EXPECT_NEAR(std::hypot(dual[0], dual[2]), 1.0, 1e-5);
    EXPECT_NEAR(dual[1], 0.2, 1e-6);
  }
}

TEST(Skinning, DualQuaternionTakesTheShortWay) {
  // The quaternions of +60 and -110 degrees come out on opposite sides of the sphere; halfway is -25 degrees, not 155.
  constexpr double kDegree = 3.141592653589793 / 180;
  Palette palette;
  add_motion(&palette, {0, 0, 1}, 60 * kDegree, {0, 0, 0});
  add_motion(&palette, {0, 0, 1}, -110 * kDegree, {0, 0, 0});
  const std::vector<uint16_t> joints = {0, 1}, weights = {32768, 32767};
  const float point[3] = {1, 0, 0};
  float out[3];
  ASSERT_EQ(skin_dual_quaternion(point, 1, joints.data(), weights.data(), 2, palette.data(), 2, out), SINEW_OK);
  EXPECT_NEAR(out[0], std::cos(-25 * kDegree), 1e-3);
  EXPECT_NEAR(out[1], std::sin(-25 * kDegree), 1e-3);
}

TEST(Skinning, OutputMayBeTheInput) {
  Palette palette;
  add_motion(&palette, {1, 2, 3}, 1.1, {4, 5, 6});
  const std::vector<uint16_t> joints(3, 0), weights(3, 65535);
  for (const bool dual : {false, true}) {
    const auto skin = dual ? skin_dual_quaternion : skin_linear;
    std::vector<float> apart(9), same = kPoints;
    ASSERT_EQ(skin(kPoints.data(), 3, joints.data(), weights.data(), 1, palette.data(), 1, apart.data()), SINEW_OK);
    ASSERT_EQ(skin(same.data(), 3, joints.data(), weights.data(), 1, palette.data(), 1, same.data()), SINEW_OK);
    EXPECT_EQ(apart, same);
  }
}

TEST(Skinning, UnknownJointIsRefusedBeforeWriting) {
  Palette palette;
  add_motion(&palette, {1, 2, 3}, 1.1, {4, 5, 6});
  const std::vector<uint16_t> joints = {0, 0, 0, 0, 0, 1}, weights = {65535, 0, 65535, 0, 65535, 0};
  for (const bool dual : {false, true}) {
    std::vector<float> out(9, -7.0f);
    EXPECT_EQ((dual ? skin_dual_quaternion : skin_linear)(kPoints.data(), 3, joints.data(), weights.data(), 2,
                                                          palette.data(), 1, out.data()),
              SINEW_ERROR_RANGE);
    EXPECT_EQ(out, std::vector<float>(9, -7.0f));
  }
}

}  // namespace
}  // namespace sinew::deform
