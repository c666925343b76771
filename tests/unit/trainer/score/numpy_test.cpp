// SPDX-License-Identifier: MIT
// numpy's draws, written down from numpy 1.24.2: any slip in seeding, PCG64 or the ziggurat changes every pose. The cheapest pairs
// against all that there are.
#include "score/numpy.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace sinew {
namespace {

TEST(NumpyRandom, FirstWordsOfThreeSeeds) {
  EXPECT_EQ(NumpyRandom(0).next_uint64(), 0xa30febcfd9c2825fu);
  EXPECT_EQ(NumpyRandom(1).next_uint64(), 0x8306bdf37922e4ffu);
  EXPECT_EQ(NumpyRandom(12345).next_uint64(), 0x3a32b18db2ffc19du);
}

TEST(NumpyRandom, UniformsAreTheSameBits) {
  NumpyRandom zero(0), one(1), many(12345);
  for (double expected : {0x1.187f5e7ece140p-2, -0x1.d77a103be9318p-2, -0x1.d60b095ac4c86p-1})
    EXPECT_EQ(zero.uniform(-1, 1), expected);
  for (double expected : {0x1.835ef9bc91700p-6, 0x1.cd465aef054aap-1, -0x1.6c616c27dc4fap-1})
    EXPECT_EQ(one.uniform(-1, 1), expected);
  for (double expected : {-0x1.173539c934010p-1, -0x1.77476751b0da0p-2, 0x1.30809208d113ap-1})
    EXPECT_EQ(many.uniform(-1, 1), expected);
}

// Draws before an index, then the value there: |x| > 3.654 comes from the tail, where numpy takes the sign from another
// bit.
struct Draw {
  uint64_t seed;
  int index;
  double value;
};

TEST(NumpyRandom, NormalsOfLayersAndOfTheTail) {
  for (const Draw& draw :
       {Draw{0, 0, 0x1.017ed89db8441p-3}, Draw{0, 1, -0x1.0e8cfe9bd45ccp-3}, Draw{0, 2, 0x1.47e57a468b06dp-1},
        Draw{0, 303, -0x1.e2d9e98d87bc6p+1}, Draw{0, 478, -0x1.f3204051f2938p+1}, Draw{1, 0, 0x1.61e0d28bbb3a1p-2},
        Draw{1, 3, -0x1.4d9bb65b49607p+0}, Draw{1, 860, 0x1.e035931978327p+1}, Draw{1, 3284, 0x1.dbdba47b03290p+1},
        Draw{12345, 0, -0x1.6c7fcc2ecc744p+0}, Draw{12345, 3, -0x1.0964b5602ac3cp-2},
        Draw{12345, 1846, 0x1.dc4ceede8c71ap+1}, Draw{12345, 4644, 0x1.f3753b3a118a6p+1}}) {
    NumpyRandom random(draw.seed);
    for (int i = 0; i < draw.index; ++i) random.normal();
    EXPECT_NEAR(random.normal(), draw.value, 1e-14) << "seed " << draw.seed << " draw " << draw.index;
  }
}

TEST(NumpyRandom, AMillionNormalsHaveTheRightMoments) {
  NumpyRandom random(7);
  double sum = 0, squares = 0, fourths = 0;
  constexpr int count = 1000000;
  for (int i = 0; i < count; ++i) {
    const double x = random.normal();
    sum += x;
    squares += x * x;
    fourths += x * x * x * x;
  }
  EXPECT_NEAR(sum / count, 0, 0.005);
  EXPECT_NEAR(squares / count, 1, 0.01);
  EXPECT_NEAR(fourths / count, 3, 0.06);
}

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
