// SPDX-License-Identifier: MIT
// The lattice of a mesh: volumes, edges, weights of nodes and the position of every vertex.
#include "deform/lattice.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <utility>

#include "bent_tube.hpp"
#include "deform/rest.hpp"

namespace sinew::deform {
namespace {

struct Built {
  explicit Built(const sinew_test::BentTube& tube, uint32_t cells = 0) {
    RestInput input;
    sinew_deform_options options = SINEW_INIT(sinew_deform_options);
    options.cell_count = cells;
    EXPECT_EQ(read_deform_options(&options, &input.options), SINEW_OK);
    input.mesh = tube.mesh();
    input.skeleton = tube.skeleton();
    input.skin = tube.skin();
    Arena measuring;
    DeformRest ignored;
    EXPECT_EQ(build_rest(input, measuring, &ignored), SINEW_OK);
    memory = Workspace(measuring.high_water());
    Arena arena(memory.data(), memory.size());
    EXPECT_EQ(build_rest(input, arena, &rest), SINEW_OK);
  }
  Workspace memory;
  DeformRest rest;
};

int64_t six_volumes(const Lattice& lattice, uint32_t t) {
  const uint32_t* const at = lattice.tetrahedra + 4 * size_t{t};
  const Vec3i a = lattice.nodes[at[0]];
  const Vec3l c = cross(lattice.nodes[at[2]] - a, lattice.nodes[at[3]] - a);
  return dot(Vec3l{c.x >> 14, c.y >> 14, c.z >> 14}, lattice.nodes[at[1]] - a);
}

TEST(Lattice, TetrahedraFillCellsAndTheFifthIsTheLargeOne) {
  const sinew_test::BentTube tube;
  const Built built(tube);
  const Lattice& lattice = built.rest.lattice;
  ASSERT_GT(lattice.tetrahedron_count, 200u);
  ASSERT_EQ(lattice.tetrahedron_count % 5, 0u);
  for (uint32_t t = 0; t < lattice.tetrahedron_count; ++t) {
    ASSERT_EQ(six_volumes(lattice, t), int64_t{t % 5 == 4 ? 2 : 1} << 28) << t;
  }
}

TEST(Lattice, EdgesAreThoseOfTheTetrahedraOnceEach) {
  const sinew_test::BentTube tube;
  const Built built(tube);
  const Lattice& lattice = built.rest.lattice;
  std::set<std::pair<uint32_t, uint32_t>> want, have;
  for (uint32_t t = 0; t < lattice.tetrahedron_count; ++t)
    for (int a = 0; a < 4; ++a)
      for (int b = 0; b < 4; ++b) {
        const uint32_t x = lattice.tetrahedra[4 * size_t{t} + static_cast<size_t>(a)],
                       y = lattice.tetrahedra[4 * size_t{t} + static_cast<size_t>(b)];
        if (x < y) want.emplace(x, y);
      }
  for (uint32_t e = 0; e < lattice.edge_count; ++e) have.emplace(lattice.edges[e].a, lattice.edges[e].b);
  EXPECT_EQ(have, want);
  EXPECT_EQ(lattice.edge_count, want.size());
}

// Pieces of one color have no node in common, and every copy and edge is in one piece, the edge in one of a copy that has it.
TEST(Lattice, PiecesOfAColorAreApart) {
  sinew_test::BentTube tube(2, 0.3, 0.12);
  const Built built(tube, 64);
  const Lattice& lattice = built.rest.lattice;
  ASSERT_GT(lattice.piece_count(), 2 * kColors);
  std::set<uint32_t> copies;
  for (uint32_t color = 0; color < kColors; ++color) {
    std::set<uint32_t> before;
    for (uint32_t p = lattice.color_pieces[color]; p < lattice.color_pieces[color + 1]; ++p) {
      std::set<uint32_t> nodes;
      for (uint32_t i = lattice.piece_copies[p]; i < lattice.piece_copies[p + 1]; ++i) {
        ASSERT_TRUE(copies.insert(lattice.copy_order[i]).second);
        for (size_t k = 0; k < 20; ++k) nodes.insert(lattice.tetrahedra[20 * size_t{lattice.copy_order[i]} + k]);
      }
      for (uint32_t e = lattice.piece_edges[p]; e < lattice.piece_edges[p + 1]; ++e) {
        ASSERT_EQ(nodes.count(lattice.edges[e].a) + nodes.count(lattice.edges[e].b), 2u);
      }
      for (const uint32_t n : nodes) ASSERT_TRUE(before.insert(n).second) << color << ' ' << n;
    }
  }
  EXPECT_EQ(copies.size() * 5, lattice.tetrahedron_count);
}

TEST(Lattice, VerticesLieWhereTheirSharesSay) {
  const sinew_test::BentTube tube;
  for (const uint32_t cells : {8u, 32u, 50u}) {
    const Built built(tube, cells);
    const DeformRest& rest = built.rest;
    for (uint32_t v = 0; v < rest.vertex_count; ++v) {
      const Embedding& embedding = rest.lattice.vertices[rest.welded[v]];
      ASSERT_NE(embedding.tetrahedron, kNoTetrahedron);
      Vec3d at = {0, 0, 0};
      int sum = 0;
      for (size_t k = 0; k < 4; ++k) {
        ASSERT_GE(embedding.shares[k], 0);
        sum += embedding.shares[k];
        at = at + embedding.shares[k] / 16384.0 *
                      rest.node_position(rest.lattice.tetrahedra[4 * size_t{embedding.tetrahedron} + k]);
      }
      ASSERT_EQ(sum, 1 << kShareBits);
      const Vec3d off = at - rest.position(v);
      ASSERT_LT(std::sqrt(dot(off, off)), 2e-4 * rest.unit * kCellUnits + 4e-6) << v;
    }
  }
}

TEST(Lattice, NodesHaveTheWeightsOfTheSkinAroundThem) {
  const sinew_test::BentTube tube(2, 0.3);
  const Built built(tube);
  const DeformRest& rest = built.rest;
  for (uint32_t n = 0; n < rest.lattice.node_count; ++n) {
    const WeightRow& row = rest.lattice.rows[n];
    uint32_t sum = 0;
    for (const uint16_t w : row.weights) sum += w;
    ASSERT_EQ(sum, 65535u) << n;
    const double x = rest.node_position(n).x;
    if (x < -0.3) {
      ASSERT_GE(row.of(0), 65000u) << x;
    }
    if (x > 0.3) {
      ASSERT_GE(row.of(1), 65000u) << x;
    }
    // Free near the blend alone; nodes on the bones never.
    if (x < -0.5 || x > 0.5) {
      EXPECT_EQ(rest.node_flags[n] & 1, 0) << x;
    }
  }
}

TEST(WeightRow, KeepsTheLargestAndAnExactSum) {
  Arena measuring;
  RowSum counting;
  counting.allocate(measuring, 20);
  Workspace memory(measuring.high_water());
  Arena arena(memory.data(), memory.size());
  RowSum sum;
  ASSERT_TRUE(sum.allocate(arena, 20));
  sum.clear(20);
  for (uint32_t j = 0; j < 20; ++j) sum.add(j, 100 + (j * 7) % 20);
  const WeightRow row = sum.take();
  uint32_t total = 0;
  for (uint32_t s = 0; s < kNodeSlots; ++s) {
    total += row.weights[s];
    if (s > 0) {
      EXPECT_GE(row.weights[s - 1], row.weights[s]);
    }
    EXPECT_GE(row.joints[s] * 7 % 20, 12) << s;  // the eight largest
  }
  EXPECT_EQ(total, 65535u);
  EXPECT_TRUE(sum.take().empty());
  sum.add(3, 5);
  EXPECT_EQ(row_distance(sum.take(), row), row.of(3) == 0 ? 131070u : 131070u - 2u * row.of(3));
}

}  // namespace
}  // namespace sinew::deform
