// SPDX-License-Identifier: MIT
// One part of one field: which of the three solvers takes it, and that they agree.
#include "heat/solver.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "heat_sources.hpp"

namespace {

using namespace sinew;
using sinew_test::Block;
using sinew_test::HeatRun;
using sinew_test::HeatScene;
using sinew_test::Sources;

// Solves every part with a factor that may hold `entries` and returns field 0.
std::vector<double> solve_with_limit(const HeatRun& run, size_t entries, uint32_t* iterative) {
  Arena measure;
  EdgeWeights edges;
  HeatSolver solver;
  HeatFields fields;
  fields.allocate(measure, run.counts);
  edges.allocate(measure, run.counts);
  solver.allocate(measure, run.counts);
  Block block(measure.high_water() + (4 << 20));
  fields.allocate(block.arena, run.counts);
  edges.allocate(block.arena, run.counts);
  EXPECT_EQ(weigh_edges(run.mesh, run.counts, block.arena, &edges), SINEW_OK);
  // With negative weights the two solvers answer different questions.
  for (uint32_t e = 0; e < run.mesh.row_offsets[run.mesh.welded_count]; ++e)
    edges.weight[e] = std::max(edges.weight[e], 0);
  HeatSolver real;
  real.allocate(block.arena, run.counts);
  real.limit_factor(entries);
  const Sources sources(run);
  *iterative = 0;
  for (uint32_t v = 0; v < run.mesh.welded_count; ++v) fields.field[0].nearest[v] = sources.found.nearest[0][v];
  for (uint32_t c = 0; c < run.mesh.part_count; ++c) {
    real.begin_part(run.mesh, edges, c);
    *iterative += real.iterative();
    real.solve_field(sources.found, kFieldRule, &fields.field[0]);
  }
  std::vector<double> out(size_t{run.mesh.welded_count} * run.counts.joints, 0.0);
  for (uint32_t v = 0; v < run.mesh.welded_count; ++v) {
    for (uint32_t s = 0; s < kHeatSlots; ++s) {
      const uint16_t joint = fields.field[0].joints[v * kHeatSlots + s];
      if (joint != kNoJoint) out[v * run.counts.joints + joint] = fields.field[0].weights[v * kHeatSlots + s] / 32768.0;
    }
  }
  return out;
}

TEST(Solver, IterativeAgreesWithTheFactor) {
  const HeatRun run(sinew_test::capsule(40, 24, 6), false);
  ASSERT_EQ(run.status, SINEW_OK);
  uint32_t direct_count = 0, iterative_count = 0;
  const std::vector<double> direct = solve_with_limit(run, SIZE_MAX, &direct_count);
  const std::vector<double> iterative = solve_with_limit(run, 1000, &iterative_count);
  EXPECT_EQ(direct_count, 0u);
  EXPECT_EQ(iterative_count, 1u);
  double largest = 0;
  for (size_t i = 0; i < direct.size(); ++i) largest = std::max(largest, std::abs(direct[i] - iterative[i]));
  EXPECT_LT(largest, 1e-4);
}

// A strip whose border triangles are very flat: the matrix is indefinite, because a border edge counts in full.
HeatScene flat_strip(int columns) {
  HeatScene scene;
  for (int i = 0; i <= columns; ++i) {
    scene.add_vertex(i, 3, 0);
    scene.add_vertex(i + 0.5, 3.05, 0.02 * (i % 3));
    scene.add_vertex(i, 6, 0.1);
  }
  for (uint32_t i = 0; i < static_cast<uint32_t>(columns); ++i) {
    const uint32_t a = 3 * i;
    scene.add_triangle(a, a + 1, a + 3);
    scene.add_triangle(a, a + 2, a + 1);
    scene.add_triangle(a + 1, a + 2, a + 5);
    scene.add_triangle(a + 1, a + 5, a + 3);
  }
  for (int j = 0; 50 * j < columns; ++j) scene.add_joint(50 * j, 4, -2, j - 1);
  return scene;
}

TEST(Solver, LargeIndefinitePartsKeepToFronts) {
  const HeatScene scene = flat_strip(22000);
  HeatRun run(scene, false);
  ASSERT_EQ(run.status, SINEW_OK);
  ASSERT_GT(run.mesh.part_sizes[0], 65536u);
  const Sources sources(run);
  Arena measure;
  EdgeWeights edges;
  HeatSolver solver;
  const auto allocate = [&](Arena& arena) {
    run.fields.allocate(arena, run.counts);
    edges.allocate(arena, run.counts);
    solver.allocate(arena, run.counts);
  };
  allocate(measure);
  (void)weigh_edges(run.mesh, run.counts, measure, &edges);
  Block block(measure.high_water());
  allocate(block.arena);
  block.arena.release(0);
  run.fields.allocate(block.arena, run.counts);
  edges.allocate(block.arena, run.counts);
  ASSERT_EQ(weigh_edges(run.mesh, run.counts, block.arena, &edges), SINEW_OK);
  solver.allocate(block.arena, run.counts);
  std::copy_n(sources.found.nearest[0], run.mesh.welded_count, run.fields.field[0].nearest);
  solver.begin_part(run.mesh, edges, 0);
  solver.solve_field(sources.found, kFieldRule, &run.fields.field[0]);
  EXPECT_TRUE(solver.with_fronts());
  EXPECT_FALSE(solver.iterative());
  for (uint32_t v = 0; v < run.mesh.welded_count; v += 7) {
    double sum = 0;
    for (uint32_t s = 0; s < kHeatSlots; ++s) sum += run.fields.field[kFieldRule].weights[v * kHeatSlots + s] / 32768.0;
    ASSERT_NEAR(sum, 1.0, 1e-3) << v;
  }
}

TEST(Solver, TanglesDoNotFitTheFactor) {
  const HeatRun run(sinew_test::tangle(700, 1500, 4, 5), false);
  ASSERT_EQ(run.status, SINEW_OK);
  uint32_t iterative = 0;
  (void)solve_with_limit(run, SIZE_MAX, &iterative);
  EXPECT_EQ(iterative, 1u);
}

TEST(Solver, FlattenedTanglesStayInRange) {
  // Needles in the ratio 1 to 1e5 give the iterative solver the widest range of numbers it can meet.
  for (uint32_t seed = 0; seed < 12; ++seed) {
    HeatScene scene = sinew_test::tangle(250, 900, 6, seed);
    for (size_t i = 0; i < scene.positions.size(); ++i) {
      if (i % 3 == 1 || (seed % 2 == 0 && i % 3 == 2)) scene.positions[i] *= 1e-5f;
    }
    const HeatRun run(scene);
    ASSERT_EQ(run.status, SINEW_OK);
    for (uint32_t v = 0; v < run.mesh.welded_count; ++v) {
      double sum = 0;
      for (uint32_t j = 0; j < 6; ++j) sum += run.weight(kFieldRule, v, j);
      ASSERT_NEAR(sum, 1.0, 2e-3) << "seed " << seed << " vertex " << v;
    }
  }
}

}  // namespace
