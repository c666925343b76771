// SPDX-License-Identifier: MIT
// Distances against all pairs; parts.
#include "picture/outline/raster.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace sinew::picture {
namespace {

Mask of_text(const std::vector<std::string>& rows) {
  Mask mask{static_cast<uint32_t>(rows[0].size()), static_cast<uint32_t>(rows.size()), {}};
  for (const std::string& row : rows)
    for (const char c : row) mask.inside.push_back(c == '#' ? 1 : 0);
  return mask;
}

TEST(Raster, SpreadParabolasIsTheLeastOfAll) {
  Grid<float> grid(7, 5, kFar);
  grid.at(1, 1) = 3;
  grid.at(5, 3) = -2;
  grid.at(6, 0) = 0.5f;
  Grid<float> expected = grid;
  for (uint32_t y = 0; y < 5; ++y)
    for (uint32_t x = 0; x < 7; ++x) {
      float least = kFar;
      for (uint32_t v = 0; v < 5; ++v)
        for (uint32_t u = 0; u < 7; ++u) {
          const float dx = static_cast<float>(x) - static_cast<float>(u),
                      dy = static_cast<float>(y) - static_cast<float>(v);
          if (grid.at(u, v) < kFar) least = std::min(least, grid.at(u, v) + dx * dx + dy * dy);
        }
      expected.at(x, y) = least;
    }
  spread_parabolas(&grid);
  EXPECT_EQ(grid.values, expected.values);
}

TEST(Raster, OutsideOfThePictureIsNoFigure) {
  const Grid<float> deep = squared_distance(of_text({"###", "###", "###"}), true);
  EXPECT_EQ(deep.at(0, 0), 1);
  EXPECT_EQ(deep.at(1, 1), 4);
}

TEST(Raster, ClosingFillsGaps) {
  const Mask mask =
      of_text({".........", ".........", ".........", "...#.#...", ".........", ".........", "........."});
  EXPECT_TRUE(closed(mask, 1.5f).at(4, 3));
  EXPECT_FALSE(closed(mask, 1.5f).at(4, 1));
  EXPECT_TRUE(closed(mask, 0).inside == mask.inside);
}

TEST(Raster, FiguresTouchAtCornersAndGapsDoNot) {
  const Mask mask = of_text({"#.", ".#"});
  EXPECT_EQ(parts_of(mask, true).sizes.size(), 1u);
  EXPECT_EQ(parts_of(mask, false).sizes.size(), 2u);
}

}  // namespace
}  // namespace sinew::picture
