// SPDX-License-Identifier: MIT
// The cheapest alignment of two lists: nothing crosses, and no other one is cheaper.
#include "mapping/align.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "sinew/sinew.hpp"

namespace sinew::mapping {
namespace {

using Costs = std::vector<std::vector<double>>;

double cheapest(const Costs& costs, double skip, size_t i, size_t j) {
  if (i == costs.size()) return skip * static_cast<double>(costs[0].size() - j);
  if (j == costs[0].size()) return skip * static_cast<double>(costs.size() - i);
  return std::min({costs[i][j] + cheapest(costs, skip, i + 1, j + 1), skip + cheapest(costs, skip, i + 1, j),
                   skip + cheapest(costs, skip, i, j + 1)});
}

TEST(Aligner, IsAsCheapAsTheBestOfAllAndKeepsTheOrder) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(0, 2);
  for (int round = 0; round < 50; ++round) {
    const auto rows = static_cast<uint32_t>(1 + random() % 5), columns = static_cast<uint32_t>(1 + random() % 5);
    Costs costs(rows, std::vector<double>(columns));
    for (auto& row : costs)
      for (double& c : row) c = uniform(random);
    Workspace memory(4096);
    Arena arena(memory.data(), memory.size());
    Aligner aligner;
    ASSERT_TRUE(aligner.allocate(arena, rows, columns));
    const double skip = 0.6;
    const double total =
        aligner.run(static_cast<int32_t>(rows), static_cast<int32_t>(columns), skip,
                    [&](int32_t i, int32_t j) { return costs[static_cast<size_t>(i)][static_cast<size_t>(j)]; });
    EXPECT_NEAR(total, cheapest(costs, skip, 0, 0), 1e-12);
    double again = 0;
    int32_t before = -1;
    uint32_t matched = 0;
    for (uint32_t i = 0; i < rows; ++i) {
      const int32_t j = aligner.match[i];
      if (j < 0) continue;
      EXPECT_GT(j, before);
      before = j;
      ++matched;
      again += costs[i][static_cast<size_t>(j)];
    }
    EXPECT_NEAR(again + skip * (rows + columns - 2 * matched), total, 1e-12) << "the matches are what the cost is of";
  }
}

}  // namespace
}  // namespace sinew::mapping
