// SPDX-License-Identifier: MIT
// Corrective shapes in a glTF document: targets behind those that were there, in the mesh's own space; drivers; weights over time.
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "gltf_validator.hpp"
#include "make_glb.hpp"
#include "sinew_formats/base/affine.hpp"
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
  MorphTerm one{1, 1, {{}}}, two{0, 1, {{}}};
  for (size_t i = 0; i < 9; ++i) {
    one.factors[0][i] = 0.125 * static_cast<double>(i) - 0.5;
    two.factors[0][i] = 0.75 - 0.25 * static_cast<double>(i);
  }
  morphs.drivers = {{1, {{0, 0, 1}}, {one, two}}};
  return morphs;
}

json written_morphs(const TempFolder& folder, const Character& c, const Morphs& morphs, std::string* glb) {
  GlbOptions options;
  write_gltf_morphs(folder.file("out.glb"), c, options, morphs);
  const std::vector<uint8_t> bytes = read_file(folder.file("out.glb"));
  glb->assign(bytes.begin(), bytes.end());
  return json_of_glb(*glb);
}

// The accessor's elements that are not 0.
std::vector<float> sparse_values(const std::string& glb, const json& document, size_t accessor) {
  const json& sparse = document["accessors"][accessor].at("sparse");
  json dense = {{"accessors", json::array({{{"bufferView", sparse["values"]["bufferView"]},
                                            {"byteOffset", sparse["values"]["byteOffset"]},
                                            {"count", sparse["count"]}}})},
                {"bufferViews", document["bufferViews"]}};
  return values_of<float>(glb, dense, 0, 3);
}

TEST(GltfMorphs, MovesLieInTheMeshsOwnSpace) {
  const TempFolder folder;
  const Character c = read_gltf(folder.write("in.glb", turned_strip().glb()));
  std::string glb;
  const json document = written_morphs(folder, c, knee_shape(7), &glb);
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

Quaternion quaternion(const json& q) { return {q[0], q[1], q[2], q[3]}; }

// formats/spec/correctives.md, by rotations of nodes. Written without morphs.cpp, whose frames are others.
double sum_by_the_file(const json& correctives, const std::map<size_t, Quaternion>& rotations) {
  std::vector<Quaternion> turns;
  for (const json& joint : correctives["joints"]) {
    const Quaternion rest = quaternion(joint["rest"]), axes = quaternion(joint["axes"]);
    const auto at = rotations.find(joint["node"].get<size_t>());
    const Quaternion q = at == rotations.end() ? rest : at->second;
    turns.push_back(multiply(multiply(axes, multiply(q, conjugate(rest))), conjugate(axes)));
  }
  double weight = 0;
  for (const json& term : correctives["bends"][0]["terms"]) {
    const Rotation a = rotation_of(turns[term["turns"][0].get<size_t>()]);
    const Rotation b = rotation_of(turns[term["turns"].back().get<size_t>()]);
    const auto sine_axis = [](const Rotation& r) {
      return std::array<double, 3>{(r[7] - r[5]) / 2, (r[2] - r[6]) / 2, (r[3] - r[1]) / 2};
    };
    for (size_t i = 0; i < 9; ++i)
      weight += term["factors"][0][i].get<double>() *
                (term["turns"].size() == 1 ? a[i] - (i % 4 == 0 ? 1 : 0) : sine_axis(a)[i / 3] * sine_axis(b)[i % 3]);
  }
  return weight;
}

// Turns node 1 (the knee) by 0.7 about its own x after its rest rotation, and asks both.
void expect_the_same_sum(const GlbBuilder& builder) {
  const TempFolder folder;
  const Character c = read_gltf(folder.write("in.glb", builder.glb()));
  Morphs morphs = knee_shape(7);
  std::string glb;
  json document = written_morphs(folder, c, morphs, &glb);
  const json correctives = document["meshes"][0]["extras"]["sinew_correctives"];
  ASSERT_EQ(correctives["joints"].size(), 2u);
  EXPECT_EQ(correctives["joints"][0]["joint"], "knee");
  EXPECT_EQ(correctives["bends"][0]["joint"], "knee");
  EXPECT_EQ(correctives["bends"][0]["targets"], json::array({0}));
  EXPECT_EQ(correctives["bends"][0]["sums"], json::array({0}));
  EXPECT_EQ(correctives["bends"][0]["scales"], json::array({1.0}));
  EXPECT_NEAR(sum_by_the_file(correctives, {}), 0, 1e-9);
  // The same rotations as an animation, whose palette is in world axes.
  GlbBuilder moving = builder;
  std::map<size_t, Quaternion> rotations;
  json channels = json::array(), samplers = json::array();
  for (const json& joint : correctives["joints"]) {
    const size_t node = joint["node"].get<size_t>();
    const Quaternion q = multiply(quaternion(joint["rest"]), axis_rotation(node % 2, 0.7));
    rotations[node] = q;
    std::vector<float> values;
    for (size_t i = 0; i < 8; ++i) values.push_back(static_cast<float>(q[i % 4]));
    const json input = moving.accessor(std::vector<float>{0, 1}, "SCALAR");
    moving.document["accessors"][input.get<size_t>()]["min"] = {0.0};
    moving.document["accessors"][input.get<size_t>()]["max"] = {1.0};
    channels.push_back({{"sampler", samplers.size()}, {"target", {{"node", node}, {"path", "rotation"}}}});
    samplers.push_back({{"input", input}, {"output", moving.accessor(values, "VEC4")}, {"interpolation", "LINEAR"}});
  }
  moving.add("animations", {{"name", "turn"}, {"channels", channels}, {"samplers", samplers}});
  const std::string path = folder.write("moving.glb", moving.glb());
  const OwnMotion own = read_own_motion(path);
  ASSERT_EQ(own.motion.clips.size(), 1u);
  const Character same = read_gltf(path);
  const std::vector<Affine> palette = motion_palette(own.motion, own.motion.clips[0].frames[0], same.joints.size());
  const double sum = driver_sums(morphs.drivers[0], joint_rotations(same.joints, palette))[0];
  EXPECT_GT(std::abs(sum), 0.02);
  EXPECT_NEAR(sum_by_the_file(correctives, rotations), sum, 1e-5);
}

TEST(GltfMorphs, DriversReadRotationsOfNodes) {
  expect_the_same_sum(two_joint_strip());
  expect_the_same_sum(turned_strip());
  GlbBuilder mirrored = turned_strip();
  mirrored.document["nodes"][0]["scale"] = {-2, 2, 2};
  expect_the_same_sum(mirrored);
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
  const json document = written_morphs(folder, c, morphs, &glb);
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
  const json document = written_morphs(folder, c, knee_shape(2), &glb);
  const size_t position = document["meshes"][0]["primitives"][0]["targets"][0]["POSITION"].get<size_t>();
  EXPECT_EQ(sparse_values(glb, document, position), (std::vector<float>{0.25f, 0, 0.5f}));
  SINEW_EXPECT_VALID_GLTF({folder.file("out.glb")});
}

}  // namespace
}  // namespace sinew
