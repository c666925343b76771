// SPDX-License-Identifier: MIT
// Rigid motions as dual quaternions: of matrices, one after another, and blended.
#include "deform/dual_quaternion.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace sinew::deform {
namespace {

// About z by an angle, row-major 3x4.
void about_z(double angle, double (&m)[12]) {
  const double c = std::cos(angle), s = std::sin(angle);
  const double values[12] = {c, -s, 0, 0, s, c, 0, 0, 0, 0, 1, 0};
  for (int i = 0; i < 12; ++i) m[i] = values[i];
}

TEST(DualQuaternion, MovesAsItsMatrixDoes) {
  for (const double angle : {0.0, 0.7, 3.1, -2.9, 3.141592653589793}) {
    double m[12];
    about_z(angle, m);
    const DualQuaternion q = motion(rotation_quaternion(m), {1, 2, 3});
    const Vec3d p = {0.4, -0.3, 0.2};
    const Vec3d want = {m[0] * p.x + m[1] * p.y + 1, m[4] * p.x + m[5] * p.y + 2, p.z + 3};
    EXPECT_LT(length(move(q, p) - want), 1e-12) << angle;
  }
}

TEST(DualQuaternion, AProductIsTheRightOneFirst) {
  double m[12];
  about_z(0.5, m);
  const DualQuaternion turn = motion(rotation_quaternion(m), {0, 0, 0}), shift = motion({1, 0, 0, 0}, {1, 0, 0});
  const Vec3d p = {0.1, 0.2, 0.3};
  EXPECT_LT(length(move(turn * shift, p) - move(turn, move(shift, p))), 1e-12);
}

TEST(DualQuaternion, HalfOfEachIsTheMotionBetweenAndTheIdentityIsExact) {
  double m[12];
  about_z(1.0, m);
  DualQuaternion sum = {{0, 0, 0, 0}, {0, 0, 0, 0}};
  const DualQuaternion rest = motion({1, 0, 0, 0}, {0, 0, 0});
  add_scaled(&sum, 0.5, rest);
  add_scaled(&sum, 0.5, motion(rotation_quaternion(m), {0, 0, 0}));
  EXPECT_LT(length(move(sum, {1, 0, 0}) - Vec3d{std::cos(0.5), std::sin(0.5), 0}), 1e-12);
  DualQuaternion still = {{0, 0, 0, 0}, {0, 0, 0, 0}};
  for (const double share : {0.3, 0.7}) add_scaled(&still, share, rest);
  const Vec3d p = {0.1, 0.7, -0.3}, moved = move(still, p);
  EXPECT_TRUE(moved.x == p.x && moved.y == p.y && moved.z == p.z);
}

}  // namespace
}  // namespace sinew::deform
