// SPDX-License-Identifier: MIT
// glTF in and out: every form of accessor, skins, rigid parts, seams, what the writer keeps and what it puts in, what
// is refused.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "expect_error.hpp"
#include "make_glb.hpp"
#include "sinew_datasets/dataset.hpp"
#include "sinew_formats/io.hpp"
#include "temp_folder.hpp"

using namespace sinew;
using nlohmann::json;

namespace {

Character read(const GlbBuilder& builder) {
  const TempFolder folder;
  return read_gltf(folder.write("cat.glb", builder.glb()));
}

std::string written(const Character& character, const GlbOptions& options = {}) {
  const TempFolder folder;
  write_glb(folder.file("out.glb"), character, options);
  return folder.text_of("out.glb");
}

Character reread(const std::string& glb) {
  const TempFolder folder;
  return read_gltf(folder.write("again.glb", glb));
}

std::map<uint32_t, float> row(const Character& c, size_t v) {
  std::map<uint32_t, float> out;
  for (const Influence& i : c.influences[v]) out[i.joint] += i.weight;
  return out;
}

json& attributes(GlbBuilder* builder) { return builder->document["meshes"][0]["primitives"][0]["attributes"]; }

TEST(GltfRead, SkinMovesVerticesToWhereTheirJointsAre) {
  const Character c = read(two_joint_strip());
  ASSERT_EQ(c.joints.size(), 2u);
  EXPECT_EQ(c.joints[1].name, "knee");
  EXPECT_EQ(c.joints[1].parent, 0);
  EXPECT_EQ(c.joints[1].position.x, 10);
  EXPECT_EQ(c.joints[1].position.y, 2);
  ASSERT_EQ(c.vertices.size(), 10u);
  EXPECT_EQ(c.face_count(), 8u);
  for (size_t v = 0; v < 10; ++v) {
    EXPECT_NEAR(c.vertices[v].x, 10.0f + static_cast<float>(v % 2), 1e-6);
    EXPECT_NEAR(c.vertices[v].y, static_cast<float>(v / 2), 1e-6);
  }
  EXPECT_NEAR(row(c, 2)[1], 0.25f, 1e-6);
  EXPECT_EQ(c.corner_uvs.size(), c.face_vertices.size());
  EXPECT_EQ(c.corner_normals[0].z, 1);
}

TEST(GltfRead, PosedJointsMoveTheMesh) {
  GlbBuilder builder = two_joint_strip();
  builder.document["nodes"][1]["rotation"] = {0, 0, std::sqrt(0.5), std::sqrt(0.5)};  // knee by 90 degrees about Z
  const Character c = read(builder);
  // The top vertex (0, 4) belongs to the knee alone: 2 above it, now 2 to its left.
  EXPECT_NEAR(c.vertices[8].x, 8, 1e-5);
  EXPECT_NEAR(c.vertices[8].y, 2, 1e-5);
}

TEST(GltfRead, SeamsAreWeldedAndWrittenBackApart) {
  const Character c = read(two_joint_strip(true));
  EXPECT_EQ(c.vertices.size(), 10u);
  const std::string glb = written(c);
  const json out = json_of_glb(glb);
  const json& attributes_out = out["meshes"][0]["primitives"][0]["attributes"];
  EXPECT_EQ(out["accessors"][attributes_out["POSITION"].get<size_t>()]["count"], 12);
  const std::vector<float> uvs = values_of<float>(glb, out, attributes_out["TEXCOORD_0"].get<int>(), 2);
  EXPECT_EQ(uvs[20], 0.5f);
  EXPECT_EQ(uvs[22], 0.75f);
  const auto weights = values_of<uint16_t>(glb, out, attributes_out["WEIGHTS_0"].get<int>(), 4);
  for (size_t k = 0; k < 4; ++k) EXPECT_EQ(weights[10 * 4 + k], weights[4 * 4 + k]);  // both sides of the seam
}

TEST(GltfRead, SamePositionWithOtherWeightsStaysApart) {
  GlbBuilder builder = two_joint_strip(true);
  const int weights = attributes(&builder)["WEIGHTS_0"];
  const size_t offset =
      builder.document["bufferViews"][builder.document["accessors"][static_cast<size_t>(weights)]["bufferView"]
                                          .get<size_t>()]["byteOffset"];
  const float other[2] = {0.75f, 0.25f};
  std::memcpy(&builder.bytes[offset + 10 * 16], other, sizeof other);
  EXPECT_EQ(read(builder).vertices.size(), 11u);
}

TEST(GltfRead, WeightsOfEveryTypeAndWideJoints) {
  GlbBuilder builder = two_joint_strip();
  std::vector<uint8_t> bytes;
  std::vector<uint16_t> words, joints;
  for (int v = 0; v < 10; ++v) {
    const int y = v / 2;
    bytes.insert(bytes.end(), {static_cast<uint8_t>(255 - y * 51), static_cast<uint8_t>(y * 51), 0, 0});
    words.insert(words.end(), {static_cast<uint16_t>(65535 - y * 13107), static_cast<uint16_t>(y * 13107), 0, 0});
    joints.insert(joints.end(), {0, 1, 900, 7});  // joints of no weight may be anything
  }
  attributes(&builder)["JOINTS_0"] = builder.accessor(joints, "VEC4");
  attributes(&builder)["WEIGHTS_0"] = builder.accessor(bytes, "VEC4", true);
  EXPECT_NEAR(row(read(builder), 6)[1], 0.6f, 1e-6);
  attributes(&builder)["WEIGHTS_0"] = builder.accessor(words, "VEC4", true);
  EXPECT_NEAR(row(read(builder), 6)[1], 0.6f, 1e-6);
}

TEST(GltfRead, SecondSetOfWeightsAndRepeatedJoints) {
  GlbBuilder builder = two_joint_strip();
  std::vector<uint8_t> joints;
  std::vector<float> first, second;
  for (int v = 0; v < 10; ++v) {
    joints.insert(joints.end(), {0, 1, 0, 1});
    first.insert(first.end(), {0.25f, 0.25f, 0.25f, 0});
    second.insert(second.end(), {0.125f, 0.125f, 0, 0});
  }
  attributes(&builder)["JOINTS_0"] = attributes(&builder)["JOINTS_1"] = builder.accessor(joints, "VEC4");
  attributes(&builder)["WEIGHTS_0"] = builder.accessor(first, "VEC4");
  attributes(&builder)["WEIGHTS_1"] = builder.accessor(second, "VEC4");
  const Character c = read(builder);
  EXPECT_EQ(c.influences[3].size(), 2u);
  EXPECT_NEAR(row(c, 3)[0], 0.625f, 1e-6);
  EXPECT_NEAR(row(c, 3)[1], 0.375f, 1e-6);
}

TEST(GltfRead, ANodeListedTwiceIsOneJoint) {
  GlbBuilder builder = two_joint_strip();
  const auto knee = builder.document["skins"][0]["joints"][1];
  builder.document["skins"][0]["joints"] = {knee, knee};
  builder.document["skins"][0].erase("inverseBindMatrices");
  const Character c = read(builder);
  ASSERT_EQ(c.joints.size(), 1u);
  for (const auto& influences : c.influences) {
    ASSERT_EQ(influences.size(), 1u);
    EXPECT_NEAR(influences[0].weight, 1, 1e-6);
  }
}

TEST(GltfRead, SparseAccessors) {
  GlbBuilder builder = two_joint_strip();
  json& position = builder.document["accessors"][attributes(&builder)["POSITION"].get<size_t>()];
  const int indices = builder.view(std::vector<uint16_t>{1, 9}),
            values = builder.view(std::vector<float>{5, 0, 0, 6, 4, 0});
  position["sparse"] = {{"count", 2},
                        {"indices", {{"bufferView", indices}, {"componentType", 5123}}},
                        {"values", {{"bufferView", values}}}};
  EXPECT_EQ(read(builder).vertices[9].x, 16);
  EXPECT_EQ(read(builder).vertices[1].x, 15);
  position.erase("bufferView");  // zeros, but for the sparse ones
  const Character c = read(builder);
  EXPECT_EQ(c.vertices[0].x, 10);
  EXPECT_EQ(c.vertices[1].x, 15);
  builder.bytes[builder.document["bufferViews"][static_cast<size_t>(indices)]["byteOffset"].get<size_t>()] = 10;
  EXPECT_ERROR(read(builder), "cat.glb", "POSITION", "sparse indices below 10", "found 10");
}

TEST(GltfRead, StripsFansAndNoIndices) {
  GlbBuilder builder;
  builder.add("meshes",
              {{"primitives",
                json::array({{{"attributes", {{"POSITION", builder.positions({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0})}}},
                              {"mode", 5}}})}});
  builder.root({{"mesh", 0}, {"translation", {0, 0, 3}}});
  EXPECT_EQ(read(builder).face_vertices, (std::vector<uint32_t>{0, 1, 2, 1, 3, 2}));
  EXPECT_EQ(read(builder).vertices[0].z, 3);
  EXPECT_TRUE(read(builder).influences.empty());
  builder.document["meshes"][0]["primitives"][0]["mode"] = 6;
  EXPECT_EQ(read(builder).face_vertices, (std::vector<uint32_t>{0, 1, 2, 0, 2, 3}));
  builder.document["meshes"][0]["primitives"][0]["mode"] = 1;
  EXPECT_ERROR(read(builder), "mesh 0", "primitive 0", "lines");
  builder.document["meshes"][0]["primitives"][0]["mode"] = 4;
  EXPECT_ERROR(read(builder), "threes", "found 4");
}

// A lamp hangs on the knee without a skin; a stone lies beside the character.
GlbBuilder with_parts() {
  GlbBuilder builder = two_joint_strip();
  const int triangle = builder.positions({0, 0, 0, 1, 0, 0, 0, 1, 0});
  const json primitive = {{"attributes", {{"POSITION", triangle}}}};
  builder.add("meshes", {{"name", "shared"}, {"primitives", json::array({primitive})}});
  const int lamp =
      builder.add("nodes", {{"name", "lamp"}, {"mesh", 1}, {"translation", {0, 0, 1}}, {"scale", {2, 2, 2}}});
  builder.document["nodes"][1]["children"] = {lamp};
  builder.root({{"name", "stone"}, {"mesh", 1}, {"translation", {-5, 0, 0}}});
  return builder;
}

TEST(GltfRead, RigidPartsFollowTheirJointAndStrangersAreUnbound) {
  const Character c = read(with_parts());
  ASSERT_EQ(c.vertices.size(), 16u);
  EXPECT_EQ(c.group_names, (std::vector<std::string>{"body", "lamp", "stone"}));
  EXPECT_EQ(c.vertices[11].x, 12);  // 10 + 1 x 2
  EXPECT_EQ(c.vertices[11].y, 2);
  EXPECT_EQ(c.vertices[11].z, 1);
  EXPECT_EQ(row(c, 11), (std::map<uint32_t, float>{{1, 1.0f}}));
  EXPECT_EQ(c.vertices[13].x, -5);
  EXPECT_TRUE(c.influences[13].empty());
}

TEST(GltfWrite, RigidPartsAndStrangersStayAsTheyAre) {
  const Character c = read(with_parts());
  const json out = json_of_glb(written(c));
  EXPECT_EQ(out["nodes"][3], with_parts().document["nodes"][3]);
  EXPECT_EQ(out["nodes"][4], with_parts().document["nodes"][4]);
  EXPECT_EQ(out["nodes"][2]["skin"], 0);
}

TEST(GltfWrite, ARigidPartThatGetsOtherWeightsGetsASkinAndStaysInPlace) {
  Character c = read(with_parts());
  c.influences[11] = {{0, 0.5f}, {1, 0.5f}};
  const std::string glb = written(c);
  const json out = json_of_glb(glb);
  EXPECT_TRUE(out["nodes"][3].contains("skin"));
  EXPECT_FALSE(out["nodes"][4].contains("skin"));  // the stone shares the mesh of the lamp and must not
  EXPECT_NE(out["nodes"][3]["mesh"], out["nodes"][4]["mesh"]);
  EXPECT_FALSE(out["nodes"][1].contains("children"));
  const Character again = reread(glb);
  ASSERT_EQ(again.vertices.size(), c.vertices.size());
  for (size_t v = 0; v < c.vertices.size(); ++v) {
    float nearest = 1e9f;
    for (size_t w = 0; w < again.vertices.size(); ++w) {
      const float d = std::fabs(again.vertices[w].x - c.vertices[v].x) +
                      std::fabs(again.vertices[w].y - c.vertices[v].y) +
                      std::fabs(again.vertices[w].z - c.vertices[v].z);
      nearest = std::min(nearest, d);
    }
    EXPECT_LT(nearest, 1e-5f) << v;
  }
}

TEST(GltfWrite, TheDocumentComesBackWithOnlyTheSkinChanged) {
  GlbBuilder builder = two_joint_strip(true);
  json& primitive = builder.document["meshes"][0]["primitives"][0];
  primitive["attributes"]["COLOR_0"] = builder.accessor(std::vector<uint8_t>(12 * 4, 77), "VEC4", true);
  primitive["targets"] = json::array({{{"POSITION", builder.positions(std::vector<float>(36, 0.25f))}}});
  primitive["material"] = 0;
  builder.document["meshes"][0]["extras"] = {{"targetNames", {"smile"}}, {"nothing", nullptr}};
  builder.add("materials", {{"name", "skin"},
                            {"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}, {"metallicFactor", 0}}}});
  builder.add("textures", {{"source", 0}, {"sampler", 0}});
  builder.add("samplers", {{"name", "nearest"}, {"magFilter", 9728}});
  const std::string png = "\x89PNG\r\n\x1a\n....picture";
  builder.add("images",
              {{"mimeType", "image/png"}, {"bufferView", builder.view(std::vector<char>(png.begin(), png.end()))}});
  builder.add(
      "animations",
      {{"name", "wave"},
       {"channels", json::array({{{"sampler", 0}, {"target", {{"node", 1}, {"path", "translation"}}}}})},
       {"samplers", json::array({{{"input", builder.accessor(std::vector<float>{0, 1}, "SCALAR")},
                                  {"output", builder.accessor(std::vector<float>{0, 2, 0, 0, 3, 0}, "VEC3")}}})}});
  builder.document["extensionsUsed"] = {"VRM"};
  builder.document["extensions"]["VRM"] = {
      {"meta", json::object()}, {"firstPerson", {{"meshAnnotations", json::array()}}}, {"big", 1234567890123}};
  builder.document["nodes"][0]["extras"] = {{"empty", json::array()}};

  Character c = read(builder);
  for (auto& weights : c.influences) weights = {{1, 0.3f}, {0, 0.7f}};
  const std::string glb = written(c);
  json out = json_of_glb(glb);
  for (const char* key : {"nodes", "scenes", "materials", "textures", "samplers", "extensions", "extensionsUsed"})
    EXPECT_EQ(out[key], builder.document[key]) << key;
  EXPECT_EQ(out["animations"][0]["channels"], builder.document["animations"][0]["channels"]);
  EXPECT_EQ(out["meshes"][0]["extras"], builder.document["meshes"][0]["extras"]);
  EXPECT_EQ(out["skins"][0]["joints"], builder.document["skins"][0]["joints"]);
  EXPECT_EQ(out["accessors"].size(), builder.document["accessors"].size());  // old weights and joints are gone

  const std::string source = builder.glb();
  const json in = json_of_glb(source);
  const json &a = in["meshes"][0]["primitives"][0]["attributes"], &b = out["meshes"][0]["primitives"][0]["attributes"];
  for (const char* name : {"POSITION", "NORMAL"})
    EXPECT_EQ(values_of<float>(source, in, a[name], 3), values_of<float>(glb, out, b[name], 3)) << name;
  EXPECT_EQ(values_of<float>(source, in, a["TEXCOORD_0"], 2), values_of<float>(glb, out, b["TEXCOORD_0"], 2));
  EXPECT_EQ(values_of<uint8_t>(source, in, a["COLOR_0"], 4), values_of<uint8_t>(glb, out, b["COLOR_0"], 4));
  EXPECT_EQ(values_of<float>(source, in, in["skins"][0]["inverseBindMatrices"], 16),
            values_of<float>(glb, out, out["skins"][0]["inverseBindMatrices"], 16));
  const json& view = out["bufferViews"][out["images"][0]["bufferView"].get<size_t>()];
  uint32_t length = 0;
  std::memcpy(&length, glb.data() + 12, 4);
  EXPECT_EQ(glb.substr(28 + length + view["byteOffset"].get<size_t>(), view["byteLength"].get<size_t>()), png);
  for (const json& accessor : out["accessors"])  // the picture's odd length must not shift what follows it
    EXPECT_EQ(out["bufferViews"][accessor["bufferView"].get<size_t>()].value("byteOffset", 0) % 4, 0);
  EXPECT_EQ(values_of<float>(glb, out, out["animations"][0]["samplers"][0]["output"], 3),
            (std::vector<float>{0, 2, 0, 0, 3, 0}));
  const auto weights = values_of<uint16_t>(glb, out, b["WEIGHTS_0"], 4);
  EXPECT_EQ(weights[0], 45875);  // 0.7 of 65535 and the remainder
  EXPECT_EQ(weights[1], 19660);
}

TEST(GltfWrite, OldWeightsThatAnotherMeshUsesStay) {
  GlbBuilder builder = two_joint_strip();
  builder.add("meshes", builder.document["meshes"][0]);
  builder.root({{"name", "statue"}, {"mesh", 1}, {"translation", {50, 0, 0}}});  // same accessors, no skin
  const std::string glb = written(read(builder));
  const json out = json_of_glb(glb);
  const json& statue = out["meshes"][1]["primitives"][0]["attributes"];
  EXPECT_NE(statue["WEIGHTS_0"], out["meshes"][0]["primitives"][0]["attributes"]["WEIGHTS_0"]);
  EXPECT_EQ(values_of<float>(glb, out, statue["WEIGHTS_0"], 4)[13], 0.25f);
}

TEST(GltfWrite, WeightsSumExactlyAreSortedAndUnique) {
  Character c = read(two_joint_strip());
  for (int j = 0; j < 9; ++j) c.joints.push_back({"extra" + std::to_string(j), {static_cast<float>(j), 1, 2}, 0});
  c.influences[0] = {{3, 0.1f}, {4, 0.1f}, {3, 0.1f}, {5, 0.2f}, {6, 1e-9f}, {7, 0.3f}, {2, 0.2f}};
  c.influences[1] = {};                                             // unbound in a bound mesh
  c.influences[2] = {{0, 1.0f / 3}, {1, 1.0f / 3}, {2, 1.0f / 3}};  // does not divide
  c.influences[3] = {{1, 7}, {0, 7}};                               // any scale
  for (const bool unorm8 : {false, true}) {
    const std::string glb = written(c, {unorm8});
    const json out = json_of_glb(glb);
    const json& at = out["meshes"][0]["primitives"][0]["attributes"];
    ASSERT_TRUE(at.contains("WEIGHTS_1"));
    ASSERT_FALSE(at.contains("WEIGHTS_2"));
    std::vector<std::vector<uint32_t>> weights(10), joints(10);
    for (int set = 0; set < 2; ++set) {
      const int w = at["WEIGHTS_" + std::to_string(set)], j = at["JOINTS_" + std::to_string(set)];
      EXPECT_EQ(out["accessors"][static_cast<size_t>(w)]["normalized"], true);
      const auto js = values_of<uint8_t>(glb, out, j, 4);
      if (unorm8) {
        const auto ws = values_of<uint8_t>(glb, out, w, 4);
        for (size_t i = 0; i < 40; ++i) weights[i / 4].push_back(ws[i]);
      } else {
        const auto ws = values_of<uint16_t>(glb, out, w, 4);
        for (size_t i = 0; i < 40; ++i) weights[i / 4].push_back(ws[i]);
      }
      for (size_t i = 0; i < 40; ++i) joints[i / 4].push_back(js[i]);
    }
    for (size_t v = 0; v < 10; ++v) {
      uint32_t sum = 0;
      std::map<uint32_t, int> seen;
      for (size_t k = 0; k < 8; ++k) {
        sum += weights[v][k];
        EXPECT_LE(weights[v][k], weights[v][k > 0 ? k - 1 : 0]);
        if (weights[v][k] == 0) {
          EXPECT_EQ(joints[v][k], 0u);
        } else {
          EXPECT_EQ(seen[joints[v][k]]++, 0);
        }
      }
      EXPECT_EQ(sum, unorm8 ? 255u : 65535u) << v;
    }
    EXPECT_EQ(weights[0][5], 0u);  // 1e-9 is no influence
    EXPECT_EQ(joints[1][0], 0u);   // the root takes unbound vertices
    EXPECT_EQ(weights[2][0] - weights[2][1], 0u);
  }
}

TEST(GltfWrite, UnormWeightsSurviveAnyNumberOfRounds) {
  Character c = read(two_joint_strip());
  c.influences[0] = {{0, 0.123456f}, {1, 0.876544f}};
  const std::string once = written(c), twice = written(reread(once));
  EXPECT_EQ(once, twice);
}

TEST(GltfWrite, AnotherSkeletonBecomesNodesAndASkin) {
  const TempFolder folder;
  Character c = read(two_joint_strip());
  read_skeleton(
      folder.write("new.rig.txt", "joints a 10 0 0\njoints b 10.5 3 0\njoints prop 0 0 0\nroot a\nhier a b\n"), false,
      &c);
  c.influences.assign(c.vertices.size(), {{1, 0.5f}, {0, 0.5f}});
  c.influences[0] = {{2, 1.0f}};
  const std::string glb = written(c);
  const json out = json_of_glb(glb);
  EXPECT_EQ(out["skins"].size(), 1u);
  const Character again = reread(glb);
  ASSERT_EQ(again.joints.size(), 3u);
  EXPECT_EQ(again.joints[1].name, "b");
  EXPECT_EQ(again.joints[1].parent, 0);
  EXPECT_EQ(again.joints[2].parent, -1);
  EXPECT_NEAR(again.joints[1].position.y, 3, 1e-6);
  for (size_t v = 0; v < c.vertices.size(); ++v) {
    EXPECT_NEAR(again.vertices[v].x, c.vertices[v].x, 1e-5);
    EXPECT_NEAR(again.vertices[v].y, c.vertices[v].y, 1e-5);
  }
}

TEST(GltfWrite, AnotherSkeletonOnAPosedMeshKeepsThePose) {
  const TempFolder folder;
  GlbBuilder builder = two_joint_strip();
  builder.document["nodes"][1]["rotation"] = {0, 0, std::sqrt(0.5), std::sqrt(0.5)};
  Character c = read(builder);
  read_skeleton(folder.write("new.rig.txt", "joints a 10 0 0\nroot a\n"), false, &c);
  c.influences.assign(c.vertices.size(), {{0, 1.0f}});
  const Character again = reread(written(c));
  for (size_t v = 0; v < c.vertices.size(); ++v) {
    EXPECT_NEAR(again.vertices[v].x, c.vertices[v].x, 1e-5);
    EXPECT_NEAR(again.vertices[v].y, c.vertices[v].y, 1e-5);
    EXPECT_NEAR(again.corner_normals[v].x * again.corner_normals[v].x +
                    again.corner_normals[v].y * again.corner_normals[v].y +
                    again.corner_normals[v].z * again.corner_normals[v].z,
                1, 1e-5);
  }
}

TEST(GltfWrite, ObjWithMaterialsUvsAndNormals) {
  const TempFolder folder;
  Character c = read_obj(folder.write("box.obj",
                                      "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0.5 2 0\nvt 0 0\nvt 1 0.25\nvn 0 0 0\n"
                                      "usemtl red\nf 1/1/1 2/2/1 3/1/1 4/2/1\nusemtl blue\nf 4/1 3/2 5/1\n"));
  c.joints = {{"root", {0, 0, 0}, -1}, {"tip", {0, 1, 0}, 0}};
  c.influences.assign(5, {{0, 0.25f}, {1, 0.75f}});
  const std::string glb = written(c);
  const json out = json_of_glb(glb);
  EXPECT_EQ(out["asset"]["generator"], "sinew");
  ASSERT_EQ(out["meshes"][0]["primitives"].size(), 2u);
  EXPECT_EQ(out["materials"][0]["name"], "red");
  const Character again = reread(glb);
  EXPECT_EQ(again.vertices.size(), 5u);
  EXPECT_EQ(again.face_vertices, (std::vector<uint32_t>{0, 1, 2, 0, 2, 3, 3, 2, 4}));
  EXPECT_EQ(again.corner_uvs[1], (std::array<float, 2>{1, 0.25f}));
  EXPECT_EQ(again.material_names, c.material_names);
  EXPECT_NEAR(again.corner_normals[0].z, 1, 1e-6);
  EXPECT_EQ(again.joints[1].parent, 0);
  EXPECT_NEAR(row(again, 2)[1], 0.75f, 2e-5);
}

TEST(GltfWrite, JointsWithoutWeightsAreStillNodes) {
  const TempFolder folder;
  Character c = read_obj(folder.write("t.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"));
  c.joints = {{"a", {0, 0, 0}, -1}};
  const json out = json_of_glb(written(c));
  EXPECT_EQ(out["nodes"][1]["name"], "a");
  EXPECT_FALSE(out.contains("skins"));
}

TEST(GltfWrite, RefusesBrokenCharacters) {
  const TempFolder folder;
  Character c = read(two_joint_strip());
  c.influences[4][0].joint = 5;
  EXPECT_ERROR(write_glb(folder.file("o.glb"), c), "o.glb", "vertex 4", "joint 5 of 2");
  c.influences[4][0] = {0, std::nanf("")};
  EXPECT_ERROR(write_glb(folder.file("o.glb"), c), "vertex 4", "finite");
  c.influences.resize(3);
  EXPECT_ERROR(write_glb(folder.file("o.glb"), c), "10 vertices", "found 3");
  c = read_obj(folder.write("t.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"));
  c.joints = {{"a", {}, 1}, {"b", {}, 0}};
  c.influences.assign(3, {{0, 1.0f}});
  EXPECT_ERROR(write_glb(folder.file("o.glb"), c), "cycle");
  EXPECT_EQ(folder.file_count(), 1u);
}

TEST(GltfRead, TextFormWithDataUriAndExternalFiles) {
  const TempFolder folder;
  GlbBuilder builder = two_joint_strip();
  folder.write("my data.bin", builder.bytes);
  builder.document["buffers"] = {{{"byteLength", builder.bytes.size()}, {"uri", "my%20data.bin"}}};
  folder.write("face.png", "\x89PNG\r\n\x1a\n....picture");
  builder.add("images", {{"uri", "face.png"}});
  builder.add("images", {{"uri", "not there.png"}});
  Character c = read_gltf(folder.write("cat.gltf", builder.document.dump()));
  EXPECT_EQ(c.vertices.size(), 10u);
  const json out = json_of_glb(written(c));
  EXPECT_FALSE(out["images"][0].contains("uri"));
  EXPECT_EQ(out["images"][0]["mimeType"], "image/png");
  EXPECT_EQ(out["images"][1]["uri"], "not there.png");
  EXPECT_FALSE(out["buffers"][0].contains("uri"));
}

TEST(GltfRead, AFileNameIsNeverRunByTheShell) {
  const TempFolder folder;
  GlbBuilder builder = two_joint_strip();
  builder.document["buffers"] = {
      {{"byteLength", builder.bytes.size()}, {"uri", "$(touch " + folder.file("owned") + ").bin"}}};
  EXPECT_ERROR(read_gltf(folder.write("cat.gltf", builder.document.dump())), "cat.gltf");
  EXPECT_FALSE(std::filesystem::exists(folder.file("owned")));
}

TEST(GltfRead, SkeletonOfAFileWithoutMesh) {
  const TempFolder folder;
  GlbBuilder builder = two_joint_strip();
  builder.document.erase("meshes");
  builder.document["nodes"][2] = {{"name", "body"}};
  Character c = read_obj(folder.write("t.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"));
  read_skeleton(folder.write("bones.glb", builder.glb()), false, &c);
  EXPECT_EQ(c.joints.size(), 2u);
  EXPECT_ERROR(read_mesh(folder.file("bones.glb")), "bones.glb", "mesh");
}

TEST(GltfRead, JointNamesBecomeUnique) {
  GlbBuilder builder = two_joint_strip();
  builder.document["nodes"][1]["name"] = "hip";
  EXPECT_EQ(read(builder).joints[1].name, "hip_2");
  builder.document["nodes"][0].erase("name");
  EXPECT_EQ(read(builder).joints[0].name, "joint_0");
}

TEST(GltfRead, ErrorsNameFileAndElement) {
  const TempFolder folder;
  const auto text = [&](const std::string& bytes) { return read_gltf(folder.write("bad.glb", bytes)); };
  EXPECT_ERROR(text(""), "bad.glb", "empty");
  EXPECT_ERROR(text("rubbish"), "bad.glb", "does not parse");
  EXPECT_ERROR(text("\xff\x01rubbish"), "does not parse: parse error at line 1", "last read: '?'");
  EXPECT_ERROR(text("{\"asset\": {\"version\": \"2.0\"}}"), "bad.glb", "mesh");
  EXPECT_ERROR(text(std::string("glTF\1\0\0\0", 8) + std::string(20, '\0')), "bad.glb", "version 2", "version 1");
  const std::string whole = two_joint_strip().glb();
  EXPECT_ERROR(text(whole.substr(0, whole.size() - 8)), "bad.glb", "truncated");
  EXPECT_ERROR(read_gltf(folder.path()), "directory");

  GlbBuilder builder = two_joint_strip();
  builder.document["extensionsRequired"] = builder.document["extensionsUsed"] = {"KHR_draco_mesh_compression"};
  EXPECT_ERROR(read(builder), "KHR_draco_mesh_compression", "decode");
  builder.document["extensionsRequired"] = {"EXT_meshopt_compression"};
  EXPECT_ERROR(read(builder), "EXT_meshopt_compression");

  builder = two_joint_strip();
  attributes(&builder)["JOINTS_0"] = builder.accessor(std::vector<uint8_t>(40, 2), "VEC4");
  EXPECT_ERROR(read(builder), "mesh 0 'strip'", "primitive 0", "vertex 0", "joints below 2", "found 2");
  builder = two_joint_strip();
  attributes(&builder)["WEIGHTS_0"] = builder.accessor(std::vector<float>(40, -0.5f), "VEC4");
  EXPECT_ERROR(read(builder), "vertex 0", "weights of 0 or more");
  builder = two_joint_strip();
  attributes(&builder)["WEIGHTS_0"] = builder.accessor(std::vector<float>(40, std::nanf("")), "VEC4");
  EXPECT_ERROR(read(builder), "WEIGHTS_0", "finite", "element 0");
  builder = two_joint_strip();
  builder.document["nodes"].back()["skin"] = 7.5;
  EXPECT_ERROR(read(builder), "whole number for 'skin'", "found 7.5");
  builder = two_joint_strip();
  attributes(&builder)["_CURVATURE"] = 1e80;
  EXPECT_ERROR(read(builder), "whole number for 'attributes'", "1e+80");
  builder = two_joint_strip();
  builder.document["nodes"][1]["extras"] = {{"count", 1.5}};
  EXPECT_NO_THROW((void)read(builder));
  for (const double far : {1e59, 1e308}) {  // finite for double, whose product with the parent's is not in the end
    builder = two_joint_strip();
    builder.document["nodes"][1]["translation"] = {0, far, 0};
    builder.document["nodes"][1]["scale"] = {1, far, 1};
    EXPECT_ERROR(read(builder), "node 1 'knee'", "range of floats");
  }
  builder = two_joint_strip();
  builder.document["meshes"][0]["primitives"][0]["indices"] =
      builder.accessor(std::vector<uint16_t>{0, 1, 10}, "SCALAR");
  EXPECT_ERROR(read(builder), "indices below 10", "found 10");
  builder = two_joint_strip();
  builder.document["accessors"][0]["count"] = 1000;
  EXPECT_ERROR(read(builder), "POSITION", "1000 elements inside of buffer view");
  builder = two_joint_strip();
  builder.document["bufferViews"][0]["byteLength"] = 1 << 20;
  EXPECT_ERROR(read(builder), "POSITION", "inside of its buffer");
  builder = two_joint_strip();
  builder.document["nodes"][1]["children"] = {0};
  builder.document["scenes"][0]["nodes"] = {2};
  EXPECT_ERROR(read(builder), "cycle");
  builder = two_joint_strip();
  builder.document["nodes"][2]["children"] = {1};
  EXPECT_ERROR(read(builder), "node 1 'knee'", "one parent");
  builder = two_joint_strip();
  builder.document["nodes"][2]["skin"] = 4;
  EXPECT_ERROR(read(builder), "node 2 'body'", "skin below 1", "found 4");
  builder = two_joint_strip();
  builder.document["skins"][0]["joints"] = {0, 9};
  EXPECT_ERROR(read(builder), "skin 0", "found 9");
}

TEST(GltfRead, CutAndFlippedFilesEndInAnErrorOrACharacter) {
  const TempFolder folder;
  const std::string whole = two_joint_strip(true).glb();
  for (size_t length = 0; length < whole.size(); length += 13)
    EXPECT_THROW(read_gltf(folder.write("cut.glb", whole.substr(0, length))), Error) << length;
  uint32_t random = 12345;
  for (int round = 0; round < 300; ++round) {
    std::string bytes = whole;
    for (int i = 0; i < 1 + round % 3; ++i) {
      random = random * 1664525u + 1013904223u;
      bytes[random % bytes.size()] = static_cast<char>(random >> 24);
    }
    try {
      const Character c = read_gltf(folder.write("flip.glb", bytes));
      write_glb(folder.file("out.glb"), c);
      for (const uint32_t v : c.face_vertices) ASSERT_LT(v, c.vertices.size());
      for (const auto& r : c.influences)
        for (const Influence& influence : r) ASSERT_LT(influence.joint, c.joints.size());
    } catch (const Error& error) {
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    }
  }
}

TEST(GltfRead, DecimatedCharactersForgetTheirDocument) {
  const Character c = decimate(read(two_joint_strip()), 1.0);
  EXPECT_EQ(c.gltf, nullptr);
  EXPECT_NO_THROW(written(c));
}

}  // namespace
