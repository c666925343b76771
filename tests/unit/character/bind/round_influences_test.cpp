// SPDX-License-Identifier: MIT
// Rows cut and rounded as the engine does it: exact sums, falling weights, nothing from nothing.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "sinew_character/bind/bind.hpp"

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

// Weights of a bind that a file gave back stay as they are, whatever is locked.
TEST(RoundInfluences, ExactRowsStayAsTheyAre) {
  std::mt19937 random(1);
  for (int round = 0; round < 2000; ++round) {
    std::vector<int> cuts = {0, 65535};
    for (int i = 0; i < 3; ++i) cuts.push_back(static_cast<int>(random() % 65536));
    std::sort(cuts.begin(), cuts.end());
    std::vector<int> expected(5, 0);
    std::vector<Influence> row;
    for (size_t i = 0; i < 4; ++i) {
      expected[i] = cuts[i + 1] - cuts[i];
      row.push_back({static_cast<uint32_t>(i), static_cast<float>(expected[i]) / 65535.0f});
    }
    for (const Influence& influence : round_influences(row, 4))
      ASSERT_EQ(units(influence), expected[influence.joint]) << "row " << round << ", joint " << influence.joint;
  }
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
