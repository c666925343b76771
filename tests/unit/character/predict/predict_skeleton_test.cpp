// SPDX-License-Identifier: MIT
// How likely a predicted skeleton can be used.
#include "sinew_character/predict/predict_skeleton.hpp"

#include <gtest/gtest.h>

namespace sinew {
namespace {

TEST(UsableProbability, FallsWithTheSpreadAndWithoutAMirrorPlane) {
  float before = 1;
  for (const float spread : {0.0f, 0.02f, 0.04f, 0.06f, 0.08f, 0.12f, 1.0f}) {
    const float mirrored = usable_probability(spread, true), other = usable_probability(spread, false);
    EXPECT_LE(mirrored, before) << spread;
    EXPECT_LE(other, mirrored) << spread;
    EXPECT_GE(other, 0);
    before = mirrored;
  }
  EXPECT_GT(usable_probability(0.03f, false), 0.9f) << "people are usable in any pose";
  EXPECT_LT(usable_probability(0.09f, true), kDoubtfulUsable) << "a mesh unlike all is told";
}

}  // namespace
}  // namespace sinew
