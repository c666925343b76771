// SPDX-License-Identifier: MIT
// glTF in: every form of accessor, skins, rigid parts, seams, what is refused.
#include <gtest/gtest.h>

#include <cmath>

#include "expect_error.hpp"
#include "glb_round.hpp"

namespace sinew {
namespace {

using nlohmann::json;

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

// The knee of the strip turned by 90 degrees about Z: a file saved in a frame of an animation.
GlbBuilder posed_strip() {
  GlbBuilder builder = two_joint_strip();
  builder.document["nodes"][1]["rotation"] = {0, 0, std::sqrt(0.5), std::sqrt(0.5)};
  return builder;
}

TEST(GltfRead, AFileSavedInAPoseIsReadAsItWasBound) {
  const Character c = read(posed_strip()), bound = read(two_joint_strip());
  ASSERT_EQ(c.vertices.size(), bound.vertices.size());
  for (size_t v = 0; v < c.vertices.size(); ++v) {
    EXPECT_NEAR(c.vertices[v].x, bound.vertices[v].x, 1e-5);
    EXPECT_NEAR(c.vertices[v].y, bound.vertices[v].y, 1e-5);
  }
  EXPECT_NEAR(c.joints[1].position.y, bound.joints[1].position.y, 1e-5);
}

TEST(GltfRead, WhereMatricesKnowNoCommonPoseTheMeshStandsAsItIsHeld) {
  GlbBuilder builder = posed_strip();
  const float far[32] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 900, 0,   0, 1,
                         1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0,   900, 0, 1};
  const size_t accessor = builder.document["skins"][0]["inverseBindMatrices"];
  const size_t view = builder.document["accessors"][accessor]["bufferView"];
  std::memcpy(&builder.bytes[builder.document["bufferViews"][view]["byteOffset"].get<size_t>()], far, sizeof far);
  const Character c = read(builder);
  // The top vertex (0, 4) belongs to the knee alone: 4 + 900 above it, turned to its left.
  EXPECT_NEAR(c.vertices[8].x, 10 - 904, 1e-3);
  EXPECT_NEAR(c.vertices[8].y, 2, 1e-3);
  // New weights leave it there.
  Character again = c;
  for (auto& row : again.influences) row = {{0, 0.5f}, {1, 0.5f}};
  const Character back = reread(written(again));
  for (size_t v = 0; v < c.vertices.size(); ++v) {
    EXPECT_NEAR(back.vertices[v].x, c.vertices[v].x, 1e-3);
    EXPECT_NEAR(back.vertices[v].y, c.vertices[v].y, 1e-3);
  }
}

TEST(GltfRead, MeshesAndWhatDeforms) {
  GlbBuilder builder = with_parts();
  builder.document["nodes"][0]["extras"] = {{"use_deform", false}};
  builder.document["nodes"][1]["extras"] = {{"deform", 1}};
  const Character c = read(builder);
  ASSERT_EQ(c.meshes.size(), 3u);
  EXPECT_TRUE(c.meshes[0].skinned);
  EXPECT_EQ(c.meshes[1].name, "lamp");
  EXPECT_FALSE(c.meshes[1].skinned);
  EXPECT_EQ(c.meshes[1].carrier, 1);
  EXPECT_EQ(c.meshes[2].carrier, -1);
  ASSERT_EQ(c.vertex_meshes.size(), c.vertices.size());
  EXPECT_EQ(c.vertex_meshes.front(), 0u);
  EXPECT_EQ(c.vertex_meshes.back(), 2u);
  EXPECT_EQ(c.joints[0].deforms, std::optional<bool>(false));
  EXPECT_EQ(c.joints[1].deforms, std::optional<bool>(true));
  EXPECT_EQ(read(two_joint_strip()).joints[0].deforms, std::nullopt);
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

}  // namespace
}  // namespace sinew
