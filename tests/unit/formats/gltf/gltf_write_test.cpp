// SPDX-License-Identifier: MIT
// glTF out: what the writer keeps of a document, and what it refuses.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "expect_error.hpp"
#include "glb_round.hpp"

namespace sinew {
namespace {

using nlohmann::json;

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

TEST(GltfWrite, TextFormHasItsBytesBesideIt) {
  const TempFolder folder;
  const Character c = read(two_joint_strip(true));
  write_gltf(folder.file("strip 2.gltf"), c);
  const json out = json::parse(folder.text_of("strip 2.gltf"));
  EXPECT_EQ(out["buffers"][0]["uri"], "strip%202.bin");
  EXPECT_EQ(out["buffers"][0]["byteLength"], folder.text_of("strip 2.bin").size());
  EXPECT_EQ(folder.file_count(), 2u);
  const Character again = read_gltf(folder.file("strip 2.gltf"));
  ASSERT_EQ(again.vertices.size(), c.vertices.size());
  for (size_t v = 0; v < c.vertices.size(); ++v) EXPECT_EQ(again.vertices[v].y, c.vertices[v].y);

  std::filesystem::create_directories(folder.file("blocked.bin"));
  EXPECT_ERROR(write_gltf(folder.file("blocked.gltf"), c), "blocked.bin", "directory");
  EXPECT_EQ(folder.file_count(), 3u);
}

TEST(GltfWrite, PicturesOfTheSameFolderStayFiles) {
  const TempFolder folder, other;
  const std::string png = "\x89PNG\r\n\x1a\n....picture";
  folder.write("skin.png", png);
  GlbBuilder builder = two_joint_strip();
  builder.add("images", {{"uri", "skin.png"}});
  builder.add("textures", {{"source", 0}});
  builder.add("materials", {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
  const Character c = read_gltf(folder.write("in.glb", builder.glb()));
  write_gltf(folder.file("out.gltf"), c);
  EXPECT_EQ(json::parse(folder.text_of("out.gltf"))["images"][0], json({{"uri", "skin.png"}}));
  EXPECT_EQ(folder.text_of("out.bin").find(png), std::string::npos);
  write_gltf(other.file("out.gltf"), c);
  EXPECT_TRUE(json::parse(other.text_of("out.gltf"))["images"][0].contains("bufferView"));
  EXPECT_NE(other.text_of("out.bin").find(png), std::string::npos);
  write_gltf(folder.file("out.glb"), c);
  EXPECT_NE(folder.text_of("out.glb").find(png), std::string::npos);
}

// A picture that glTF has no type for stays a file, one that was not found a name.
TEST(GltfWrite, PicturesThatCannotBeEmbeddedAreNamedFromTheNewFolder) {
  const TempFolder folder;
  folder.write("sk in.tga", "a kind that glTF does not know");
  std::filesystem::create_directories(folder.file("out"));
  GlbBuilder builder = two_joint_strip();
  for (const char* uri : {"sk%20in.tga", "missing.png"}) {
    builder.add("images", {{"uri", uri}});
    builder.add("textures", {{"source", builder.document["textures"].size()}});
  }
  const Character c = read_gltf(folder.write("in.glb", builder.glb()));
  ASSERT_EQ(c.notes.size(), 1u);
  EXPECT_NE(c.notes[0].find("1 picture was not found: 'missing.png'"), std::string::npos) << c.notes[0];
  for (const char* name : {"out/a.glb", "out/a.gltf"}) {
    write_gltf(folder.file(name), c);
    const std::string text = folder.text_of(name);
    const json images = (std::string(name).back() == 'b' ? json_of_glb(text) : json::parse(text))["images"];
    EXPECT_EQ(images[0]["uri"], "../sk%20in.tga") << name;
    EXPECT_EQ(images[1]["uri"], "missing.png") << name;
  }
}

TEST(GltfWrite, OnlyAVrmBecomesAVrm) {
  const TempFolder folder;
  GlbBuilder builder = two_joint_strip();
  EXPECT_ERROR(write_gltf(folder.file("out.vrm"), read(builder)), "out.vrm", "VRMC_vrm", ".glb");
  EXPECT_EQ(folder.file_count(), 0u);
  builder.document["extensionsUsed"] = {"VRMC_vrm"};
  builder.document["extensions"]["VRMC_vrm"] = {{"specVersion", "1.0"}};
  write_gltf(folder.file("out.vrm"), read(builder));
  EXPECT_EQ(json_of_glb(folder.text_of("out.vrm"))["extensions"], builder.document["extensions"]);
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

}  // namespace
}  // namespace sinew
