// SPDX-License-Identifier: MIT
// Functions of doubles without libm: close to libm's, and exact where a user would expect it.
#include "mapping/maths.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace sinew::mapping {
namespace {

TEST(MappingMaths, LogarithmIsThatOfLibm) {
  EXPECT_EQ(logarithm(1), 0);
  for (double a = 1e-12; a < 1e12; a *= 1.013)
    EXPECT_NEAR(logarithm(a), std::log(a), 1e-14 + 1e-15 * std::fabs(std::log(a))) << a;
  EXPECT_LT(logarithm(0), -600);  // no infinity, no NaN
}

TEST(MappingMaths, TangentIsThatOfLibmAndOdd) {
  for (double a = -45; a < 45; a += 0.0137) {
    EXPECT_NEAR(hyperbolic_tangent(a), std::tanh(a), 4e-16) << a;
    EXPECT_EQ(hyperbolic_tangent(-a), -hyperbolic_tangent(a)) << a;
  }
  EXPECT_EQ(hyperbolic_tangent(1e300), 1);
}

TEST(MappingMaths, RoundedIsToTheNearestOfBothSigns) {
  EXPECT_EQ(rounded(1.4e-9), 1);
  EXPECT_EQ(rounded(1.6e-9), 2);
  EXPECT_EQ(rounded(-1.6e-9), -2);
}

}  // namespace
}  // namespace sinew::mapping
