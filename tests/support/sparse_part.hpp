// SPDX-License-Identifier: MIT
// A sparse system over a part of a scene, with a solution that is known.
#ifndef SINEW_TESTS_SUPPORT_SPARSE_PART_HPP
#define SINEW_TESTS_SUPPORT_SPARSE_PART_HPP

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "arena_block.hpp"
#include "heat_scene.hpp"
#include "solve/fronts.hpp"

namespace sinew_test {

// Everything that a solver of the first part of a scene needs.
struct SparsePart {
  explicit SparsePart(const HeatScene& scene) : run(scene, false), block(size(run.counts)) {
    edges.allocate(block.arena, run.counts);
    ordering.allocate(block.arena, run.counts);
    fronts.allocate(block.arena, run.counts);
    matrix.diagonal = block.arena.alloc<int64_t>(run.counts.vertices);
    EXPECT_EQ(sinew::weigh_edges(run.mesh, run.counts, block.arena, &edges), SINEW_OK);
    ordering.dissect(run.mesh, 0);
    matrix.mesh = &run.mesh;
    matrix.edges = &edges;
    matrix.ordering = &ordering;
    matrix.rows = run.mesh.part_sizes[0];
  }
  static size_t size(const sinew::Counts& counts) {
    sinew::Arena measure;
    sinew::EdgeWeights().allocate(measure, counts);
    sinew::Ordering().allocate(measure, counts);
    sinew::FrontFactor().allocate(measure, counts);
    measure.alloc<int64_t>(counts.vertices);
    (void)sinew::weigh_edges({}, counts, measure, nullptr);
    return measure.high_water();
  }

  // Pulls for a third of the rows, some of them a thousandfold stronger than the stiffness. Q40.
  std::vector<int64_t> pulls() const {
    std::vector<int64_t> pulls(matrix.rows);
    std::mt19937 random(5);
    for (int64_t& pull : pulls) pull = random() % 3 == 0 ? int64_t{1} << (30 + random() % 22) : 0;
    return pulls;
  }
  // A solution that falls along the body, by position.
  double wanted(uint32_t k) const {
    return 0.5 + 0.4 * run.mesh.positions[ordering.order[k]].y / static_cast<double>(sinew::kSide);
  }
  // What the matrix with these pulls makes of it, Q40.
  std::vector<int64_t> right_hand_side(const std::vector<int64_t>& pulls) const {
    const double one = std::pow(2.0, 40), edge_unit = std::pow(2.0, 40 - sinew::kEdgeWeightBits);
    std::vector<int64_t> out(matrix.rows);
    for (uint32_t k = 0; k < matrix.rows; ++k) {
      const uint32_t v = ordering.order[k];
      double b = static_cast<double>(pulls[k]) / one * wanted(k);
      for (uint32_t e = run.mesh.row_offsets[v]; e < run.mesh.row_offsets[v + 1]; ++e) {
        const double difference = wanted(k) - wanted(ordering.position[run.mesh.col_indices[e]]);
        b += static_cast<double>(matrix.weight(e)) * edge_unit / one * difference;
      }
      out[k] = static_cast<int64_t>(std::llround(b * one));
    }
    return out;
  }
  // Largest error of column `member` of a batch of solutions [rows x sinew::kBatch], Q24.
  double worst_error(const std::vector<int32_t>& x, uint32_t member) const {
    double worst = 0;
    for (uint32_t k = 0; k < matrix.rows; ++k) {
      const double found = x[size_t{k} * sinew::kBatch + member] * std::pow(2.0, -sinew::kSolutionBits);
      worst = std::max(worst, std::abs(found - wanted(k)));
    }
    return worst;
  }

  HeatRun run;
  Block block;
  sinew::EdgeWeights edges;
  sinew::Ordering ordering;
  sinew::FrontFactor fronts;
  sinew::SparseMatrix matrix;
};

}  // namespace sinew_test
#endif
