// SPDX-License-Identifier: MIT
// Boxes along the main axes of points, and whether two of them touch.
#include "published/oriented_box.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using sinew::rigging::OrientedBox;
using Point = sinew::Vec3d;

// A grid of points that fills a box of 4 x 2 x 1 around `at`, turned about z and then about x.
OrientedBox box(Point at, double z, double x) {
  OrientedBox made;
  for (const bool holds : {false, true}) {
    if (holds) made.turn();
    for (int i = -4; i <= 4; ++i) {
      for (int j = -2; j <= 2; ++j) {
        for (int k = -1; k <= 1; ++k) {
          const double p[3] = {i * 0.5, j * 0.5, k * 0.5};
          const double q[3] = {std::cos(z) * p[0] - std::sin(z) * p[1], std::sin(z) * p[0] + std::cos(z) * p[1], p[2]};
          const Point point = {at.x + q[0], at.y + std::cos(x) * q[1] - std::sin(x) * q[2],
                               at.z + std::sin(x) * q[1] + std::cos(x) * q[2]};
          holds ? made.hold(point) : made.add(point);
        }
      }
    }
  }
  return made;
}

TEST(OrientedBox, TheMiddleIsTheMiddleWhateverTheTurn) {
  for (const double angle : {0.0, 0.3, 0.8, 1.6, 3.0}) {
    const Point m = box({7, -3, 100}, angle, 2 * angle).middle();
    EXPECT_NEAR(m.x, 7, 1e-9);
    EXPECT_NEAR(m.y, -3, 1e-9);
    EXPECT_NEAR(m.z, 100, 1e-9);
  }
}

TEST(OrientedBox, TouchesAlongItsOwnAxes) {
  const OrientedBox a = box({0, 0, 0}, 0, 0);
  EXPECT_TRUE(a.overlaps(box({3.9, 0, 0}, 0, 0), 0));
  EXPECT_FALSE(a.overlaps(box({4.1, 0, 0}, 0, 0), 0));
  EXPECT_TRUE(a.overlaps(box({4.1, 0, 0}, 0, 0), 0.2));
  EXPECT_FALSE(a.overlaps(box({0, 0, 1.1}, 0, 0), 0));
  // Turned by 45 degrees their boxes along x, y and z overlap, they do not.
  const double quarter = std::acos(-1.0) / 4;
  EXPECT_FALSE(box({0, 0, 0}, quarter, 0).overlaps(box({1.6, -1.6, 0}, quarter, 0), 0));
  EXPECT_TRUE(box({0, 0, 0}, quarter, 0).overlaps(box({0.6, -0.6, 0}, quarter, 0), 0));
  // Corner against side: 2 and 1.06 reach each other.
  EXPECT_TRUE(box({0, 0, 0}, 0, quarter).overlaps(box({0, 3.05, 0}, 2 * quarter, 0), 0));
  EXPECT_FALSE(box({0, 0, 0}, 0, quarter).overlaps(box({0, 3.07, 0}, 2 * quarter, 0), 0));
}

TEST(OrientedBox, APointAndALineAreBoxesToo) {
  OrientedBox point, line;
  point.add({1, 1, 1});
  point.turn();
  point.hold({1, 1, 1});
  for (const double t : {0.0, 1.0, 2.0}) line.add({t, t, t});
  line.turn();
  for (const double t : {0.0, 1.0, 2.0}) line.hold({t, t, t});
  EXPECT_TRUE(point.overlaps(line, 1e-9));
  EXPECT_NEAR(line.middle().x, 1, 1e-9);
}

}  // namespace
