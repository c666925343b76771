// SPDX-License-Identifier: MIT
// Roots and lengths without libm: close to libm's, and nothing for what has none.
#include "core/vec3d.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace sinew {
namespace {

TEST(Vec3d, RootIsThatOfLibm) {
  EXPECT_EQ(root(0), 0);
  EXPECT_EQ(root(-1), 0);
  EXPECT_EQ(root(1), 1);
  for (double a = 1e-150; a < 1e150; a *= 1.37) EXPECT_NEAR(root(a) / std::sqrt(a), 1, 5e-16) << a;
}

TEST(Vec3d, AUnitHasTheLengthOneOrNone) {
  EXPECT_NEAR(length(unit({3, -4, 12})), 1, 3e-16);
  EXPECT_NEAR(length({3, -4, 12}), 13, 1e-14);
  EXPECT_EQ(length(unit({0, 0, 0})), 0);
  EXPECT_EQ(length(unit({1e-150, 0, 0})), 0) << "its square is below what has a root";
}

TEST(Vec3d, ScalarsKeepTheirOrder) {
  EXPECT_EQ(absolute(-2.5), 2.5);
  EXPECT_EQ(lesser(1, -1), -1);
  EXPECT_EQ(greater(1, -1), 1);
  EXPECT_EQ(clamped(5, 0, 1), 1);
  EXPECT_EQ(clamped(-5, 0, 1), 0);
  EXPECT_EQ(clamped(0.5, 0, 1), 0.5);
}

}  // namespace
}  // namespace sinew
