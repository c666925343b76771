// SPDX-License-Identifier: MIT
// Products, inverses and shortest arcs of unit quaternions.
#include "motion/quaternion.hpp"

#include <gtest/gtest.h>

#include <random>

namespace sinew::motion {
namespace {

class Draw {
 public:
  Vec3d vector() { return {uniform_(random_), uniform_(random_), uniform_(random_)}; }
  Quat rotation() { return normalized({uniform_(random_), uniform_(random_), uniform_(random_), uniform_(random_)}); }

 private:
  std::mt19937 random_{7};
  std::uniform_real_distribution<double> uniform_{-1, 1};
};

TEST(Quat, AProductIsTheRightOneFirstAndAConjugateTheWayBack) {
  Draw draw;
  for (int i = 0; i < 200; ++i) {
    const Quat a = draw.rotation(), b = draw.rotation();
    const Vec3d p = draw.vector();
    EXPECT_LT(length(rotate(a * b, p) - rotate(a, rotate(b, p))), 1e-12);
    EXPECT_LT(length(rotate(conjugate(a), rotate(a, p)) - p), 1e-12);
  }
  const Quat quarter = normalized({0, 0, 1, 1});  // about z: x becomes y
  EXPECT_LT(length(rotate(quarter, {1, 0, 0}) - Vec3d{0, 1, 0}), 1e-15);
}

TEST(Quat, TheShortestArcTakesOneDirectionToTheOther) {
  Draw draw;
  for (int i = 0; i < 200; ++i) {
    const Vec3d from = draw.vector(), to = 3.0 * draw.vector();
    const Quat arc = shortest_arc(from, to);
    EXPECT_LT(length(unit(rotate(arc, from)) - unit(to)), 1e-9);
    EXPECT_LT(length(rotate(arc, unit(cross(from, to))) - unit(cross(from, to))), 1e-9) << "about what is across both";
  }
  EXPECT_LT(length(rotate(shortest_arc({1, 0, 0}, {-2, 0, 0}), {1, 0, 0}) - Vec3d{-1, 0, 0}), 1e-12) << "half a turn";
}

TEST(Quat, NothingHasNoRotation) {
  EXPECT_EQ(normalized({0, 0, 0, 0}).w, 1);
  EXPECT_EQ(shortest_arc({0, 0, 0}, {1, 0, 0}).w, 1);
}

}  // namespace
}  // namespace sinew::motion
