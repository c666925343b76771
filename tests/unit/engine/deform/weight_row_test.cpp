// SPDX-License-Identifier: MIT
// Rows of weights: their distance, and the row that many rows sum to.
#include "deform/weight_row.hpp"

#include <gtest/gtest.h>

#include "sinew/sinew.hpp"

namespace sinew::deform {
namespace {

constexpr WeightRow kAB = {{3, 5}, {40000, 25535}}, kBA = {{5, 3}, {40000, 25535}}, kC = {{9}, {65535}};

TEST(WeightRow, DistanceIsTheSumOverJointsOfWhatDiffers) {
  EXPECT_EQ(row_distance(kAB, kAB), 0u);
  EXPECT_EQ(row_distance(kAB, kBA), 2u * (40000 - 25535));
  EXPECT_EQ(row_distance(kBA, kAB), row_distance(kAB, kBA));
  EXPECT_EQ(row_distance(kAB, kC), 131070u) << "nothing in common";
}

TEST(WeightRow, InfluencesOfAnyOrderShareTheSame) {
  const uint16_t joints[3] = {7, 5, 3}, weights[3] = {0, 30000, 35535};
  EXPECT_EQ(common_weight(kAB, joints, weights, 3), 35535u + 25535u);
}

TEST(RowSum, KeepsTheLargestAndSumsToTheWhole) {
  Workspace memory(4096);
  Arena arena(memory.data(), memory.size());
  RowSum sum;
  ASSERT_TRUE(sum.allocate(arena, 20));
  sum.clear(20);
  for (uint32_t j = 0; j < 12; ++j) sum.add(j, int64_t{1000} * (j + 1));
  const WeightRow row = sum.take();
  uint32_t whole = 0;
  for (uint32_t s = 0; s < kNodeSlots; ++s) {
    EXPECT_EQ(row.joints[s], 11 - s) << "by falling weight";
    whole += row.weights[s];
  }
  EXPECT_EQ(whole, 65535u);
  EXPECT_TRUE(sum.take().empty()) << "taken is gone";
  sum.add(kAB, 2);
  sum.add(kBA, 1);
  EXPECT_EQ(sum.take().joints[0], 3) << "factors count";
}

}  // namespace
}  // namespace sinew::deform
