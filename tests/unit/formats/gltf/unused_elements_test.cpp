// SPDX-License-Identifier: MIT
// What a document loses when its meshes get another skeleton.
#include <gtest/gtest.h>

#include <algorithm>

#include "glb_round.hpp"

namespace sinew {
namespace {

using nlohmann::json;

std::vector<std::string> node_names(const json& document) {
  std::vector<std::string> names;
  for (const json& node : document["nodes"]) names.push_back(node.value("name", ""));
  return names;
}

// The strip with an animated skeleton, a leaf below its knee, a second skin that no mesh has, and a camera in the file.
GlbBuilder animated_strip() {
  GlbBuilder builder = two_joint_strip();
  const int leaf = builder.add("nodes", {{"name", "knee_end"}});
  builder.document["nodes"][1]["children"].push_back(leaf);
  builder.add("skins", {{"joints", {leaf}}});
  builder.add("cameras",
              {{"type", "orthographic"}, {"orthographic", {{"xmag", 1}, {"ymag", 1}, {"zfar", 9}, {"znear", 1}}}});
  builder.root({{"name", "viewer"}, {"camera", 0}});
  const int times = builder.accessor(std::vector<float>{0, 1}, "SCALAR");
  const int moves = builder.accessor(std::vector<float>{0, 0, 0, 1, 0, 0}, "VEC3");
  const json samplers = {{{"input", times}, {"output", moves}}};
  const auto channel = [](int node) {
    return json{{"sampler", 0}, {"target", {{"node", node}, {"path", "translation"}}}};
  };
  const int viewer = static_cast<int>(builder.document["nodes"].size()) - 1;
  builder.add("animations", {{"name", "walk"}, {"channels", {channel(1)}}, {"samplers", samplers}});
  builder.add("animations", {{"name", "look"}, {"channels", {channel(1), channel(viewer)}}, {"samplers", samplers}});
  return builder;
}

Character with_new_skeleton(const GlbBuilder& builder) {
  Character c = read(builder);
  c.joints = {{"trunk", {10, 0, 0}, -1}, {"tip", {10, 2, 0}, 0}};
  c.influences.assign(c.vertices.size(), {{0, 0.5f}, {1, 0.5f}});
  return c;
}

TEST(UnusedElements, AnOldSkeletonIsGone) {
  const Character c = with_new_skeleton(animated_strip());
  const std::string glb = written(c);
  const json out = json_of_glb(glb);
  EXPECT_EQ(out["skins"].size(), 1u);
  for (const std::string& name : node_names(out))
    EXPECT_TRUE(name != "hip" && name != "knee" && name != "knee_end") << name;
  ASSERT_EQ(out["animations"].size(), 1u);
  EXPECT_EQ(out["animations"][0]["name"], "look");
  ASSERT_EQ(out["animations"][0]["channels"].size(), 1u);
  const size_t moved = out["animations"][0]["channels"][0]["target"]["node"];
  EXPECT_EQ(out["nodes"][moved]["name"], "viewer");
  const Character again = reread(glb);
  ASSERT_EQ(again.joints.size(), 2u);
  ASSERT_EQ(again.vertices.size(), c.vertices.size());
  for (size_t v = 0; v < c.vertices.size(); ++v) EXPECT_NEAR(again.vertices[v].y, c.vertices[v].y, 1e-5);
}

TEST(UnusedElements, WhatAnOldJointCarriesStays) {
  GlbBuilder builder = animated_strip();
  builder.document["nodes"][1]["camera"] = 0;
  const json out = json_of_glb(written(with_new_skeleton(builder)));
  const std::vector<std::string> names = node_names(out);
  for (const char* name : {"hip", "knee"}) EXPECT_EQ(std::count(names.begin(), names.end(), name), 1) << name;
  EXPECT_EQ(std::count(names.begin(), names.end(), "knee_end"), 0);
  EXPECT_EQ(out["skins"].size(), 1u);
}

TEST(UnusedElements, UnknownExtensionsKeepTheNodes) {
  GlbBuilder builder = animated_strip();
  builder.document["extensionsUsed"] = {"EXT_someones"};
  const json out = json_of_glb(written(with_new_skeleton(builder)));
  const std::vector<std::string> names = node_names(out);
  EXPECT_EQ(std::count(names.begin(), names.end(), "knee"), 1);
  EXPECT_EQ(out["skins"].size(), 1u);
}

TEST(UnusedElements, AVrmWithoutItsBonesIsNone) {
  GlbBuilder builder = animated_strip();
  builder.document["extensionsUsed"] = {"VRMC_vrm", "VRMC_springBone"};
  builder.document["extensions"] = {{"VRMC_vrm", {{"humanoid", {{"humanBones", {{"hips", {{"node", 0}}}}}}}}},
                                    {"VRMC_springBone", {{"springs", {{{"joints", {{{"node", 1}}}}}}}}}};
  const json out = json_of_glb(written(with_new_skeleton(builder)));
  EXPECT_FALSE(out.contains("extensions"));
  EXPECT_FALSE(out.contains("extensionsUsed"));
}

}  // namespace
}  // namespace sinew
