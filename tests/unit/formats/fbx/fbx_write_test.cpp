// SPDX-License-Identifier: MIT
// What is written as FBX comes back by our reader, which is Assimp's.
#include "fbx/fbx_write.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "expect_error.hpp"
#include "fbx/fbx_binary.hpp"
#include "gltf/gltf_source.hpp"
#include "make_glb.hpp"
#include "same_character.hpp"
#include "sinew_formats/base/point.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_formats/morphs.hpp"
#include "sinew_formats/motion.hpp"
#include "temp_folder.hpp"
#include "walking_figure.hpp"

namespace sinew {
namespace {

TEST(FbxBinary, IsHeaderNodesAndFoot) {
  FbxNode node("Top");
  node.integer(7).text("a");
  node.add("Below").numbers({1.5});
  const std::vector<uint8_t> file = fbx_file({node});
  EXPECT_EQ(std::string(file.begin(), file.begin() + 20), "Kaydara FBX Binary  ");
  EXPECT_EQ(file[23] + 256 * file[24], 7500);
  uint64_t end = 0, properties = 0, bytes = 0;
  std::memcpy(&end, file.data() + 27, 8);
  std::memcpy(&properties, file.data() + 35, 8);
  std::memcpy(&bytes, file.data() + 43, 8);
  EXPECT_EQ(properties, 2u);
  EXPECT_EQ(bytes, 5u + 6u);
  EXPECT_EQ(file[51], 3);
  for (uint64_t i = 0; i < 25; ++i) EXPECT_EQ(file[end - 25 + i], 0);  // the list of nodes below ends so
  EXPECT_EQ(file.back(), 0x0b);
}

TEST(FbxEuler, IsTheRotationAndStaysNearTheOneBefore) {
  std::array<double, 3> before = {0, 0, 0};
  for (int i = 0; i < 200; ++i) {
    const double t = 0.07 * i;
    const Quaternion q = normalized(
        multiply(axis_rotation(2, t), multiply(axis_rotation(1, 0.9 * std::sin(t)), axis_rotation(0, -1.3 * t))));
    const std::array<double, 3> angles = fbx_euler(q, before);
    constexpr double kRadian = 3.14159265358979323846 / 180;
    const Quaternion again =
        multiply(axis_rotation(2, angles[2] * kRadian),
                 multiply(axis_rotation(1, angles[1] * kRadian), axis_rotation(0, angles[0] * kRadian)));
    EXPECT_NEAR(std::abs(dot(again, q)), 1, 1e-9);
    if (i > 0) {
      for (size_t k = 0; k < 3; ++k) EXPECT_LT(std::abs(angles[k] - before[k]), 30);
    }
    before = angles;
  }
}

#ifdef SINEW_HAS_ASSIMP

class FbxWrite : public ::testing::Test {
 protected:
  TempFolder folder_;
};

TEST_F(FbxWrite, ComesBackWithSkeletonWeightsAndRestPose) {
  const Character figure = walking_figure();
  write_gltf(folder_.file("out.glb"), figure);
  write_gltf(folder_.file("out.fbx"), figure);
  const Character before = read_character(folder_.file("out.glb")), after = read_character(folder_.file("out.fbx"));
  expect_same_character(before, after, 1e-5);
  float high = 0;
  for (const Vec3& p : after.vertices) high = std::max(high, p.y);
  EXPECT_LT(high, 2);  // not 183 m
  EXPECT_TRUE(after.gltf->bind_pose.agrees);
  EXPECT_FALSE(after.gltf->bind_pose.moved);
}

TEST_F(FbxWrite, ComesBackWithItsClip) {
  const Motion walk = walking_person(20);
  GlbOptions options;
  options.motion = &walk;
  write_gltf(folder_.file("out.fbx"), walking_figure(), options);
  const Motion again = read_motion(folder_.file("out.fbx"), 30);
  ASSERT_EQ(again.clips.size(), 1u);
  EXPECT_EQ(again.clips[0].name, "walk");
  ASSERT_EQ(again.clips[0].frames.size(), 20u);
  expect_same_clip(walk, again, walking_figure(), 1e-3, 1e-6);
}

TEST_F(FbxWrite, ComesBackWithAxesShapesAndSeams) {
  // A file with a seam, whose vertices stand elsewhere than its nodes put them.
  const Character strip = read_gltf(folder_.write("strip.glb", two_joint_strip(true).glb()));
  Morphs morphs;
  morphs.shapes = {{"bulge", {0, 1}, {{0.1f, 0, 0}, {0, 0.2f, 0}}}};
  write_gltf_morphs(folder_.file("strip.fbx"), strip, {}, morphs);
  write_gltf(folder_.file("again.glb"), strip);
  const Character again = read_gltf(folder_.file("strip.fbx"));
  expect_same_character(read_gltf(folder_.file("again.glb")), again, 1e-5);
  const tinygltf::Mesh& mesh = again.gltf->model.meshes.at(0);
  ASSERT_EQ(mesh.primitives.at(0).targets.size(), 1u);
  EXPECT_EQ(mesh.extras.Get("targetNames").Get(0).Get<std::string>(), "bulge");
  const std::vector<float> moves =
      accessor_floats("", again.gltf->model, mesh.primitives[0].targets[0].at("POSITION"), 3);
  double sum = 0;
  for (const float value : moves) sum += static_cast<double>(value);
  EXPECT_NEAR(sum, 30, 1e-3);  // centimeters
  EXPECT_EQ(mesh.primitives[0].attributes.count("TEXCOORD_0"), 1u);
  EXPECT_EQ(mesh.primitives[0].attributes.count("NORMAL"), 1u);
}

TEST_F(FbxWrite, ComesBackWithColorsAndPictures) {
  const std::string pixel(
      "\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\0\1\0\0\0\1\b\2\0\0\0\x90wS\xde\0\0\0\fIDATx\x9c"
      "c\xf8\xcf\xc0\0\0\3\1\1\0\xc9\xfe\x92\xef\0\0\0\0IEND\xae"
      "B`\x82",
      69);
  Character figure = walking_figure();
  figure.material_names = {"skin", "shoe"};
  figure.materials.resize(2);
  figure.materials[0].base_color_texture = std::make_shared<std::vector<uint8_t>>(pixel.begin(), pixel.end());
  figure.materials[1].base_color = {0.25f, 0.5f, 0.75f, 1};
  figure.corner_uvs.assign(figure.face_vertices.size(), {0.25f, 0.125f});
  figure.face_materials.assign(figure.face_count(), 0);
  for (size_t f = 0; f < 8; ++f) figure.face_materials[f] = 1;
  write_gltf(folder_.file("out.fbx"), figure);
  const Character again = read_gltf(folder_.file("out.fbx"));
  const tinygltf::Model& model = again.gltf->model;
  ASSERT_EQ(model.materials.size(), 2u);
  EXPECT_EQ(model.materials[0].name, "skin");
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
}

#endif

}  // namespace
}  // namespace sinew
