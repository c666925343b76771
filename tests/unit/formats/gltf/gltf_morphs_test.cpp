// SPDX-License-Identifier: MIT
// Corrective shapes in a glTF document: targets behind those that were there, in the mesh's own space; drivers; weights over time.
#include <gtest/gtest.h>

#include <cmath>

#include "gltf_validator.hpp"
#include "make_glb.hpp"
#include "motion/turns.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_formats/morphs.hpp"
#include "temp_folder.hpp"

namespace sinew {
namespace {

using nlohmann::json;

// A strip that skinning puts somewhere else, turned by 90 degrees about z and twice as large.
GlbBuilder turned_strip() {
  GlbBuilder builder = two_joint_strip();
  builder.document["nodes"][0]["rotation"] = {0, 0, std::sqrt(0.5), std::sqrt(0.5)};
  builder.document["nodes"][0]["scale"] = {2, 2, 2};
  builder.document["skins"][0].erase("inverseBindMatrices");
  return builder;
}

Morphs knee_shape(uint32_t vertex) {
  Morphs morphs;
  morphs.shapes = {{"knee.1", {vertex}, {{0.25f, 0, 0.5f}}}};
  morphs.drivers = {{1, 1.5, {axis_turn(0, 1)}, {0}}};
  return morphs;
}

json written(const TempFolder& folder, const Character& c, const Morphs& morphs, std::string* glb) {
  GlbOptions options;
  write_gltf_morphs(folder.file("out.glb"), c, options, morphs);
  const std::vector<uint8_t> bytes = read_file(folder.file("out.glb"));
  glb->assign(bytes.begin(), bytes.end());
  return json_of_glb(*glb);
}

// The accessor's elements that are not 0.
std::vector<float> sparse_values(const std::string& glb, const json& document, size_t accessor) {
  const json& sparse = document["accessors"][accessor].at("sparse");
  json dense = {
      {"accessors", json::array({{{"bufferView", sparse["values"]["bufferView"]}, {"count", sparse["count"]}}})},
      {"bufferViews", document["bufferViews"]}};
  return values_of<float>(glb, dense, 0, 3);
}

TEST(GltfMorphs, MovesLieInTheMeshsOwnSpace) {
  const TempFolder folder;
  const Character c = read_gltf(folder.write("in.glb", turned_strip().glb()));
  std::string glb;
  const json document = written(folder, c, knee_shape(7), &glb);
  const json& mesh = document["meshes"][0];
  ASSERT_EQ(mesh["primitives"][0]["targets"].size(), 1u);
  const size_t position = mesh["primitives"][0]["targets"][0]["POSITION"].get<size_t>();
  EXPECT_EQ(document["accessors"][position]["count"], 10);
  EXPECT_EQ(document["accessors"][position]["sparse"]["count"], 1);
  const std::vector<float> move = sparse_values(glb, document, position);
  EXPECT_NEAR(move[0], 0, 1e-6);  // world (0.25, 0, 0.5) turned back by 90 degrees and halved
  EXPECT_NEAR(move[1], -0.125, 1e-6);
  EXPECT_NEAR(move[2], 0.25, 1e-6);
  EXPECT_TRUE(mesh["primitives"][0]["targets"][0].contains("NORMAL"));
  EXPECT_EQ(mesh["weights"], json::array({0.0}));
  EXPECT_EQ(mesh["extras"]["targetNames"], json::array({"knee.1"}));
  SINEW_EXPECT_VALID_GLTF({folder.file("out.glb")});
}

TEST(GltfMorphs, DriversAreRotationsOfTheJointsNode) {
  const TempFolder folder;
  const Character c = read_gltf(folder.write("in.glb", turned_strip().glb()));
  std::string glb;
  const json document = written(folder, c, knee_shape(7), &glb);
  const json& driver = document["meshes"][0]["extras"]["sinew_correctives"][0];
  EXPECT_EQ(driver["joint"], "knee");
  EXPECT_EQ(driver["targets"], json::array({0}));
  EXPECT_EQ(driver["falloff"], 1.5);
  const auto quaternion = [](const json& q) { return Quaternion{q[0], q[1], q[2], q[3]}; };
  EXPECT_NEAR(std::abs(dot(quaternion(driver["rest"]), kNoTurn4)), 1, 1e-7);
  // About the world's x; below a node turned by 90 degrees about z that is the node's own -y.
  EXPECT_NEAR(std::abs(dot(quaternion(driver["rotations"][0]), axis_turn(1, -1))), 1, 1e-7);
}

TEST(GltfMorphs, TargetsAndTheirAnimationsStay) {
  const TempFolder folder;
  GlbBuilder builder = two_joint_strip();
  json& primitive = builder.document["meshes"][0]["primitives"][0];
  primitive["targets"] = json::array({{{"POSITION", builder.positions(std::vector<float>(30, 0.25f))}}});
  builder.document["meshes"][0]["weights"] = {0.5};
  const json sampler = {{"input", builder.accessor(std::vector<float>{0, 1}, "SCALAR")},
                        {"output", builder.accessor(std::vector<float>{0, 1}, "SCALAR")},
                        {"interpolation", "LINEAR"}};
  builder.document["accessors"][sampler["input"].get<size_t>()]["min"] = {0.0};
  builder.document["accessors"][sampler["input"].get<size_t>()]["max"] = {1.0};
  builder.add("animations", {{"name", "smile"},
                             {"channels", {{{"sampler", 0}, {"target", {{"node", 2}, {"path", "weights"}}}}}},
                             {"samplers", json::array({sampler})}});
  const Character c = read_gltf(folder.write("in.glb", builder.glb()));
  Morphs morphs = knee_shape(7);
  MorphClip clip;
  clip.frame_time = 0.5;
  clip.weights = {{0}, {0.5f}, {0.75f}};
  morphs.clips = {clip};
  std::string glb;
  const json document = written(folder, c, morphs, &glb);
  EXPECT_EQ(document["meshes"][0]["primitives"][0]["targets"].size(), 2u);
  EXPECT_EQ(document["meshes"][0]["weights"], json::array({0.5, 0.0}));
  EXPECT_EQ(document["meshes"][0]["extras"]["targetNames"], json::array({"target_0", "knee.1"}));
  const json& animation = document["animations"][0];
  ASSERT_EQ(animation["channels"].size(), 1u);
  const json& kept = animation["samplers"][animation["channels"][0]["sampler"].get<size_t>()];
  EXPECT_EQ(values_of<float>(glb, document, kept["input"], 1), (std::vector<float>{0, 0.5f, 1}));
  EXPECT_EQ(values_of<float>(glb, document, kept["output"], 1), (std::vector<float>{0, 0, 0.5f, 0.5f, 1, 0.75f}));
  SINEW_EXPECT_VALID_GLTF({folder.file("out.glb")});
}

TEST(GltfMorphs, AMeshFromAnObjGetsThemToo) {
  const TempFolder folder;
  Character c = read_obj(folder.write("in.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n"));
  c.joints = {{"a", {0, 0, 0}, -1}, {"knee", {0, 0.5f, 0}, 0}};
  c.influences.assign(4, {{0, 0.5f}, {1, 0.5f}});
  std::string glb;
  const json document = written(folder, c, knee_shape(2), &glb);
  const size_t position = document["meshes"][0]["primitives"][0]["targets"][0]["POSITION"].get<size_t>();
  EXPECT_EQ(sparse_values(glb, document, position), (std::vector<float>{0.25f, 0, 0.5f}));
  SINEW_EXPECT_VALID_GLTF({folder.file("out.glb")});
}

}  // namespace
}  // namespace sinew
