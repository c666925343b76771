// SPDX-License-Identifier: MIT
// The nearest point of a triangle: nothing else of it is nearer, in all seven regions and for flat triangles.
#include <gtest/gtest.h>

#include <random>

#include "core/triangle.hpp"

namespace sinew {
namespace {

Vec3d point_at(const Vec3d (&corners)[3], const double* shares) {
  return shares[0] * corners[0] + shares[1] * corners[1] + shares[2] * corners[2];
}

void expect_nearest(Vec3d p, const Vec3d (&corners)[3]) {
  double shares[3];
  nearest_on_triangle(p, corners[0], corners[1], corners[2], shares);
  for (const double share : shares) {
    EXPECT_GE(share, -1e-12);
    EXPECT_LE(share, 1 + 1e-12);
  }
  EXPECT_NEAR(shares[0] + shares[1] + shares[2], 1, 1e-12);
  const double found = length(p - point_at(corners, shares));
  constexpr int kSteps = 24;
  for (int i = 0; i <= kSteps; ++i) {
    for (int k = 0; i + k <= kSteps; ++k) {
      const double other[3] = {1.0 - (i + k) / static_cast<double>(kSteps), i / static_cast<double>(kSteps),
                               k / static_cast<double>(kSteps)};
      ASSERT_LE(found, length(p - point_at(corners, other)) + 1e-9);
    }
  }
}

TEST(TrianglePoint, IsTheNearest) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> draw(-1, 1);
  const auto point = [&] { return Vec3d{draw(random), draw(random), draw(random)}; };
  for (int i = 0; i < 300; ++i) expect_nearest(2.0 * point(), {point(), point(), point()});
}

TEST(TrianglePoint, FlatTrianglesHaveOneAsWell) {
  const Vec3d a = {0, 0, 0}, b = {1, 0, 0};
  expect_nearest({0.3, 1, 0}, {a, a, a});
  expect_nearest({0.3, 1, 0}, {a, b, a});
  expect_nearest({2, 1, 0}, {a, b, {0.5, 0, 0}});
}

}  // namespace
}  // namespace sinew
