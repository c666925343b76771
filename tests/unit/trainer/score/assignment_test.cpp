// SPDX-License-Identifier: MIT
// The cheapest pairs against all that there are.
#include "score/assignment.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

namespace sinew {
namespace {

double sum_of(const std::vector<double>& cost, size_t columns, const std::vector<int>& pairs) {
  double sum = 0;
  for (size_t row = 0; row < pairs.size(); ++row)
    if (pairs[row] >= 0) sum += cost[row * columns + static_cast<size_t>(pairs[row])];
  return sum;
}

// Tries every order of the longer side.
double least_sum(const std::vector<double>& cost, size_t rows, size_t columns) {
  const size_t most = std::max(rows, columns), least = std::min(rows, columns);
  std::vector<size_t> order(most);
  std::iota(order.begin(), order.end(), 0);
  double best = 1e300;
  do {
    double sum = 0;
    for (size_t k = 0; k < least; ++k)
      sum += rows <= columns ? cost[k * columns + order[k]] : cost[order[k] * columns + k];
    best = std::min(best, sum);
  } while (std::next_permutation(order.begin(), order.end()));
  return best;
}

TEST(CheapestPairs, AreAsCheapAsCanBe) {
  std::mt19937 random(7);
  for (int trial = 0; trial < 600; ++trial) {
    const size_t rows = 1 + random() % 7, columns = 1 + random() % 7;
    std::vector<double> cost(rows * columns);
    // Few different costs, so that many pairings are equally cheap, and some as a joint too far away has.
    const unsigned long steps = trial % 2 == 0 ? 4 : 1000;
    for (double& one : cost)
      one = random() % 3 == 0 ? 10 : static_cast<double>(random() % steps) / static_cast<double>(steps);
    const std::vector<int> pairs = cheapest_pairs(cost, rows, columns);
    ASSERT_EQ(pairs.size(), rows);
    std::vector<int> used;
    for (const int column : pairs)
      if (column >= 0) used.push_back(column);
    EXPECT_EQ(used.size(), std::min(rows, columns));
    std::sort(used.begin(), used.end());
    EXPECT_EQ(std::unique(used.begin(), used.end()), used.end()) << "a column twice";
    EXPECT_NEAR(sum_of(cost, columns, pairs), least_sum(cost, rows, columns), 1e-9);
  }
}

TEST(CheapestPairs, SettleTiesInOrder) {
  EXPECT_EQ(cheapest_pairs(std::vector<double>(9, 1), 3, 3), (std::vector<int>{0, 1, 2}));
  EXPECT_EQ(cheapest_pairs(std::vector<double>(6, 1), 2, 3), (std::vector<int>{0, 1}));
  EXPECT_EQ(cheapest_pairs(std::vector<double>(6, 1), 3, 2), (std::vector<int>{0, 1, -1}));
  EXPECT_EQ(cheapest_pairs({}, 2, 0), (std::vector<int>{-1, -1}));
  EXPECT_TRUE(cheapest_pairs({}, 0, 2).empty());
}

}  // namespace
}  // namespace sinew
