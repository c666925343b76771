// SPDX-License-Identifier: MIT
// Sparse factors: they solve what they were made of, badly conditioned equations too, and say when they do not fit.
#include "transfer/sparse_ldl.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "arena_block.hpp"

namespace sinew::transferring {
namespace {

using sinew_test::Block;

// The Laplacian of a grid with something on its diagonal, squared: neighbors of neighbors, condition about 1e8.
struct Grid {
  static constexpr uint32_t kSide = 12, kRows = kSide * kSide;
  std::vector<std::vector<double>> dense = std::vector<std::vector<double>>(kRows, std::vector<double>(kRows, 0));

  explicit Grid(double held) {
    std::vector<std::vector<double>> l = dense;
    for (uint32_t v = 0; v < kRows; ++v) {
      l[v][v] += held;
      for (const uint32_t w : {v + 1, v + kSide}) {
        if (w >= kRows || (w == v + 1 && w % kSide == 0)) continue;
        l[v][v] += 1;
        l[w][w] += 1;
        l[v][w] = l[w][v] = -1;
      }
    }
    for (uint32_t i = 0; i < kRows; ++i)
      for (uint32_t k = 0; k < kRows; ++k)
        for (uint32_t e = 0; e < kRows; ++e) dense[i][k] += l[i][e] * l[e][k];
  }
  // Every entry in two halves: columns that come more than once are added up.
  auto rows() const {
    return [this](uint32_t k, auto&& visit) {
      for (uint32_t c = 0; c < kRows; ++c) {
        if (dense[k][c] == 0) continue;
        visit(c, 0.25 * dense[k][c]);
        visit(c, 0.75 * dense[k][c]);
      }
    };
  }
};

TEST(SparseLdl, SolvesItsEquations) {
  for (const double held : {1.0, 1e-2, 1e-4}) {
    const Grid grid(held);
    Block block(size_t{1} << 22);
    SparseLdl ldl;
    ASSERT_TRUE(ldl.allocate(block.arena, Grid::kRows, 20000));
    ASSERT_TRUE(ldl.factorise(Grid::kRows, grid.rows()));
    std::mt19937 random(4);
    std::uniform_real_distribution<double> draw(-1, 1);
    std::vector<double> expected(Grid::kRows * SparseLdl::kBatch), x(expected.size(), 0);
    for (double& e : expected) e = draw(random);
    for (uint32_t i = 0; i < Grid::kRows; ++i)
      for (uint32_t k = 0; k < Grid::kRows; ++k)
        for (uint32_t b = 0; b < SparseLdl::kBatch; ++b)
          x[i * SparseLdl::kBatch + b] += grid.dense[i][k] * expected[k * SparseLdl::kBatch + b];
    ldl.solve(x.data());
    for (size_t i = 0; i < x.size(); ++i) ASSERT_NEAR(x[i], expected[i], 1e-5) << held;
  }
}

TEST(SparseLdl, TheSquaresDiagonalIsWhatSolvesGive) {
  for (const double held : {1.0, 1e-2}) {
    const Grid grid(held);
    Block block(size_t{1} << 22);
    SparseLdl ldl;
    ASSERT_TRUE(ldl.allocate(block.arena, Grid::kRows, 20000));
    ASSERT_TRUE(ldl.allocate_rates(block.arena, Grid::kRows));
    ASSERT_TRUE(ldl.factorise(Grid::kRows, grid.rows()));
    std::vector<double> expected(Grid::kRows, 0), weights(Grid::kRows), x(Grid::kRows * SparseLdl::kBatch);
    for (uint32_t k = 0; k < Grid::kRows; ++k) weights[k] = 0.5 + 0.01 * k;
    for (uint32_t k = 0; k < Grid::kRows; ++k) {
      x.assign(x.size(), 0);
      x[k * SparseLdl::kBatch] = 1;
      ldl.solve(x.data());
      for (uint32_t i = 0; i < Grid::kRows; ++i)
        expected[k] += weights[i] * x[i * SparseLdl::kBatch] * x[i * SparseLdl::kBatch];
    }
    std::vector<double> found(Grid::kRows);
    ldl.square_diagonal(weights.data(), found.data());
    for (uint32_t k = 0; k < Grid::kRows; ++k) ASSERT_NEAR(found[k], expected[k], 1e-7 * expected[k]) << k;
  }
}

TEST(SparseLdl, TooFewEntriesAreNoFactor) {
  const Grid grid(1);
  Block block(size_t{1} << 22);
  SparseLdl ldl;
  ASSERT_TRUE(ldl.allocate(block.arena, Grid::kRows, 500));
  EXPECT_FALSE(ldl.factorise(Grid::kRows, grid.rows()));
  Arena none;
  EXPECT_TRUE(SparseLdl().allocate(none, Grid::kRows, 500)) << "a measuring arena";
  EXPECT_GE(none.high_water(), 500 * (sizeof(uint32_t) + sizeof(double)));
}

TEST(SparseLdl, ASingularMatrixGivesFiniteNumbers) {
  Grid grid(1);
  for (auto& row : grid.dense) row.assign(row.size(), 1);
  Block block(size_t{1} << 22);
  SparseLdl ldl;
  ASSERT_TRUE(ldl.allocate(block.arena, Grid::kRows, 20000));
  ASSERT_TRUE(ldl.factorise(Grid::kRows, grid.rows()));
  std::vector<double> x(Grid::kRows * SparseLdl::kBatch, 1);
  ldl.solve(x.data());
  for (const double value : x) ASSERT_TRUE(std::isfinite(value));
}

}  // namespace
}  // namespace sinew::transferring
