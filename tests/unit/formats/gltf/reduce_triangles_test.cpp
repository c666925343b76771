// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "expect_error.hpp"
#include "gltf/gltf_source.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_formats/lod_document.hpp"
#include "sinew_formats/morphs.hpp"
#include "temp_folder.hpp"

namespace sinew {
namespace {

#ifdef SINEW_HAS_MESHOPT

constexpr uint32_t kSide = 24;

// A wavy square in two materials, bound to two joints, with a shape; all that a vertex has follows from its position.
Character waves() {
  Character c;
  c.name = "waves";
  c.joints = {{"left", {0, 0, 0}, -1}, {"right", {1, 0, 0}, 0}};
  c.material_names = {"a", "b"};
  for (uint32_t y = 0; y < kSide; ++y)
    for (uint32_t x = 0; x < kSide; ++x) {
      const float u = static_cast<float>(x) / (kSide - 1), v = static_cast<float>(y) / (kSide - 1);
      c.vertices.push_back({u, v, 0.05f * std::sin(9 * u) * std::sin(7 * v)});
      c.influences.push_back({{0, 1 - u}, {1, u}});
    }
  for (uint32_t y = 0; y + 1 < kSide; ++y)
    for (uint32_t x = 0; x + 1 < kSide; ++x) {
      const uint32_t a = y * kSide + x;
      for (const uint32_t corner : {a, a + 1, a + kSide + 1, a + kSide}) {
        c.face_vertices.push_back(corner);
        c.corner_uvs.push_back({c.vertices[corner].x, c.vertices[corner].y});
      }
      c.face_offsets.push_back(static_cast<uint32_t>(c.face_vertices.size()));
      c.face_materials.push_back(x < kSide / 2 ? 0 : 1);
    }
  return c;
}

TEST(ReduceTriangles, VerticesThatAreLeftKeepAllAndPartsGoOnTouching) {
  TempFolder folder;
  const Character plain = waves();
  Morphs morphs;
  morphs.shapes = {{"lift", {}, {}}};
  for (uint32_t v = 0; v < plain.vertices.size(); ++v) {
    morphs.shapes[0].vertices.push_back(v);
    morphs.shapes[0].moves.push_back({0, 0, 1 + plain.vertices[v].x});
  }
  write_gltf_morphs(folder.file("waves.glb"), plain, {}, morphs);
  const Character whole = read_gltf(folder.file("waves.glb"));
  const std::vector<uint8_t> glb = reduced_glb("waves", whole, whole.vertices, 0.2);
  const Character less = read_gltf(folder.write("less.glb", std::string(glb.begin(), glb.end())));
  EXPECT_LT(less.face_count(), whole.face_count() * 3 / 10);
  EXPECT_GT(less.face_count(), whole.face_count() / 10);
  for (size_t v = 0; v < less.vertices.size(); ++v) {
    float right = 0;
    for (const Influence& one : less.influences[v]) right += one.joint == 1 ? one.weight : 0;
    EXPECT_NEAR(right, less.vertices[v].x, 1e-4);
  }
  const tinygltf::Model& model = less.gltf->model;
  std::set<float> borders[2];
  ASSERT_EQ(model.meshes[0].primitives.size(), 2u);
  const float middle = static_cast<float>(kSide / 2) / (kSide - 1);
  for (size_t p = 0; p < 2; ++p) {
    const tinygltf::Primitive& primitive = model.meshes[0].primitives[p];
    const std::vector<float> positions = accessor_floats("", model, primitive.attributes.at("POSITION"), 3),
                             uvs = accessor_floats("", model, primitive.attributes.at("TEXCOORD_0"), 2),
                             moves = accessor_floats("", model, primitive.targets.at(0).at("POSITION"), 3);
    for (size_t v = 0; v < positions.size() / 3; ++v) {
      EXPECT_EQ(uvs[2 * v], positions[3 * v]);
      EXPECT_NEAR(moves[3 * v + 2], 1 + positions[3 * v], 1e-6);
      if (std::abs(positions[3 * v] - middle) < 1e-6f) borders[p].insert(positions[3 * v + 1]);
    }
  }
  EXPECT_GE(borders[0].size(), 2u);
  EXPECT_EQ(borders[0], borders[1]) << "no crack";
}

// Every triangle has corners of its own, with its own normal: flat shading, or a file whose corners were never joined.
TEST(ReduceTriangles, SplitCornersAreJoinedFirst) {
  TempFolder folder;
  Character split = waves();
  for (const bool flat : {true, false}) {
    split.corner_normals.clear();
    for (size_t f = 0; f < split.face_count(); ++f)
      for (uint32_t c = split.face_offsets[f]; c < split.face_offsets[f + 1]; ++c) {
        const float tilt = (flat ? 0.6f : 0.05f) * std::sin(static_cast<float>(7 * f));
        split.corner_normals.push_back({tilt, 0, std::sqrt(1 - tilt * tilt)});
        split.corner_uvs[c] = {split.corner_uvs[c][0] + 1e-5f * static_cast<float>(f % 7), split.corner_uvs[c][1]};
      }
    write_gltf(folder.file("split.glb"), split);
    const Character whole = read_gltf(folder.file("split.glb"));
    const std::vector<uint8_t> glb = reduced_glb("split", whole, whole.vertices, 0.2);
    const Character less = read_gltf(folder.write("less.glb", std::string(glb.begin(), glb.end())));
    EXPECT_LT(less.face_count(), whole.face_count() * 3 / 10) << flat;
    for (size_t c = 0; c < less.face_vertices.size(); ++c)
      EXPECT_NEAR(less.corner_uvs[c][0], less.vertices[less.face_vertices[c]].x, 1e-3);
  }
}

#endif

TEST(ReduceTriangles, NeedADocument) {
  Character bare;
  EXPECT_ERROR(reduced_glb("bare", bare, {}, 0.5), "bare", "document");
}

}  // namespace
}  // namespace sinew
