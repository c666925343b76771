// SPDX-License-Identifier: MIT
// keep_largest against its definition: exact sums, order, ties, nothing lost.
#include "weights/influences.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <vector>

#include "core/counts.hpp"
#include "random.hpp"

namespace sinew {
namespace {

using test::Random;

struct Row {
  std::vector<uint16_t> joints, weights;
};
Row keep(const std::vector<uint16_t>& joints, const std::vector<uint32_t>& weights, uint32_t count, uint32_t total) {
  Row row{std::vector<uint16_t>(count, 77), std::vector<uint16_t>(count, 77)};
  keep_largest(joints.data(), weights.data(), static_cast<uint32_t>(joints.size()), count, total, row.joints.data(),
               row.weights.data());
  return row;
}

// The definition, written with a sort.
Row keep_by_sorting(const std::vector<uint16_t>& joints, const std::vector<uint32_t>& weights, uint32_t count,
                    uint32_t total) {
  std::vector<std::pair<int64_t, uint16_t>> order;  // (-weight, joint)
  for (size_t i = 0; i < joints.size(); ++i) {
    if (weights[i] > 0 && joints[i] != kNoJoint) order.emplace_back(-static_cast<int64_t>(weights[i]), joints[i]);
  }
  std::sort(order.begin(), order.end());
  if (order.size() > count) order.resize(count);
  int64_t sum = 0, given = 0;
  for (const auto& entry : order) sum -= entry.first;
  for (auto& entry : order) {
    entry.first = -(-entry.first * total / sum);
    given -= entry.first;
  }
  order[0].first -= total - given;
  std::sort(order.begin(), order.end());
  Row row{std::vector<uint16_t>(count, 0), std::vector<uint16_t>(count, 0)};
  for (size_t i = 0; i < order.size(); ++i) {
    if (order[i].first == 0) continue;
    row.joints[i] = order[i].second;
    row.weights[i] = static_cast<uint16_t>(-order[i].first);
  }
  return row;
}

TEST(KeepLargest, RandomRowsEqualTheDefinition) {
  Random random(2);
  for (int i = 0; i < 30000; ++i) {
    const uint32_t count = 1 + random.below(16), kept = 1 + random.below(12), total = random.below(2) ? 65535 : 255;
    std::vector<uint16_t> joints(count);
    std::iota(joints.begin(), joints.end(), static_cast<uint16_t>(random.below(3000)));
    std::shuffle(joints.begin(), joints.end(), random.engine());
    std::vector<uint32_t> weights;
    const uint32_t scale = 1u << (random.below(21));  // small scales give ties and zeros
    for (uint32_t k = 0; k < count; ++k) weights.push_back(random.below(scale + 1));
    weights[random.below(count)] = scale;
    for (uint32_t k = 0; k < count; ++k) {
      if (weights[k] == 0 && random.below(2)) joints[k] = kNoJoint;
    }
    const Row row = keep(joints, weights, kept, total), want = keep_by_sorting(joints, weights, kept, total);
    ASSERT_EQ(row.joints, want.joints);
    ASSERT_EQ(row.weights, want.weights);
    ASSERT_EQ(std::accumulate(row.weights.begin(), row.weights.end(), 0u), total);
  }
}

TEST(Prune, DropsUnderOnePercentOnly) {
  uint32_t probabilities[] = {60000, 654, 655, 0, 4227};
  prune_q16(probabilities, 5);
  EXPECT_EQ(std::vector<uint32_t>(probabilities, probabilities + 5), (std::vector<uint32_t>{60000, 0, 655, 0, 4227}));
}

TEST(KeepLargest, TiesGoToTheLowerJoint) {
  const Row row = keep({9, 3, 7, 5}, {10, 10, 10, 10}, 3, 255);
  EXPECT_EQ(row.joints, (std::vector<uint16_t>{3, 5, 7}));
  EXPECT_EQ(row.weights, (std::vector<uint16_t>{85, 85, 85}));
}

TEST(KeepLargest, RemainderGoesToTheLargest) {
  EXPECT_EQ(keep({9, 3, 7}, {2, 1, 1}, 3, 255).weights, (std::vector<uint16_t>{129, 63, 63}));
  EXPECT_EQ(keep({0, 1, 2}, {1, 1, 1}, 3, 65535).weights, (std::vector<uint16_t>{21845, 21845, 21845}));
  EXPECT_EQ(keep({0, 1}, {1, 1}, 2, 255).weights, (std::vector<uint16_t>{128, 127}));
}

TEST(KeepLargest, EqualAfterRoundingIsInJointOrder) {
  const Row row = keep({1, 8, 4}, {60000, 1001, 1000}, 3, 255);
  EXPECT_EQ(row.joints, (std::vector<uint16_t>{1, 4, 8}));
  EXPECT_EQ(row.weights[1], row.weights[2]);
}

TEST(KeepLargest, WhatRoundsToZeroIsDropped) {
  const Row row = keep({5, 6, 7}, {1u << 20, 1, 0}, 3, 255);
  EXPECT_EQ(row.joints, (std::vector<uint16_t>{5, 0, 0}));
  EXPECT_EQ(row.weights, (std::vector<uint16_t>{255, 0, 0}));
}

}  // namespace
}  // namespace sinew
