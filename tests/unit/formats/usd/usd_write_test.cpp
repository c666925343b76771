// SPDX-License-Identifier: MIT
// What is written as USD comes back by our reader.
#include "usd/usd_write.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "gltf/gltf_source.hpp"
#include "make_glb.hpp"
#include "motion/npy.hpp"
#include "same_character.hpp"
#include "sinew_formats/base/point.hpp"
#include "sinew_formats/base/quaternion.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_formats/morphs.hpp"
#include "sinew_formats/motion.hpp"
#include "temp_folder.hpp"
#include "usd/usd_package.hpp"
#include "usd/usd_parse.hpp"
#include "walking_figure.hpp"

namespace sinew {
namespace {

class UsdWrite : public ::testing::TestWithParam<const char*> {
 protected:
  std::string out() const { return folder_.file(std::string("out") + GetParam()); }
  TempFolder folder_;
};
INSTANTIATE_TEST_SUITE_P(Kinds, UsdWrite, ::testing::Values(".usda", ".usdz"));

TEST_P(UsdWrite, ComesBackWithSkeletonWeightsAndRestPose) {
  Character figure = walking_figure();
  figure.joints[3].name = "mixamorig:Spine 2";  // no name of USD
  write_gltf(folder_.file("out.glb"), figure);
  write_gltf(out(), figure);
  const Character after = read_character(out());
  expect_same_character(read_character(folder_.file("out.glb")), after, 1e-6);
  EXPECT_TRUE(after.gltf->bind_pose.agrees);
  EXPECT_FALSE(after.gltf->bind_pose.moved);
  EXPECT_TRUE(after.notes.empty());
}

TEST_P(UsdWrite, ComesBackWithItsClips) {
  Motion walk = walking_person(20);
  walk.clips.push_back(walk.clips[0]);
  walk.clips[1].name = "walk, again";
  walk.clips[1].frames.resize(5);
  GlbOptions options;
  options.motion = &walk;
  write_gltf(out(), walking_figure(), options);
  const Motion again = read_motion(out(), 30);
  ASSERT_EQ(again.clips.size(), 2u);
  EXPECT_EQ(again.clips[0].name, "walk");
  EXPECT_EQ(again.clips[1].name, "walk, again");
  ASSERT_EQ(again.clips[0].frames.size(), 20u);
  ASSERT_EQ(again.clips[1].frames.size(), 5u);
  expect_same_clip(walk, again, walking_figure(), 2e-6, 1e-10);
}

// Colours of vertices with their alpha; what is opaque has none.
TEST_P(UsdWrite, ComesBackWithTransparentColours) {
  for (const bool opaque : {false, true}) {
    GlbBuilder builder = two_joint_strip();
    std::vector<float> colours;
    for (int v = 0; v < 10; ++v)
      for (const float part :
           {0.1f * static_cast<float>(v), 0.5f, 1.0f, opaque ? 1.0f : 0.25f + 0.05f * static_cast<float>(v)})
        colours.push_back(part);
    builder.document["meshes"][0]["primitives"][0]["attributes"]["COLOR_0"] = builder.accessor(colours, "VEC4");
    write_gltf(out(), read_gltf(folder_.write("strip.glb", builder.glb())));
    const Character again = read_gltf(out());
    const tinygltf::Model& model = again.gltf->model;
    const int accessor = model.meshes.at(0).primitives.at(0).attributes.at("COLOR_0");
    ASSERT_EQ(model.accessors.at(static_cast<size_t>(accessor)).type, opaque ? TINYGLTF_TYPE_VEC3 : TINYGLTF_TYPE_VEC4);
    const size_t width = opaque ? 3 : 4;
    const std::vector<float> found = accessor_floats("", model, accessor, static_cast<int>(width));
    ASSERT_EQ(found.size(), 10 * width);
    // Vertices come in another order: each is one of those that were.
    for (size_t v = 0; v < found.size(); v += width) {
      const size_t own = static_cast<size_t>(std::lround(found[v] * 10));
      for (size_t i = 0; i < width; ++i) EXPECT_NEAR(found[v + i], colours.at(4 * own + i), 1e-6);
    }
  }
}

TEST_P(UsdWrite, ComesBackWithAxesShapesAndSeams) {
  // A file with a seam, whose vertices stand elsewhere than its nodes put them.
  const Character strip = read_gltf(folder_.write("strip.glb", two_joint_strip(true).glb()));
  Morphs morphs;
  morphs.shapes = {{"bulge out", {0, 1}, {{0.1f, 0, 0}, {0, 0.2f, 0}}}};
  write_gltf_morphs(out(), strip, {}, morphs);
  write_gltf(folder_.file("again.glb"), strip);
  const Character again = read_gltf(out());
  expect_same_character(read_gltf(folder_.file("again.glb")), again, 1e-6);
  const tinygltf::Mesh& mesh = again.gltf->model.meshes.at(0);
  ASSERT_EQ(mesh.primitives.at(0).targets.size(), 1u);
  EXPECT_EQ(mesh.extras.Get("targetNames").Get(0).Get<std::string>(), "bulge out");
  const std::vector<float> moves =
      accessor_floats("", again.gltf->model, mesh.primitives[0].targets[0].at("POSITION"), 3);
  double sum = 0;
  for (const float value : moves) sum += static_cast<double>(value);
  EXPECT_NEAR(sum, 0.3, 1e-6);
  EXPECT_EQ(mesh.primitives[0].attributes.count("TEXCOORD_0"), 1u);
  EXPECT_EQ(mesh.primitives[0].attributes.count("NORMAL"), 1u);
}

TEST_P(UsdWrite, ComesBackWithColoursAndPictures) {
  const std::string pixel(
      "\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\0\1\0\0\0\1\b\2\0\0\0\x90wS\xde\0\0\0\fIDATx\x9c"
      "c\xf8\xcf\xc0\0\0\3\1\1\0\xc9\xfe\x92\xef\0\0\0\0IEND\xae"
      "B`\x82",
      69);
  Character figure = walking_figure();
  figure.material_names = {"skin", "shoe's"};
  figure.materials.resize(2);
  figure.materials[0].base_color_texture = std::make_shared<std::vector<uint8_t>>(pixel.begin(), pixel.end());
  figure.materials[1].base_color = {0.25f, 0.5f, 0.75f, 1};
  figure.corner_uvs.assign(figure.face_vertices.size(), {0.25f, 0.125f});
  figure.face_materials.assign(figure.face_count(), 0);
  for (size_t f = 0; f < 8; ++f) figure.face_materials[f] = 1;
  write_gltf(out(), figure);
  if (std::string(GetParam()) == ".usda") {
    EXPECT_EQ(read_file(folder_.file("out_0.png")), std::vector<uint8_t>(pixel.begin(), pixel.end()));
  }
  const Character again = read_gltf(out());
  const tinygltf::Model& model = again.gltf->model;
  ASSERT_EQ(model.materials.size(), 2u);
  EXPECT_EQ(model.materials[0].name, "skin");
  EXPECT_EQ(model.materials[1].name, "shoe's");
  ASSERT_GE(model.materials[0].pbrMetallicRoughness.baseColorTexture.index, 0);
  ASSERT_EQ(model.images.size(), 1u);
  EXPECT_EQ(model.images[0].image, std::vector<unsigned char>(pixel.begin(), pixel.end()));
  EXPECT_NEAR(model.materials[1].pbrMetallicRoughness.baseColorFactor[2], 0.75, 1e-6);
  size_t corners = 0;
  for (const tinygltf::Primitive& primitive : model.meshes.at(0).primitives)
    if (primitive.material == 1) corners = model.accessors[static_cast<size_t>(primitive.indices)].count;
  EXPECT_EQ(corners, 24u);
  const std::vector<float> uvs =
      accessor_floats("", model, model.meshes[0].primitives[0].attributes.at("TEXCOORD_0"), 2);
  EXPECT_NEAR(uvs[0], 0.25, 1e-6);
  EXPECT_NEAR(uvs[1], 0.875, 1e-6);  // glTF's go down
}

TEST(UsdText, SaysMetresAndUp) {
  const TempFolder folder;
  write_gltf(folder.file("out.usda"), walking_figure());
  const UsdPrim root = parse_usda("out.usda", read_text_file(folder.file("out.usda")));
  EXPECT_EQ(root.metadata.at("metersPerUnit").numbers, std::vector<double>{1});
  EXPECT_EQ(root.metadata.at("upAxis").texts, std::vector<std::string>{"Y"});
  EXPECT_EQ(root.metadata.at("defaultPrim").texts[0], root.children.at(0).name);
  EXPECT_EQ(root.children[0].type, "SkelRoot");
}

TEST(UsdPackage, IsAStoredZipWhoseFilesBeginAtMultiplesOf64) {
  std::vector<NamedBytes> files = {{"a.usda", std::vector<uint8_t>(70, 'x')}};
  for (uint8_t i = 1; i < 9; ++i)
    files.push_back({"picture_" + std::to_string(i) + ".png", std::vector<uint8_t>(31u * i, i)});
  const std::vector<uint8_t> bytes = usd_package("a.usdz", files);
  EXPECT_EQ(first_in_package(bytes), "a.usda");
  const auto inside = unzip("a.usdz", bytes);
  ASSERT_EQ(inside.size(), files.size());
  for (const NamedBytes& file : files) {
    EXPECT_EQ(inside.at(file.path), file.bytes);
    const auto at = std::search(bytes.begin(), bytes.end(), file.bytes.begin(), file.bytes.end());
    EXPECT_EQ((at - bytes.begin()) % 64, 0) << file.path;
  }
  EXPECT_EQ(first_in_package({'P', 'K', 3, 4}), "");
}

}  // namespace
}  // namespace sinew
