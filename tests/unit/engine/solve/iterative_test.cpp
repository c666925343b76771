// SPDX-License-Identifier: MIT
// Conjugate gradients: a known solution.
#include "solve/iterative.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "sparse_part.hpp"

namespace {

using namespace sinew;
using sinew_test::SparsePart;

TEST(Iterative, SolvesForAKnownSolution) {
  SparsePart c(sinew_test::capsule(40, 24, 2));
  c.matrix.positive = true;
  const std::vector<int64_t> pulls = c.pulls(), rhs = c.right_hand_side(pulls);
  c.matrix.assemble(pulls.data(), kIterativeDiagonalBits);
  const size_t entries = size_t{c.matrix.rows} * kBatch;
  std::vector<int64_t> batch(entries, 0), scratch(5 * size_t{c.matrix.rows});
  for (uint32_t k = 0; k < c.matrix.rows; ++k) batch[size_t{k} * kBatch + 2] = c.matrix.to_matrix(rhs[k]);
  std::vector<Reciprocal> inverse(c.matrix.rows);
  std::vector<int32_t> x(entries, 1);
  solve_iteratively(c.matrix, batch.data(), scratch.data(), inverse.data(), x.data());
  EXPECT_LT(c.worst_error(x, 2), 1e-5);
  for (size_t i = 0; i < entries; ++i) ASSERT_TRUE(i % kBatch == 2 || x[i] == 0);
}

}  // namespace
