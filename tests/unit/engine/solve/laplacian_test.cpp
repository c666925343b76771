// SPDX-License-Identifier: MIT
// Cotangent weights: known angles, borders, and the rules that keep a reduced mesh positive.
#include "solve/laplacian.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <vector>

#include "arena_block.hpp"
#include "heat_scene.hpp"

namespace {

using namespace sinew;
using sinew_test::Block;
using sinew_test::HeatRun;
using sinew_test::HeatScene;

TEST(Laplacian, KnownAngles) {
  constexpr int32_t one = 1 << kEdgeWeightBits;
  EXPECT_EQ(cotangent_q24({0, 0, 0}, {7, 0, 0}, {0, 3, 0}), 0);
  EXPECT_EQ(cotangent_q24({0, 0, 0}, {5, 0, 0}, {5, 5, 0}), one);
  EXPECT_EQ(cotangent_q24({0, 0, 0}, {5, 0, 0}, {-5, 5, 0}), -one);
  EXPECT_EQ(cotangent_q24({-524288, 0, -524288}, {524288, 0, -524288}, {524288, 1048576, -524288}), one);
  EXPECT_EQ(cotangent_q24({0, 0, 0}, {1000000, 0, 0}, {1000000, 1, 0}), 50 * one);
  EXPECT_EQ(cotangent_q24({0, 0, 0}, {1000000, 0, 0}, {-1000000, 1, 0}), -50 * one);
  EXPECT_NEAR(cotangent_q24({0, 0, 0}, {3, 1, 2}, {-1, 4, 2}), one * (5.0 / std::sqrt(14 * 21 - 25.0)), 1);
  EXPECT_NEAR(cotangent_q24({1, 1, 1}, {1048576, 1, 7}, {1048570, 30001, 9}), one * 34.9519, one * 0.01);
}

TEST(Laplacian, BorderEdgesCountInFull) {
  // A unit square of two right triangles: the diagonal sees two right angles, every side one angle of 45 degrees.
  HeatScene scene;
  scene.add_vertex(0, 0, 0);
  scene.add_vertex(1, 0, 0);
  scene.add_vertex(1, 1, 0);
  scene.add_vertex(0, 1, 0);
  scene.add_triangle(0, 1, 2);
  scene.add_triangle(0, 2, 3);
  scene.add_joint(0.5, 0.5, -0.5, -1);
  const HeatRun run(scene, false);
  ASSERT_EQ(run.status, SINEW_OK);
  Block block(1 << 16);
  EdgeWeights edges;
  edges.allocate(block.arena, run.counts);
  ASSERT_EQ(weigh_edges(run.mesh, run.counts, block.arena, &edges), SINEW_OK);
  std::multiset<int32_t> weights(edges.weight, edges.weight + run.mesh.row_offsets[run.mesh.welded_count]);
  EXPECT_EQ(weights.count(0), 2u);
  EXPECT_EQ(weights.count(1 << kEdgeWeightBits), 8u);
}

// Smallest pivot of the matrix of the edge weights, which is singular at best, after a millionth was added.
double smallest_pivot(const Mesh& mesh, const EdgeWeights& edges) {
  const size_t n = mesh.welded_count;
  std::vector<double> m(n * n, 0);
  double largest = 0;
  for (uint32_t v = 0; v < n; ++v) {
    for (uint32_t e = mesh.row_offsets[v]; e < mesh.row_offsets[v + 1]; ++e) {
      m[v * n + mesh.col_indices[e]] -= edges.weight[e];
      m[v * n + v] += edges.weight[e];
      largest = std::max(largest, std::fabs(static_cast<double>(edges.weight[e])));
    }
  }
  double smallest = largest;
  for (size_t k = 0; k < n; ++k) {
    const double pivot = m[k * n + k] + largest * 1e-6;
    smallest = std::min(smallest, pivot);
    if (pivot <= 0) break;
    for (size_t i = k + 1; i < n; ++i) {
      for (size_t j = k + 1; j < n; ++j) m[i * n + j] -= m[i * n + k] * m[k * n + j] / pivot;
    }
  }
  return smallest;
}

// Needles whose cotangents were cut, and edges with any number of triangles: as the caller's they may spoil the matrix,
// on a reduced mesh they must not.
TEST(Laplacian, OfAReducedMeshIsPositive) {
  int spoilt = 0;
  for (uint32_t seed = 0; seed < 60; ++seed) {
    HeatScene scene = sinew_test::tangle(16, 30, 1, seed);
    for (size_t v = 0; v < scene.positions.size(); v += 3) scene.positions[v] *= 0.002f;
    HeatRun run(scene, false);
    ASSERT_EQ(run.status, SINEW_OK);
    Block block(1 << 16);
    EdgeWeights edges;
    edges.allocate(block.arena, run.counts);
    ASSERT_EQ(weigh_edges(run.mesh, run.counts, block.arena, &edges), SINEW_OK);
    spoilt += smallest_pivot(run.mesh, edges) <= 0 ? 1 : 0;
    run.mesh.reduced = true;
    ASSERT_EQ(weigh_edges(run.mesh, run.counts, block.arena, &edges), SINEW_OK);
    EXPECT_GT(smallest_pivot(run.mesh, edges), 0) << seed;
  }
  EXPECT_GT(spoilt, 10) << "no scene needs the rules";
}

}  // namespace
