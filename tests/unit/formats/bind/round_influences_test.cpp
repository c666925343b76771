// SPDX-License-Identifier: MIT
// Rows cut and rounded as the engine does it: exact sums, falling weights, nothing from nothing.
#include <gtest/gtest.h>

#include <cmath>

#include "sinew_formats/bind.hpp"

namespace sinew {
namespace {

int units(const Influence& influence) { return static_cast<int>(std::lround(influence.weight * 65535.0f)); }

TEST(RoundInfluences, KeepsTheLargestWithAnExactSum) {
  const std::vector<Influence> rounded = round_influences({{7, 0.1f}, {3, 0.3f}, {9, 0.05f}, {1, 0.3f}}, 3);
  ASSERT_EQ(rounded.size(), 3u);
  EXPECT_EQ(rounded[0].joint, 1u);  // ties by the lower joint
  EXPECT_EQ(rounded[1].joint, 3u);
  EXPECT_EQ(rounded[2].joint, 7u);
  EXPECT_EQ(units(rounded[0]) + units(rounded[1]) + units(rounded[2]), 65535);
  EXPECT_NEAR(units(rounded[2]), 65535 / 7, 1);
}

TEST(RoundInfluences, OneJointGetsEverything) {
  const std::vector<Influence> rounded = round_influences({{4, 0.02f}}, 4);
  ASSERT_EQ(rounded.size(), 1u);
  EXPECT_EQ(rounded[0].joint, 4u);
  EXPECT_EQ(rounded[0].weight, 1.0f);
}

TEST(RoundInfluences, NothingFromNothing) {
  EXPECT_TRUE(round_influences({}, 4).empty());
  EXPECT_TRUE(round_influences({{2, 0.0f}}, 4).empty());
}

}  // namespace
}  // namespace sinew
