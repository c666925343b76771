// SPDX-License-Identifier: MIT
// What is written as USD, by its text. tests/support/three opens the same files in three's USDLoader.
#include "usd/usd_write.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "make_glb.hpp"
#include "motion/npy.hpp"
#include "same_character.hpp"
#include "sinew_formats/base/affine.hpp"
#include "sinew_formats/base/point.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_formats/morphs.hpp"
#include "sinew_formats/motion.hpp"
#include "temp_folder.hpp"
#include "walking_figure.hpp"

namespace sinew {
namespace {

class UsdWrite : public ::testing::TestWithParam<const char*> {
 protected:
  bool is_package() const { return std::string(GetParam()) == ".usdz"; }
  std::string out() const { return folder_.file(std::string("out") + GetParam()); }
  // Files of the package, or beside the layer.
  std::vector<uint8_t> written(const std::string& name) const {
    return is_package() ? unzip(out(), read_file(out())).at(name) : read_file(folder_.file(name));
  }
  std::string layer() const {
    const std::vector<uint8_t> bytes = written("out.usda");
    return {bytes.begin(), bytes.end()};
  }
  TempFolder folder_;
};
INSTANTIATE_TEST_SUITE_P(Kinds, UsdWrite, ::testing::Values(".usda", ".usdz"));

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

// The text behind "NAME = [" up to "]", for the first such attribute.
std::string list_of(const std::string& text, const std::string& name) {
  const size_t at = text.find(name + " = [");
  EXPECT_NE(at, std::string::npos) << name;
  if (at == std::string::npos) return "";
  const size_t begin = at + name.size() + 4;
  return text.substr(begin, text.find(']', begin) - begin);
}

std::vector<double> numbers_of(const std::string& text, const std::string& name) {
  std::string list = list_of(text, name);
  std::replace_if(
      list.begin(), list.end(), [](char c) { return std::strchr("(),", c) != nullptr; }, ' ');
  std::vector<double> numbers;
  const char* at = list.c_str();
  for (char* end = nullptr;; at = end) {
    const double number = std::strtod(at, &end);
    if (end == at) return numbers;
    numbers.push_back(number);
  }
}

TEST_P(UsdWrite, HasSkeletonWeightsAndRestPose) {
  Character figure = walking_figure();
  figure.joints[3].name = "mixamorig:Spine 2";  // no name of USD
  write_gltf(out(), figure);
  const std::string text = layer();
  const std::vector<double> points = numbers_of(text, "point3f[] points");
  ASSERT_EQ(points.size(), 3 * figure.vertices.size());
  // Vertices are written in the order of faces: each is one of the figure's.
  std::vector<size_t> written;
  for (size_t v = 0; v < figure.vertices.size(); ++v) {
    const auto away = [&](const Vec3& p) {
      return std::hypot(points[3 * v] - static_cast<double>(p.x), points[3 * v + 1] - static_cast<double>(p.y),
                        points[3 * v + 2] - static_cast<double>(p.z));
    };
    const auto nearest = std::min_element(figure.vertices.begin(), figure.vertices.end(),
                                          [&](const Vec3& a, const Vec3& b) { return away(a) < away(b); });
    EXPECT_LT(away(*nearest), 1e-6);
    written.push_back(static_cast<size_t>(nearest - figure.vertices.begin()));
  }
  EXPECT_EQ(std::set<size_t>(written.begin(), written.end()).size(), figure.vertices.size());
  EXPECT_EQ(numbers_of(text, "int[] faceVertexIndices").size(), figure.face_vertices.size());
  EXPECT_TRUE(has(list_of(text, "uniform token[] jointNames"), "\"mixamorig:Spine 2\""));
  const std::vector<double> binds = numbers_of(text, "uniform matrix4d[] bindTransforms");
  ASSERT_EQ(binds.size(), 16 * figure.joints.size());
  EXPECT_EQ(numbers_of(text, "uniform matrix4d[] restTransforms").size(), binds.size());
  // Joints are written parents first: jointNames says which is which.
  std::vector<uint32_t> joint_of;
  const std::string names = list_of(text, "uniform token[] jointNames");
  for (size_t from = names.find('"'); from != std::string::npos;) {
    const size_t to = names.find('"', from + 1);
    const std::string name = names.substr(from + 1, to - from - 1);
    const auto found = std::find_if(figure.joints.begin(), figure.joints.end(),
                                    [&](const Joint& joint) { return joint.name == name; });
    ASSERT_NE(found, figure.joints.end()) << name;
    joint_of.push_back(static_cast<uint32_t>(found - figure.joints.begin()));
    from = names.find('"', to + 1);
  }
  ASSERT_EQ(joint_of.size(), figure.joints.size());
  for (size_t j = 0; j < joint_of.size(); ++j)
    EXPECT_NEAR(binds[16 * j + 13], static_cast<double>(figure.joints[joint_of[j]].position.y), 1e-6);
  const std::vector<double> joints = numbers_of(text, "int[] primvars:skel:jointIndices");
  const std::vector<double> weights = numbers_of(text, "float[] primvars:skel:jointWeights");
  ASSERT_EQ(weights.size(), 2 * figure.vertices.size());
  ASSERT_EQ(joints.size(), weights.size());
  for (size_t v = 0; v < figure.vertices.size(); ++v) {
    EXPECT_NEAR(weights[2 * v] + weights[2 * v + 1], 1, 1e-6);
    for (const Influence& one : figure.influences[written[v]]) {
      double weight = 0;
      for (size_t k = 2 * v; k < 2 * v + 2; ++k)
        if (joint_of.at(static_cast<size_t>(joints[k])) == one.joint) weight += weights[k];
      EXPECT_NEAR(weight, static_cast<double>(one.weight), 2e-5) << "unorm16";
    }
  }
}

TEST_P(UsdWrite, HasItsClips) {
  Motion walk = walking_person(20);
  walk.clips.push_back(walk.clips[0]);
  walk.clips[1].name = "walk, again";
  walk.clips[1].frames.resize(5);
  GlbOptions options;
  options.motion = &walk;
  write_gltf(out(), walking_figure(), options);
  const std::string text = layer();
  EXPECT_TRUE(has(text, "rel skel:animationSource = </Character/Skeleton/walk>"));
  EXPECT_TRUE(has(text, "string name = \"walk, again\""));
  EXPECT_TRUE(has(text, "timeCodesPerSecond = 30"));
  const size_t second = text.rfind("def SkelAnimation");
  const auto samples = [](const std::string& animation) {
    const size_t begin = animation.find("rotations.timeSamples = {"), end = animation.find('}', begin);
    return std::count(animation.begin() + static_cast<std::ptrdiff_t>(begin),
                      animation.begin() + static_cast<std::ptrdiff_t>(end), '[');
  };
  EXPECT_EQ(samples(text.substr(0, second)), 20);
  EXPECT_EQ(samples(text.substr(second)), 5);
}

// Colors of vertices with their alpha; opaque ones have none.
TEST_P(UsdWrite, HasTransparentColors) {
  for (const bool opaque : {false, true}) {
    GlbBuilder builder = two_joint_strip();
    std::vector<float> colors;
    for (int v = 0; v < 10; ++v)
      for (const float part :
           {0.1f * static_cast<float>(v), 0.5f, 1.0f, opaque ? 1.0f : 0.25f + 0.05f * static_cast<float>(v)})
        colors.push_back(part);
    builder.document["meshes"][0]["primitives"][0]["attributes"]["COLOR_0"] = builder.accessor(colors, "VEC4");
    write_gltf(out(), read_gltf(folder_.write("strip.glb", builder.glb())));
    const std::string text = layer();
    const std::vector<double> rgb = numbers_of(text, "color3f[] primvars:displayColor");
    ASSERT_FALSE(rgb.empty());
    ASSERT_EQ(has(text, "primvars:displayOpacity"), !opaque);
    const std::vector<double> alpha =
        opaque ? std::vector<double>(rgb.size() / 3, 1.0) : numbers_of(text, "float[] primvars:displayOpacity");
    ASSERT_EQ(3 * alpha.size(), rgb.size());
    // Corners come in another order: each is one of the vertices.
    for (size_t c = 0; c < alpha.size(); ++c) {
      const size_t v = static_cast<size_t>(std::lround(rgb[3 * c] * 10));
      for (size_t i = 0; i < 3; ++i) EXPECT_NEAR(rgb[3 * c + i], static_cast<double>(colors.at(4 * v + i)), 1e-6);
      EXPECT_NEAR(alpha[c], static_cast<double>(colors.at(4 * v + 3)), 1e-6);
    }
  }
}

TEST_P(UsdWrite, HasShapesNormalsAndSeams) {
  // A file with a seam, whose vertices stand elsewhere than its nodes put them.
  const Character strip = read_gltf(folder_.write("strip.glb", two_joint_strip(true).glb()));
  Morphs morphs;
  morphs.shapes = {{"bulge out", {0, 1}, {{0.1f, 0, 0}, {0, 0.2f, 0}}}};
  write_gltf_morphs(out(), strip, {}, morphs);
  const std::string text = layer();
  EXPECT_EQ(list_of(text, "uniform token[] skel:blendShapes"), "\"bulge out\"");
  EXPECT_TRUE(has(text, "rel skel:blendShapeTargets"));
  double sum = 0;
  for (const double value : numbers_of(text, "uniform vector3f[] offsets")) sum += value;
  EXPECT_NEAR(sum, 0.3, 1e-6);
  EXPECT_EQ(numbers_of(text, "uniform int[] pointIndices").size(), 2u);
  EXPECT_EQ(numbers_of(text, "point3f[] points").size(), 3 * strip.vertices.size()) << "the seam is closed";
  const size_t corners = numbers_of(text, "int[] faceVertexIndices").size();
  EXPECT_EQ(numbers_of(text, "texCoord2f[] primvars:st").size(), 2 * corners);
  EXPECT_EQ(numbers_of(text, "normal3f[] normals").size(), 3 * corners);
}

TEST_P(UsdWrite, HasColorsAndPictures) {
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
  EXPECT_EQ(written("out_0.png"), std::vector<uint8_t>(pixel.begin(), pixel.end()));
  const std::string text = layer();
  EXPECT_TRUE(has(text, "def Material \"skin\""));
  EXPECT_TRUE(has(text, "string name = \"shoe's\""));
  EXPECT_TRUE(has(text, "asset inputs:file = @./out_0.png@"));
  EXPECT_TRUE(has(text, "color3f inputs:diffuseColor = (0.25, 0.5, 0.75)"));
  const size_t of_shoes = text.find("rel material:binding = </Character/Materials/shoe_s>");
  ASSERT_NE(of_shoes, std::string::npos);
  const std::string before = text.substr(0, of_shoes);
  EXPECT_EQ(numbers_of(before.substr(before.rfind("def GeomSubset")), "int[] indices").size(), 8u);
  const std::vector<double> uvs = numbers_of(text, "texCoord2f[] primvars:st");
  EXPECT_NEAR(uvs.at(0), 0.25, 1e-6);
  EXPECT_NEAR(uvs.at(1), 0.125, 1e-6);
}

TEST_P(UsdWrite, SaysMetersAndUp) {
  write_gltf(out(), walking_figure());
  const std::string text = layer();
  EXPECT_EQ(text.rfind("#usda 1.0\n(\n    defaultPrim = \"Character\"\n    metersPerUnit = 1\n    upAxis = \"Y\"\n", 0),
            0u);
  EXPECT_TRUE(has(text, "\ndef SkelRoot \"Character\" ("));
}

TEST(UsdPackage, IsAStoredZipWhoseFilesBeginAtMultiplesOf64) {
  std::vector<NamedBytes> files = {{"a.usda", std::vector<uint8_t>(70, 'x')}};
  for (uint8_t i = 1; i < 9; ++i)
    files.push_back({"picture_" + std::to_string(i) + ".png", std::vector<uint8_t>(31u * i, i)});
  const std::vector<uint8_t> bytes = usd_package("a.usdz", files);
  const std::string first = "a.usda";
  EXPECT_TRUE(std::equal(first.begin(), first.end(), bytes.begin() + 30)) << "the layer comes first";
  const auto inside = unzip("a.usdz", bytes);
  ASSERT_EQ(inside.size(), files.size());
  for (const NamedBytes& file : files) {
    EXPECT_EQ(inside.at(file.path), file.bytes);
    const auto at = std::search(bytes.begin(), bytes.end(), file.bytes.begin(), file.bytes.end());
    EXPECT_EQ((at - bytes.begin()) % 64, 0) << file.path;
  }
}

}  // namespace
}  // namespace sinew
