// SPDX-License-Identifier: MIT
// Assignments against all there are, and alignments of two lists.
#include "mapping/assignment.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <vector>

#include "arena_block.hpp"
#include "mapping/align.hpp"

namespace sinew::mapping {
namespace {

// Every way to give each row a column of its own or none.
double cheapest(const std::vector<double>& cost, int rows, int columns, double alone) {
  std::vector<int> permutation(static_cast<size_t>(columns + rows));
  std::iota(permutation.begin(), permutation.end(), 0);
  double best = 1e300;
  do {
    double sum = alone * (rows + columns);
    for (int i = 0; i < rows; ++i) {
      if (permutation[static_cast<size_t>(i)] < columns)
        sum += cost[static_cast<size_t>(i * columns + permutation[static_cast<size_t>(i)])] - 2 * alone;
    }
    best = std::min(best, sum);
  } while (std::next_permutation(permutation.begin(), permutation.end()));
  return best;
}

TEST(MappingAssignment, IsTheCheapestOfAll) {
  std::mt19937 random(5);
  for (int round = 0; round < 400; ++round) {
    const int rows = static_cast<int>(random() % 4), columns = static_cast<int>(random() % 5);
    const double alone = 0.1 * static_cast<double>(random() % 12);
    std::vector<double> cost(static_cast<size_t>(rows * columns));
    for (double& c : cost) c = 0.01 * static_cast<double>(random() % 300) - 0.5;
    alignas(64) static uint8_t memory[16384];
    Arena arena(memory, sizeof memory);
    Assignment assignment;
    ASSERT_TRUE(assignment.allocate(arena, 4, 5));
    assignment.rows = rows;
    assignment.columns = columns;
    std::copy(cost.begin(), cost.end(), assignment.cost);
    assignment.solve(alone);
    double sum = alone * (rows + columns);
    std::vector<int> used(5, 0);
    for (int i = 0; i < rows; ++i) {
      const int j = assignment.match[i];
      if (j < 0) continue;
      ASSERT_LT(j, columns);
      EXPECT_EQ(used[static_cast<size_t>(j)]++, 0);
      sum += cost[static_cast<size_t>(i * columns + j)] - 2 * alone;
    }
    EXPECT_NEAR(sum, cheapest(cost, rows, columns, alone), 1e-12) << rows << " x " << columns;
  }
}

TEST(MappingAligner, KeepsTheOrderAndSkipsWhatIsDear) {
  alignas(64) static uint8_t memory[4096];
  Arena arena(memory, sizeof memory);
  Aligner aligner;
  ASSERT_TRUE(aligner.allocate(arena, 4, 5));
  const double a[4] = {0, 1, 2, 3}, b[5] = {0.1, 0.2, 1.9, 3, 9};
  const auto cost = [&](int32_t i, int32_t j) { return a[i] < b[j] ? b[j] - a[i] : a[i] - b[j]; };
  EXPECT_NEAR(aligner.run(4, 5, 0.3, cost), 0.1 + 0.3 + 0.3 + 0.1 + 0 + 0.3, 1e-12);
  EXPECT_EQ(aligner.match[0], 0);
  EXPECT_EQ(aligner.match[1], -1);
  EXPECT_EQ(aligner.match[2], 2);
  EXPECT_EQ(aligner.match[3], 3);
  (void)aligner.run(4, 5, 50, cost);  // every joint of the shorter list gets one
  for (int i = 0; i < 4; ++i) EXPECT_GE(aligner.match[i], 0);
  for (int i = 1; i < 4; ++i) EXPECT_GT(aligner.match[i], aligner.match[i - 1]);
}

}  // namespace
}  // namespace sinew::mapping
