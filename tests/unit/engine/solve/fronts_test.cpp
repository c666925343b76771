// SPDX-License-Identifier: MIT
// The multifrontal factor: a known solution, what it skips, what it refuses.
#include "solve/fronts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "sparse_part.hpp"

namespace {

using namespace sinew;
using sinew_test::SparsePart;

TEST(Fronts, SolveForAKnownSolution) {
  SparsePart c(sinew_test::star(40, 50, 2));
  const std::vector<int64_t> pulls = c.pulls(), rhs = c.right_hand_side(pulls);
  ASSERT_TRUE(c.fronts.analyze(c.matrix));
  c.matrix.assemble(pulls.data(), kFactorDiagonalBits);
  ASSERT_TRUE(c.fronts.factorise(c.matrix, FrontKernels()));
  const FrontSolve& solve = c.fronts.own_solve();
  c.fronts.begin(solve);
  for (uint32_t k = 0; k < c.matrix.rows; ++k) c.fronts.add(solve, k, 3, rhs[k]);
  c.fronts.eliminate(FrontKernels(), solve);
  uint32_t seen = 0;
  double worst = 0;
  c.fronts.substitute(FrontKernels(), solve, [&](uint32_t first, uint32_t count, const int32_t* x) {
    for (uint32_t i = 0; i < count; ++i, ++seen) {
      const double found = x[i * kFrontBatch + 3] * std::pow(2.0, -kFrontSolutionBits);
      worst = std::max(worst, std::abs(found - c.wanted(first + i)));
      for (uint32_t m = 0; m < kFrontBatch; ++m) EXPECT_TRUE(m == 3 || x[i * kFrontBatch + m] == 0);
    }
  });
  EXPECT_EQ(seen, c.matrix.rows);
  EXPECT_LT(worst, 2e-5);
}

TEST(Fronts, SkipWhatARightHandSideDoesNotReach) {
  SparsePart c(sinew_test::capsule(200, 20, 2));
  const uint32_t rows = c.matrix.rows;
  const std::vector<int64_t> pulls(rows, int64_t{1} << 39);
  ASSERT_TRUE(c.fronts.analyze(c.matrix));
  c.matrix.assemble(pulls.data(), kFactorDiagonalBits);
  ASSERT_TRUE(c.fronts.factorise(c.matrix, FrontKernels()));
  const FrontSolve& solve = c.fronts.own_solve();
  c.fronts.begin(solve);
  c.fronts.add(solve, c.ordering.position[0], 0, pulls[0]);
  c.fronts.eliminate(FrontKernels(), solve);
  uint32_t seen = 0;
  int32_t largest = 0;
  c.fronts.substitute(FrontKernels(), solve, [&](uint32_t, uint32_t count, const int32_t* x) {
    seen += count;
    for (uint32_t i = 0; i < count; ++i) largest = std::max(largest, x[i * kFrontBatch]);
  });
  EXPECT_GT(largest, 1 << (kFrontSolutionBits - 4));
  EXPECT_GT(seen, 20u);
  EXPECT_LT(seen, rows / 3);
}

TEST(Fronts, RefuseAMatrixThatIsNotDefinite) {
  SparsePart c(sinew_test::capsule(20, 20, 2));
  std::vector<int64_t> pulls(c.matrix.rows, 0);
  ASSERT_TRUE(c.fronts.analyze(c.matrix));
  c.matrix.assemble(pulls.data(), kFactorDiagonalBits);
  EXPECT_FALSE(c.fronts.factorise(c.matrix, FrontKernels()));  // singular: constants cost nothing
  pulls[7] = int64_t{1} << 40;
  c.matrix.assemble(pulls.data(), kFactorDiagonalBits);
  EXPECT_TRUE(c.fronts.factorise(c.matrix, FrontKernels()));
  c.matrix.diagonal[9] = -c.matrix.diagonal[9];
  EXPECT_FALSE(c.fronts.factorise(c.matrix, FrontKernels()));
}

}  // namespace
