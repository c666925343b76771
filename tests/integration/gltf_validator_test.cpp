// SPDX-License-Identifier: MIT
// Every kind of GLB that write_glb makes passes the Khronos validator without errors and without warnings.
#include "gltf_validator.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "make_glb.hpp"
#include "random_character.hpp"
#include "rest_pose.hpp"
#include "scene_files.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_formats/still_mesh.hpp"
#include "temp_folder.hpp"
#ifdef SINEW_HAS_MESHOPT
#include "meshopt_glb.hpp"
#endif
#ifdef SINEW_HAS_DRACO
#include "draco_glb.hpp"
#endif

using namespace sinew;
using nlohmann::json;

namespace {

class Writes : public ::testing::Test {
 protected:
  Character read(const GlbBuilder& builder) { return read_gltf(folder_.write("in.glb", builder.glb())); }
  Character obj(const std::string& text) { return read_obj(folder_.write("in.obj", text)); }
  void save(const Character& character, const GlbOptions& options = {}) {
    files_.push_back(folder_.file("out" + std::to_string(files_.size()) + ".glb"));
    write_glb(files_.back(), character, options);
    expect_same_rest(character, files_.back());
  }
  // The validator starts slowly: once per test.
  void validate() { SINEW_EXPECT_VALID_GLTF(files_); }

