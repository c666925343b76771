// SPDX-License-Identifier: MIT
// A garment's body and the garment as one mesh, and rows taken from the caller's vertices.
#include "transfer/rebind.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "arena_block.hpp"
#include "mesh_scene.hpp"

namespace sinew::transferring {
namespace {

using sinew_test::Block;
using sinew_test::MeshScene;

TEST(DressedMesh, HoldsBothBodyFirst) {
  MeshScene body, garment;
  sinew_test::add_cube(&body, 0, 0, 0);
  sinew_test::add_cube(&garment, 5, 0, 0);
  garment.add_face({0, 1, 2});
  sinew_mesh triangles = garment.mesh_view();
  Counts counts;
  counts.vertices = 16;
  counts.faces = 13;
  counts.corners = body.mesh_view().corner_count + triangles.corner_count;
  Block block(size_t{1} << 16);
  DressedMesh dressed;
  ASSERT_TRUE(dressed.allocate(block.arena, counts));
  dressed.join(body.mesh_view(), triangles);
  ASSERT_EQ(dressed.mesh.vertex_count, 16u);
  ASSERT_EQ(dressed.mesh.face_count, 13u);
  ASSERT_EQ(dressed.mesh.corner_count, counts.corners);
  EXPECT_EQ(dressed.mesh.positions[3 * 8], 5.0f);
  EXPECT_EQ(dressed.mesh.face_offsets[6], 24u);
  EXPECT_EQ(dressed.mesh.face_offsets[13], counts.corners);
  for (uint32_t c = 0; c < 24; ++c) EXPECT_EQ(dressed.mesh.face_vertices[c], body.corners[c]);
  for (uint32_t c = 24; c < counts.corners; ++c) EXPECT_EQ(dressed.mesh.face_vertices[c], garment.corners[c - 24] + 8);
}

TEST(DressedMesh, TrianglesWithoutOffsetsGetThem) {
  const float corners[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  const uint32_t face[3] = {0, 1, 2};
  const sinew_mesh triangle = {corners, 3, nullptr, face, 1, 3};
  Counts counts;
  counts.vertices = counts.corners = 6;
  counts.faces = 2;
  Block block(size_t{1} << 16);
  DressedMesh dressed;
  ASSERT_TRUE(dressed.allocate(block.arena, counts));
  dressed.join(triangle, triangle);
  EXPECT_EQ(dressed.mesh.face_offsets[1], 3u);
  EXPECT_EQ(dressed.mesh.face_offsets[2], 6u);
  EXPECT_EQ(dressed.mesh.face_vertices[5], 5u);
}

// Two of the caller's vertices at one position: the mean of their rows.
TEST(OwnRows, AreMeansOfWhatIsWelded) {
  MeshScene scene;
  for (const float x : {0.0f, 1.0f, 0.0f, 0.0f}) scene.add_vertex(x, 0, scene.vertex_count() == 3 ? 1.0f : 0.0f);
  scene.add_face({0, 1, 3});
  scene.add_face({2, 3, 1});
  const sinew_test::MeshRun run(scene);
  ASSERT_EQ(run.mesh.welded_count, 3u);
  const uint16_t joints[4] = {0, 1, 1, 0}, weights[4] = {65535, 65535, 65535, 65535};
  Block block(size_t{1} << 16);
  OwnRows rows;
  ASSERT_TRUE(rows.allocate(block.arena, run.counts));
  rows.gather(run.mesh, joints, weights, SINEW_WEIGHT_UNORM16, 1);
  const uint32_t both = run.mesh.vertex_to_welded[0];
  EXPECT_EQ(both, run.mesh.vertex_to_welded[2]);
  EXPECT_NEAR(rows.rows().weight(both, 0), kWholeRow / 2, 2);
  EXPECT_NEAR(rows.rows().weight(both, 1), kWholeRow / 2, 2);
  EXPECT_NEAR(rows.rows().weight(run.mesh.vertex_to_welded[3], 0), kWholeRow, 2);
}

}  // namespace
}  // namespace sinew::transferring
