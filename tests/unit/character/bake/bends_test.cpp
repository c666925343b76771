// SPDX-License-Identifier: MIT
// Bends are where vertices follow what is below a joint and something else.
#include "bake/bends.hpp"

#include <gtest/gtest.h>

namespace sinew {
namespace {

TEST(Bends, NearestFirst) {
  Character c;
  c.joints = {
      {"root", {0, 0, 0}, -1}, {"a", {0, 1, 0}, 0}, {"b", {0, 2, 0}, 1}, {"c", {0, 3, 0}, 2}, {"d", {0, 4, 0}, 3}};
  c.influences = {{{0, 0.5f}, {1, 0.5f}}, {{1, 0.5f}, {2, 0.5f}}, {{2, 0.2f}, {3, 0.8f}}, {{1, 1.0f}}, {{3, 1.0f}}};
  c.vertices.resize(5);
  const Bends bends = find_bends(c, 2);
  EXPECT_EQ(bends.joints, (std::vector<size_t>{1, 2, 3})) << "nothing follows d, nothing is before the root";
  EXPECT_EQ(bends.distances[1], (std::vector<double>{1.5, 0.5, 0, 1, 2}));
  EXPECT_EQ(bends.of_vertex[0], (std::vector<size_t>{0, 1}));
  EXPECT_EQ(bends.of_vertex[2], (std::vector<size_t>{2, 1}));
  EXPECT_EQ(bends.of_vertex[3], (std::vector<size_t>{0, 1})) << "first the one that moves it";
  EXPECT_EQ(bends.of_vertex[4], (std::vector<size_t>{2, 1}));
}

TEST(Bends, NoneWhereEachVertexFollowsOneRigidPart) {
  Character c;
  c.joints = {{"root", {0, 0, 0}, -1}, {"a", {0, 1, 0}, 0}};
  c.influences = {{{0, 1.0f}}, {{1, 1.0f}}};
  c.vertices.resize(2);
  const Bends bends = find_bends(c, 2);
  EXPECT_TRUE(bends.joints.empty());
  EXPECT_TRUE(bends.of_vertex[1].empty());
}

TEST(Bends, BetweenVerticesOfRigidParts) {
  Character c;
  c.joints = {{"root", {0, 0, 0}, -1}, {"a", {0, 1, 0}, 0}};
  c.influences = {{{0, 1.0f}}, {{1, 1.0f}}, {{1, 1.0f}}};
  c.vertices.resize(3);
  c.face_offsets = {0, 3};
  c.face_vertices = {0, 1, 2};
  EXPECT_EQ(find_bends(c, 2).joints, std::vector<size_t>{1});
}

}  // namespace
}  // namespace sinew
