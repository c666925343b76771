// SPDX-License-Identifier: MIT
// Voxel cells that follow the vertices: the bounds, the law, and that more vertices never mean fewer cells, which the
// workspace of a mesh with double vertices hangs on.
#include "core/counts.hpp"

#include <gtest/gtest.h>

namespace {

using sinew::Counts;

uint32_t cells(uint32_t vertices) {
  Counts counts;
  counts.grid = 0;
  return counts.cells_along(vertices);
}

TEST(Counts, CellsFollowTheVertices) {
  EXPECT_EQ(cells(1), 32u);
  EXPECT_EQ(cells(2994), 32u);  // 33^3 / 12 = 2994.75
  EXPECT_EQ(cells(2995), 33u);
  EXPECT_EQ(cells(10034), 49u);
  EXPECT_EQ(cells(21845), 63u);  // 64^3 / 12 = 21845.3
  EXPECT_EQ(cells(21846), 64u);
  EXPECT_EQ(cells(SINEW_MAX_VERTICES), 64u);
}

TEST(Counts, CellsNeverFallAsVerticesGrow) {
  for (uint32_t vertices = 2; vertices < 40000; ++vertices) EXPECT_GE(cells(vertices), cells(vertices - 1)) << vertices;
}

TEST(Counts, AGivenGridStays) {
  Counts counts;
  counts.grid = 48;
  EXPECT_EQ(counts.cells_along(10), 48u);
  EXPECT_EQ(counts.cells_along(SINEW_MAX_VERTICES), 48u);
}

TEST(Counts, LegalGrids) {
  for (uint32_t grid = 0; grid < 200; ++grid)
    EXPECT_EQ(sinew::is_legal_grid(grid), grid == 0 || (grid >= 16 && grid <= 128));
}

}  // namespace
