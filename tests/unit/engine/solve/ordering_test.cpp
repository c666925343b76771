// SPDX-License-Identifier: MIT
// The elimination order: a permutation with little fill.
#include "solve/ordering.hpp"

#include <gtest/gtest.h>

#include <set>

#include "arena_block.hpp"
#include "heat_scene.hpp"
#include "solve/factor.hpp"

namespace {

using namespace sinew;
using sinew_test::Block;
using sinew_test::HeatRun;

TEST(Ordering, IsAPermutationAndKeepsFillSmall) {
  const HeatRun run(sinew_test::star(40, 50, 2), false);
  ASSERT_EQ(run.status, SINEW_OK);
  Arena measure;
  Ordering ordering;
  Factor factor;
  ordering.allocate(measure, run.counts);
  factor.allocate(measure, run.counts);
  Block block(measure.high_water());
  ordering.allocate(block.arena, run.counts);
  factor.allocate(block.arena, run.counts);
  ordering.dissect(run.mesh, 0);
  std::set<uint32_t> seen(ordering.order, ordering.order + run.mesh.welded_count);
  EXPECT_EQ(seen.size(), run.mesh.welded_count);
  for (uint32_t k = 0; k < run.mesh.welded_count; ++k) EXPECT_EQ(ordering.position[ordering.order[k]], k);
  SparseMatrix matrix;
  matrix.mesh = &run.mesh;
  matrix.ordering = &ordering;
  matrix.rows = run.mesh.welded_count;
  ASSERT_TRUE(factor.analyze(matrix));
  // Minimum degree: 21 per vertex; dissection 26, a little more or less by which vertices its medians are of; by number: 45.
  EXPECT_LT(factor.column_start[run.mesh.welded_count], 27u * run.mesh.welded_count);
}

}  // namespace
