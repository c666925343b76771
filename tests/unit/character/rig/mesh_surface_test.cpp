// SPDX-License-Identifier: MIT
// Neighbors along edges and across seams; how much of a surface moves with each joint.
#include "sinew_character/rig/mesh_surface.hpp"

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

TEST(MeshNeighbors, TheFirstVertexOfAPlaceStandsForAll) {
  EXPECT_EQ(first_at_position(cut_strip()), (std::vector<uint32_t>{0, 1, 2, 3, 1, 2, 6, 7}));
  EXPECT_TRUE(first_at_position(Character()).empty());
}

TEST(MeshNeighbors, EdgesAndTwinsAtSeams) {
  std::vector<std::vector<uint32_t>> neighbors = neighbors_of(cut_strip());
  for (std::vector<uint32_t>& list : neighbors) std::sort(list.begin(), list.end());
  EXPECT_EQ(neighbors[0], (std::vector<uint32_t>{1, 3})) << "no diagonal";
  EXPECT_EQ(neighbors[1], (std::vector<uint32_t>{0, 2, 4}));
  EXPECT_EQ(neighbors[5], (std::vector<uint32_t>{2, 4, 6}));
}

// A quad of area 2 and a triangle of area 1 beside it, at x = 0..2 and 2..4; a joint each and one for nothing.
Character two_faces() {
  Character c;
  c.vertices = {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}, {2, 0, 0}, {4, 0, 0}, {2, 1, 0}};
  c.face_vertices = {0, 1, 2, 3, 4, 5, 6};
  c.face_offsets = {0, 4, 7};
  for (const float x : {1.0f, 3.0f, 9.0f}) {
    Joint joint;
    joint.position = {x, 5, 0};
    c.joints.push_back(joint);
  }
  for (size_t v = 0; v < 7; ++v) c.influences.push_back({{v < 4 ? 0u : 1u, 1.0f}});
  return c;
}

TEST(JointSurfaces, AreasAreSharedByWeight) {
  const Character c = two_faces();
  const JointSurfaces surfaces = joint_surfaces(c);
  ASSERT_EQ(surfaces.shares.size(), 3u);
  EXPECT_NEAR(surfaces.shares[0], 2.0 / 3, 1e-6);
  EXPECT_NEAR(surfaces.shares[1], 1.0 / 3, 1e-6);
  EXPECT_EQ(surfaces.shares[2], 0);
  EXPECT_NEAR(surfaces.centroids[0], 1, 1e-6);
  EXPECT_NEAR(surfaces.centroids[3], 8.0 / 3, 1e-6);
  EXPECT_EQ(surfaces.centroids[6], 9) << "where nothing moves with it, the joint's place";
}

TEST(JointSurfaces, VerticesCountAlikeWithoutASurface) {
  Character c = two_faces();
  c.face_vertices.clear();
  c.face_offsets.assign(1, 0);
  const JointSurfaces surfaces = joint_surfaces(c);
  ASSERT_EQ(surfaces.shares.size(), 3u);
  EXPECT_NEAR(surfaces.shares[0], 4.0 / 7, 1e-6);
}

TEST(JointSurfaces, ThereAreNoneWithoutWeights) {
  Character c = two_faces();
  for (auto& row : c.influences) row.clear();
  EXPECT_TRUE(joint_surfaces(c).shares.empty());
  c.influences.clear();
  EXPECT_TRUE(joint_surfaces(c).shares.empty());
}

}  // namespace
}  // namespace sinew