  TempFolder folder_;
  std::vector<std::string> files_;
};

const char kBox[] =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nvt 0 0\nvt 1 0\nvn 0 0 1\nvn 0 0 0\n"
    "usemtl red\nf 1/1/1 2/2/1 3/1/2 4/2/1\nusemtl green\nf 1 2 5\nf 1 1 2\n";

TEST_F(Writes, FromObj) {
  Character c = obj(kBox);
  save(c);
  c.joints = {{"a", {0, 0, 0}, 2}, {"", {1, 0, 0}, -1}, {"root", {0.1f, 0.2f, 0.3f}, -1}};
  save(c);
  c.influences = {{{0, 1.0f}}, {{1, 0.3f}, {2, 0.7f}}, {}, {{0, 1.0f / 3}, {1, 1.0f / 3}, {2, 1.0f / 3}}, {{1, 1.0f}}};
  save(c);
  save(c, {true});
  for (int j = 0; j < 300; ++j) {
    c.joints.push_back({"finger " + std::to_string(j), {static_cast<float>(j), 0, 0}, 2});
    c.influences[static_cast<size_t>(j % 5)].push_back({static_cast<uint32_t>(3 + j), 0.01f});
  }
  save(c);  // 16-bit joints, 16 sets
  validate();
}

TEST_F(Writes, StillMeshes) {
  for (const Character& character :
       {obj(kBox), obj("v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n"), read(two_joint_strip(true))}) {
    const StillMesh mesh("still.glb", character);
    std::vector<Vec3> positions;
    std::vector<std::array<float, 2>> texels;
    for (const uint32_t v : mesh.vertices()) {
      positions.push_back(character.vertices[v]);
      texels.push_back({0.25f, 0.75f});
    }
    files_.push_back(folder_.file("still" + std::to_string(files_.size()) + ".glb"));
    write_file(files_.back(), mesh.glb(positions, mesh.normals(), texels));
  }
  validate();
}

TEST_F(Writes, FromRandomCharacters) {
  for (uint64_t seed = 0; seed < 30; ++seed) save(RandomCharacter(seed).make(), {seed % 2 == 1});
  validate();
}

TEST_F(Writes, BackIntoItsOwnDocument) {
  Character c = read(two_joint_strip(true));
  save(c);
  for (auto& row : c.influences) row = {{0, 0.123f}, {1, 0.877f}};
  save(c);
  save(c, {true});
  for (int j = 0; j < 9; ++j)
    c.joints.push_back({"new", {0, 1, 0}, j > 3 ? j : -1});  // not the document's joints any more
  c.influences[0] = {{2, 0.2f}, {3, 0.2f}, {4, 0.2f}, {5, 0.2f}, {6, 0.1f}, {7, 0.1f}};
  save(c);
  validate();
}

TEST_F(Writes, PosedMeshWithAnotherSkeletonAndMorphTargets) {
  GlbBuilder builder = two_joint_strip();
  json& primitive = builder.document["meshes"][0]["primitives"][0];
  primitive["targets"] = json::array({{{"POSITION", builder.positions(std::vector<float>(30, 0.25f))},
                                       {"NORMAL", builder.accessor(std::vector<float>(30, 0.0f), "VEC3")}}});
  std::vector<float> tangents;
  for (int v = 0; v < 10; ++v) tangents.insert(tangents.end(), {1, 0, 0, 1});
  primitive["attributes"]["TANGENT"] = builder.accessor(tangents, "VEC4");
  builder.document["nodes"][1]["rotation"] = {0, 0, std::sqrt(0.5), std::sqrt(0.5)};
  builder.document["nodes"][0]["scale"] = {2, 1, 1};
  Character c = read(builder);
  c.joints = {{"only", {10, 0, 0}, -1}};
  c.influences.assign(c.vertices.size(), {{0, 1.0f}});
  save(c);
  validate();
}

TEST_F(Writes, RigidPartsStrangersAndSharedMeshes) {
  GlbBuilder builder = two_joint_strip();
  const json primitive = {{"attributes", {{"POSITION", builder.positions({0, 0, 0, 1, 0, 0, 0, 1, 0})}}}};
  builder.add("meshes", {{"primitives", json::array({primitive, primitive})}});
  builder.add("nodes", {{"name", "lamp"}, {"mesh", 1}, {"translation", {0, 0, 1}}, {"rotation", {0, 0, 1, 0}}});
  builder.document["nodes"][1]["children"] = {3};
  builder.root({{"name", "stone"}, {"mesh", 1}, {"translation", {-5, 0, 0}}});
  Character c = read(builder);
  save(c);
  c.influences[11] = {{0, 0.5f}, {1, 0.5f}};
  save(c);
  for (auto& row : c.influences) row = {{0, 0.5f}, {1, 0.5f}};
  save(c);
  validate();
}

TEST_F(Writes, TwoSkinsInTwoTrees) {
  GlbBuilder builder = two_joint_strip();
  builder.root({{"name", "prop joint"}, {"translation", {3, 0, 0}}});
  builder.add("skins", {{"joints", {3}}, {"skeleton", 3}});
  json mesh = builder.document["meshes"][0];
  mesh["primitives"][0]["attributes"]["JOINTS_0"] = builder.accessor(std::vector<uint8_t>(40, 0), "VEC4");
  std::vector<float> ones;
  for (int v = 0; v < 10; ++v) ones.insert(ones.end(), {1, 0, 0, 0});
  mesh["primitives"][0]["attributes"]["WEIGHTS_0"] = builder.accessor(ones, "VEC4");
  builder.add("meshes", mesh);
  builder.root({{"name", "prop"}, {"mesh", 1}, {"skin", 1}});
  Character c = read(builder);
  ASSERT_EQ(c.joints.size(), 3u);
  save(c);
  for (auto& row : c.influences) row = {{0, 0.4f}, {1, 0.3f}, {2, 0.3f}};  // every mesh now needs every joint
  save(c);
  const Character again = read_gltf(files_.back());
  ASSERT_EQ(again.vertices.size(), c.vertices.size());
  for (size_t v = 0; v < c.vertices.size(); ++v) EXPECT_NEAR(again.vertices[v].x, c.vertices[v].x, 1e-5);
  validate();
}

TEST_F(Writes, ObjectsPicturesAndColors) {
  // The smallest PNG: one red pixel.
  const unsigned char pixel[] = {0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 0x00, 0x00, 0x00, 0x0d, 0x49, 0x48,
                                 0x44, 0x52, 0x00, 0x00, 0x00, 0x01, 0x00, 0x00, 0x00, 0x01, 0x08, 0x02, 0x00, 0x00,
                                 0x00, 0x90, 0x77, 0x53, 0xde, 0x00, 0x00, 0x00, 0x0c, 0x49, 0x44, 0x41, 0x54, 0x78,
                                 0x9c, 0x63, 0xf8, 0xcf, 0xc0, 0x00, 0x00, 0x03, 0x01, 0x01, 0x00, 0xc9, 0xfe, 0x92,
                                 0xef, 0x00, 0x00, 0x00, 0x00, 0x49, 0x45, 0x4e, 0x44, 0xae, 0x42, 0x60, 0x82};
  folder_.write("red.png", {reinterpret_cast<const char*>(pixel), sizeof pixel});
  folder_.write("two.mtl", "newmtl a\nmap_Kd red.png\nd 0.5\nnewmtl b\nKd 0 1 0\nKe 1 1 0\n");
  Character c =
      obj("mtllib two.mtl\nv 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 0 1 0 0 0 1\nv 0 0 1 1 1 1\nvt 0 0\nvt 1 0\nvt 0 1\n"
          "o one\nusemtl a\nf 1/1 2/2 3/3\no two\nusemtl b\nf 1/1 3/2 4/3\nusemtl a\nf 2/1 3/2 4/3\n");
  save(c);
  c.joints = {{"root", {0, 0, 0}, -1}, {"tip", {0, 1, 0}, 0}};
  c.influences.assign(4, {{0, 0.25f}, {1, 0.75f}});
  save(c);
  files_.push_back(folder_.file("text.gltf"));
  write_gltf(files_.back(), c);
  validate();
}

TEST_F(Writes, CompressedInputs) {
  std::vector<Character> read_back;
#ifdef SINEW_HAS_MESHOPT
  read_back.push_back(read(meshopt_packed(two_joint_strip(true))));
#endif
#ifdef SINEW_HAS_DRACO
  read_back.push_back(read(draco_packed(two_joint_strip(true), false)));
#endif
#ifdef SINEW_HAS_ASSIMP
  read_back.push_back(read_mesh(folder_.write("strip.fbx", strip_fbx())));
  read_back.push_back(read_mesh(folder_.write("strip.dae", strip_dae())));
#endif
  if (read_back.empty()) GTEST_SKIP() << "built without meshoptimizer, Draco and Assimp";
  for (Character& c : read_back) {
    save(c);
    for (auto& row : c.influences) row = {{0, 0.5f}, {1, 0.5f}};
    save(c);
  }
  validate();
}

TEST(Validator, SeesAnError) {
  if (validator_is_waived())
    GTEST_SKIP() << "SINEW_SKIP_GLTF_VALIDATOR is set: THE WRITTEN GLB FILES WERE NOT VALIDATED";
  const TempFolder folder;
  GlbBuilder builder = two_joint_strip();
  builder.document["accessors"][0].erase("min");
  EXPECT_EQ(validate_gltf({folder.write("bad.glb", builder.glb())}).status, 1);
}

}  // namespace
