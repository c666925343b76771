// SPDX-License-Identifier: MIT
// Neighbours along edges and across seams.
#include "sinew_character/rig/mesh_neighbours.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace sinew {
namespace {

// Two squares side by side, cut at the edge that they share: 1 and 4, 2 and 5 lie at one position.
Character cut_strip() {
  Character c;
  c.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}, {2, 1, 0}, {2, 0, 0}};
  c.face_vertices = {0, 1, 2, 3, 4, 7, 6, 5};
  c.face_offsets = {0, 4, 8};
  return c;
}

TEST(MeshNeighbours, TheFirstVertexOfAPlaceStandsForAll) {
  EXPECT_EQ(first_at_position(cut_strip()), (std::vector<uint32_t>{0, 1, 2, 3, 1, 2, 6, 7}));
  EXPECT_TRUE(first_at_position(Character()).empty());
}

TEST(MeshNeighbours, EdgesAndTwinsAtSeams) {
  std::vector<std::vector<uint32_t>> neighbours = neighbours_of(cut_strip());
  for (std::vector<uint32_t>& list : neighbours) std::sort(list.begin(), list.end());
  EXPECT_EQ(neighbours[0], (std::vector<uint32_t>{1, 3})) << "no diagonal";
  EXPECT_EQ(neighbours[1], (std::vector<uint32_t>{0, 2, 4}));
  EXPECT_EQ(neighbours[5], (std::vector<uint32_t>{2, 4, 6}));
}

}  // namespace
}  // namespace sinew
