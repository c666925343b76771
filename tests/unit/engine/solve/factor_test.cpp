// SPDX-License-Identifier: MIT
// The sparse factor in 64-bit fixed point: its division, and a known solution.
#include "solve/factor.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "sparse_part.hpp"

namespace {

using namespace sinew;
using sinew_test::Block;
using sinew_test::SparsePart;

TEST(Factor, ReciprocalsAndQuotients) {
  for (const int64_t d :
       {int64_t{1}, int64_t{2}, int64_t{3}, int64_t{1000003}, (int64_t{1} << 50) + 12345, (int64_t{1} << 58) - 1}) {
    for (const int64_t sign : {1, -1}) {
      const Reciprocal r = reciprocal(sign * d);
      for (const int64_t n : {int64_t{0}, int64_t{1}, int64_t{-7}, d / 3, -d, 5 * d}) {
        const double exact = static_cast<double>(n) / static_cast<double>(sign * d) * std::pow(2.0, 24);
        EXPECT_NEAR(static_cast<double>(divide(n, r, 24, 20)), exact, 1.0 + std::fabs(exact) * 1e-12)
            << n << " / " << sign * d;
      }
    }
  }
  EXPECT_EQ(divide(int64_t{1} << 60, reciprocal(1), 24, 7), int64_t{1} << 31);
  EXPECT_EQ(divide(int64_t{1} << 60, reciprocal(-1), 24, 7), -(int64_t{1} << 31));
}

TEST(Factor, SolvesForAKnownSolution) {
  SparsePart c(sinew_test::star(40, 50, 2));
  Arena measure;
  Factor().allocate(measure, c.run.counts);
  Block block(measure.high_water());
  Factor factor;
  ASSERT_TRUE(factor.allocate(block.arena, c.run.counts));
  const std::vector<int64_t> pulls = c.pulls(), rhs = c.right_hand_side(pulls);
  ASSERT_TRUE(factor.analyze(c.matrix));
  c.matrix.assemble(pulls.data(), kFactorDiagonalBits);
  factor.factorise(c.matrix);
  const size_t entries = size_t{c.matrix.rows} * kBatch;
  std::vector<int64_t> batch(entries, 0);
  for (uint32_t k = 0; k < c.matrix.rows; ++k) batch[size_t{k} * kBatch + 5] = c.matrix.to_matrix(rhs[k]);
  std::vector<int32_t> x(entries, 1), change(entries);
  factor.solve(c.matrix.rows, batch.data(), x.data());
  EXPECT_LT(c.worst_error(x, 5), 1e-5);
  for (size_t i = 0; i < entries; ++i) ASSERT_TRUE(i % kBatch == 5 || x[i] == 0);
  // What is left of the right-hand sides asks for next to nothing more.
  for (size_t i = 0; i < entries; ++i) batch[i] = i % kBatch == 5 ? c.matrix.to_matrix(rhs[i / kBatch]) : 0;
  c.matrix.subtract_image(x.data(), batch.data());
  factor.solve(c.matrix.rows, batch.data(), change.data());
  for (size_t i = 0; i < entries; ++i) ASSERT_LT(std::abs(change[i]), 1 << (kSolutionBits - 16));
}

}  // namespace
