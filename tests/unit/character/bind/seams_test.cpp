// SPDX-License-Identifier: MIT
#include "sinew_character/bind/seams.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "block_body.hpp"
#include "gltf/gltf_source.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_formats/morphs.hpp"
#include "temp_folder.hpp"

namespace sinew {
namespace {

bool is_left(uint32_t joint) { return joint == kLeftUpLeg || joint == kLeftLeg; }
bool is_right(uint32_t joint) { return joint == kRightUpLeg || joint == kRightLeg; }

TEST(Seams, AreFoundWhereLegsHaveGrownTogether) {
  const Character body = block_body(1, 3);
  const Seams found = find_seams(body, blurred(body));
  ASSERT_FALSE(found.seams.empty());
  EXPECT_TRUE(is_left(static_cast<uint32_t>(found.seams[0].joints[0])));
  EXPECT_TRUE(is_right(static_cast<uint32_t>(found.seams[0].joints[1])));
  EXPECT_NEAR(found.seams[0].position.x, 5, 1);
  EXPECT_LT(found.seams[0].position.y, 6);
  EXPECT_GT(found.seams[0].length, 4);
}

TEST(Seams, AreNoneBetweenLegsThatStandApartNorOnAFlushSkirt) {
  for (const int high : {0, 4}) {
    const Character body = block_body(0, high);
    EXPECT_TRUE(find_seams(body, blurred(body)).seams.empty()) << high;
  }
}

TEST(Seams, NoWeightCrosses) {
  const Character body = block_body(1, 3);
  WeightRows rows = blurred(body);
  EXPECT_GT(measure_seam_leak(body, rows).wrong, 0.1);
  const Seams seams = find_seams(body, rows);
  std::vector<uint8_t> keep(rows.size(), 0);
  EXPECT_GT(keep_apart(body, seams, keep, &rows), 10u);
  EXPECT_LT(measure_seam_leak(body, rows).wrong, 0.02);
  for (const auto& row : rows) {
    float sum = 0;
    for (const Influence& one : row) sum += one.weight;
    EXPECT_NEAR(sum, 1, 1e-5);
  }
}

TEST(Seams, RowsThatAreKeptStay) {
  const Character body = block_body(1, 3);
  WeightRows rows = blurred(body);
  EXPECT_EQ(keep_apart(body, find_seams(body, rows), std::vector<uint8_t>(rows.size(), 1), &rows), 0u);
}

// How many faces below the knees have corners that belong to both legs; above, the legs begin to be one body.
size_t joined_faces(const Character& body) {
  size_t count = 0;
  for (size_t f = 0; f < body.face_count(); ++f) {
    bool left = false, right = false, low = true;
    for (uint32_t c = body.face_offsets[f]; c < body.face_offsets[f + 1]; ++c) {
      const uint32_t joint = body.influences[body.face_vertices[c]][0].joint;
      low = low && body.vertices[body.face_vertices[c]].y <= 4;
      left = left || is_left(joint);
      right = right || is_right(joint);
    }
    count += left && right && low ? 1 : 0;
  }
  return count;
}

TEST(Seams, ACutOpensThemAndMovesNextToNothing) {
  Character body = block_body(1, 3);
  body.confidence.assign(body.vertices.size(), 7);
  const Character before = body;
  const Seams seams = find_seams(body, body.influences);
  ASSERT_GT(joined_faces(body), 8u);
  const size_t doubled = cut_seams(seams, &body);
  EXPECT_GT(doubled, 4u);
  EXPECT_EQ(joined_faces(body), 0u);
  ASSERT_EQ(body.vertices.size(), before.vertices.size() + doubled);
  EXPECT_EQ(body.influences.size(), body.vertices.size());
  EXPECT_EQ(body.confidence.size(), body.vertices.size());
  ASSERT_EQ(body.face_vertices.size(), before.face_vertices.size());
  for (size_t c = 0; c < body.face_vertices.size(); ++c) {
    const Vec3 &now = body.vertices[body.face_vertices[c]], &then = before.vertices[before.face_vertices[c]];
    EXPECT_NEAR(now.x, then.x, 1e-4);
    EXPECT_NEAR(now.y, then.y, 1e-4);
    EXPECT_NEAR(now.z, then.z, 1e-4);
  }
}

TEST(Seams, WhatWasCutIsNotCutAgain) {
  Character body = block_body(1, 3);
  ASSERT_GT(cut_seams(find_seams(body, body.influences), &body), 4u);
  EXPECT_TRUE(find_seams(body, blurred(body)).seams.empty());
}

TEST(Seams, ACutDocumentKeepsItsAttributesAndShapes) {
  const TempFolder folder;
  Character body = block_body(1, 3);
  for (size_t c = 0; c < body.face_vertices.size(); ++c) {
    const Vec3& p = body.vertices[body.face_vertices[c]];
    body.corner_uvs.push_back({p.x / 16, p.y / 16});
  }
  const std::string first = folder.file("first.glb"), second = folder.file("second.glb");
  Morphs morphs;
  morphs.shapes = {{"lifted", {0, 1, 2}, {{0, 1, 0}, {0, 1, 0}, {0, 1, 0}}}};
  write_gltf_morphs(first, body, {}, morphs);
  Character read = read_gltf(first);
  const Seams seams = find_seams(read, read.influences);
  const size_t before = read.vertices.size(), doubled = cut_seams(seams, &read);
  ASSERT_GT(doubled, 4u);
  write_gltf(second, read);
  const Character again = read_gltf(second);
  EXPECT_EQ(again.vertices.size(), before + doubled);
  EXPECT_EQ(joined_faces(again), 0u);
  EXPECT_TRUE(find_seams(again, blurred(again)).seams.empty());
  ASSERT_EQ(again.face_count(), read.face_count());
  for (size_t c = 0; c < again.face_vertices.size(); ++c) {
    const Vec3& p = again.vertices[again.face_vertices[c]];
    EXPECT_NEAR(again.corner_uvs[c][0], p.x / 16, 1e-5);
    EXPECT_NEAR(again.corner_uvs[c][1], p.y / 16, 1e-5);
  }
  ASSERT_TRUE(again.gltf);
  for (const tinygltf::Mesh& mesh : again.gltf->model.meshes)
    for (const tinygltf::Primitive& primitive : mesh.primitives) {
      const size_t count = again.gltf->model.accessors[static_cast<size_t>(primitive.attributes.at("POSITION"))].count;
      ASSERT_EQ(primitive.targets.size(), 1u);
      for (const auto& [key, accessor] : primitive.targets[0])
        EXPECT_EQ(again.gltf->model.accessors[static_cast<size_t>(accessor)].count, count) << key;
    }
}

TEST(Seams, AreToldByNameOnceEach) {
  const Character body = block_body(1, 3);
  Seams seams;
  seams.seams = {{{kLeftLeg, kRightLeg}, {}, 2}, {{kLeftLeg, kRightLeg}, {}, 1}};
  EXPECT_EQ(seams_text(body.joints, seams, 0),
            "fused parts at LeftLeg and RightLeg; no weight crosses there, --cut opens the mesh there");
}

}  // namespace
}  // namespace sinew
