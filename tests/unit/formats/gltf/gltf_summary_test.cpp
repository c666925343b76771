// SPDX-License-Identifier: MIT
// What a glTF holds: meshes and their skins, rest against bind pose, animations, morph targets, extensions.
#include "sinew_formats/gltf_summary.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "expect_error.hpp"
#include "make_glb.hpp"
#include "temp_folder.hpp"

namespace sinew {
namespace {

using nlohmann::json;

GltfSummary summary_of(const GlbBuilder& builder) {
  const TempFolder folder;
  folder.write("file.glb", builder.glb());
  return summarize_gltf(folder.file("file.glb"));
}

TEST(GltfSummary, NamesWhatIsThere) {
  GlbBuilder builder = two_joint_strip(true);
  // A sword that hangs on the knee, a mesh that nothing shows, a lamp outside of the scene.
  json triangle = {{"attributes", {{"POSITION", builder.positions({0, 0, 0, 1, 0, 0, 0, 1, 0})}}}};
  const int sword = builder.add("meshes", {{"name", "sword"}, {"primitives", json::array({triangle, triangle})}});
  builder.document["nodes"][1]["children"] = {builder.add("nodes", {{"name", "hand"}, {"mesh", sword}})};
  builder.add("meshes", {{"primitives", json::array({triangle})}});
  builder.add("nodes", {{"name", "lamp"}, {"mesh", sword}});
  json& primitive = builder.document["meshes"][0]["primitives"][0];
  primitive["targets"] = {{{"POSITION", builder.positions(std::vector<float>(36, 0))}},
                          {{"POSITION", builder.positions(std::vector<float>(36, 0))}}};
  builder.document["meshes"][0]["extras"] = {{"targetNames", {"smile"}}};
  builder.add("materials", {{"name", "skin"}});
  builder.add("images", {{"uri", "nowhere.png"}});
  const int times = builder.accessor(std::vector<float>{0, 0.5f, 1.5f}, "SCALAR");
  const int turns = builder.accessor(std::vector<float>{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}, "VEC4");
  builder.add("animations", {{"name", "walk"},
                             {"samplers", {{{"input", times}, {"output", turns}}}},
                             {"channels", {{{"sampler", 0}, {"target", {{"node", 1}, {"path", "rotation"}}}}}}});
  builder.document["extensionsUsed"] = {"KHR_materials_unlit"};
  builder.document["asset"]["generator"] = "by hand";

  const GltfSummary s = summary_of(builder);
  EXPECT_EQ(s.generator, "by hand");
  ASSERT_EQ(s.meshes.size(), 4u);
  EXPECT_EQ(s.meshes[0].name, "strip");
  EXPECT_EQ(s.meshes[0].node, "body");
  EXPECT_EQ(s.meshes[0].vertices, 12u);
  EXPECT_EQ(s.meshes[0].skin, 0);
  EXPECT_EQ(s.meshes[0].morph_targets, (std::vector<std::string>{"smile", "target_1"}));
  EXPECT_EQ(s.meshes[1].name, "sword");
  EXPECT_EQ(s.meshes[1].joint, "knee");
  EXPECT_EQ(s.meshes[1].primitives, 2u);
  EXPECT_EQ(s.meshes[1].vertices, 6u);
  EXPECT_TRUE(s.meshes[1].in_scene);
  EXPECT_EQ(s.meshes[2].node, "lamp");
  EXPECT_FALSE(s.meshes[2].in_scene);
  EXPECT_EQ(s.meshes[3].name, "mesh_2");
  EXPECT_EQ(s.meshes[3].node, "");
  ASSERT_EQ(s.skins.size(), 1u);
  EXPECT_EQ(s.skins[0].joints, 2u);
  EXPECT_EQ(s.skins[0].joints_with_weight, 2u);
  EXPECT_EQ(s.skins[0].meshes, 1u);
  EXPECT_EQ(s.materials, (std::vector<std::string>{"skin"}));
  ASSERT_EQ(s.images.size(), 1u);
  EXPECT_EQ(s.images[0].name, "nowhere.png");
  EXPECT_EQ(s.images[0].bytes, 0u);
  ASSERT_EQ(s.animations.size(), 1u);
  EXPECT_EQ(s.animations[0].name, "walk");
  EXPECT_EQ(s.animations[0].seconds, 1.5);
  EXPECT_EQ(s.animations[0].channels, 1u);
  EXPECT_EQ(s.extensions_used, (std::vector<std::string>{"KHR_materials_unlit"}));
  EXPECT_TRUE(s.extensions_required.empty());
}

TEST(GltfSummary, TellsRestFromBindPose) {
  GlbBuilder builder = two_joint_strip();
  EXPECT_EQ(summary_of(builder).skins[0].joints_apart, 0u);
  EXPECT_EQ(summary_of(builder).skins[0].deviation, 0);
  // The knee by 90 degrees about Z: of its vertices (1, 4) goes farthest, by (-3, -1), on a strip 4 long.
  builder.document["nodes"][1]["rotation"] = {0, 0, std::sqrt(0.5), std::sqrt(0.5)};
  const GltfSummary posed = summary_of(builder);
  EXPECT_EQ(posed.skins[0].joints_apart, 1u);
  EXPECT_NEAR(posed.skins[0].deviation, std::sqrt(10.0) / 4, 1e-6);
  EXPECT_EQ(posed.skins[0].farthest, "knee");
}

TEST(GltfSummary, WholeModelsMayStandElsewhere) {
  GlbBuilder builder = two_joint_strip();
  builder.document["nodes"][0]["translation"] = {0, 50, 0};
  builder.document["nodes"][0]["scale"] = {3, 3, 3};
  EXPECT_NEAR(summary_of(builder).skins[0].deviation, 0, 1e-12);
}

TEST(GltfSummary, NeedsNoMeshButSoundReferences) {
  GlbBuilder empty;
  empty.root({{"name", "nothing"}});
  EXPECT_EQ(summary_of(empty).nodes, 1u);
  EXPECT_TRUE(summary_of(empty).meshes.empty());
  GlbBuilder builder = two_joint_strip();
  builder.document["nodes"][2]["mesh"] = 7;
  EXPECT_ERROR(summary_of(builder), "expected a mesh and a skin of the file");
  builder = two_joint_strip();
  builder.document["skins"][0]["joints"] = {0, 9};
  EXPECT_ERROR(summary_of(builder), "expected joints below 3, found 9");
}

}  // namespace
}  // namespace sinew
