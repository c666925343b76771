// SPDX-License-Identifier: MIT
// The extension VRM of 0.x turned into those of 1.0.
#include <gtest/gtest.h>

#include <algorithm>

#include "gltf/gltf_source.hpp"
#include "gltf/vrm.hpp"

namespace sinew {
namespace {

// Nodes: 0 head, 1 a lock of hair of three joints 1-2-3 that forks at 1 to 4, 5 the face's mesh.
Json older() {
  Json zero = {
      {"meta",
       {{"title", "Mia"},
        {"author", "Ann"},
        {"version", "2"},
        {"reference", "a parent"},
        {"allowedUserName", "Everyone"},
        {"violentUssageName", "Disallow"},
        {"sexualUssageName", "Allow"},
        {"commercialUssageName", "Allow"},
        {"licenseName", "CC_BY_NC"},
        {"texture", 0}}},
      {"humanoid", {{"humanBones", Json::array({{{"bone", "head"}, {"node", 0}}})}}},
      {"firstPerson",
       {{"firstPersonBone", 0},
        {"firstPersonBoneOffset", {{"x", 0}, {"y", 0.06}, {"z", 0.1}}},
        {"meshAnnotations", {{{"mesh", 0}, {"firstPersonFlag", "ThirdPersonOnly"}}}},
        {"lookAtTypeName", "BlendShape"},
        {"lookAtHorizontalInner", {{"xRange", 80}, {"yRange", 1}}}}},
      {"blendShapeMaster",
       {{"blendShapeGroups",
         {{{"name", "Joy"},
           {"presetName", "joy"},
           {"binds", {{{"mesh", 0}, {"index", 3}, {"weight", 50}}}},
           {"materialValues",
            {{{"materialName", "skin"}, {"propertyName", "_Color"}, {"targetValue", {1, 0, 0, 1}}},
             {{"materialName", "skin"}, {"propertyName", "_Cutoff"}, {"targetValue", {1, 0, 0, 1}}}}}},
          {{"name", "Wink"}, {"presetName", "unknown"}, {"isBinary", true}}}}}},
      {"secondaryAnimation",
       {{"boneGroups",
         {{{"comment", "hair"},
           {"stiffiness", 0.7},
           {"gravityPower", 0.2},
           {"gravityDir", {{"x", 0}, {"y", -1}, {"z", 0}}},
           {"dragForce", 0.3},
           {"hitRadius", 0.05},
           {"center", -1},
           {"bones", Json::array({1})},
           {"colliderGroups", Json::array({0})}}}},
        {"colliderGroups",
         {{{"node", 0}, {"colliders", {{{"offset", {{"x", 0.1}, {"y", 0.2}, {"z", 0.3}}}, {"radius", 0.15}}}}}}}}},
      {"materialProperties", {{{"shader", "VRM/MToon"}}}}};
  return {{"nodes",
           {{{"name", "head"}, {"children", {1, 5}}},
            {{"name", "hair"}, {"translation", {0, 0.1, 0}}, {"children", {2, 4}}},
            {{"name", "hair2"}, {"translation", {0, -0.2, 0}}, {"children", Json::array({3})}},
            {{"name", "hair3"}, {"translation", {0, -0.2, 0}}},
            {{"name", "fringe"}, {"translation", {0, 0, -0.5}}},
            {{"name", "face"}, {"mesh", 0}}}},
          {"materials", {{{"name", "skin"}}}},
          {"textures", {{{"source", 4}}}},
          {"extensionsUsed", {"VRM", "KHR_materials_unlit"}},
          {"extensions", {{"VRM", std::move(zero)}}}};
}

TEST(VrmOne, MetaExpressionsAndViewAreTranslated) {
  Json document = older();
  const std::vector<std::string> notes = turn_vrm_zero_into_one(&document);
  EXPECT_FALSE(document["extensions"].contains("VRM"));
  EXPECT_EQ(document["extensionsUsed"], Json({"KHR_materials_unlit", "VRMC_springBone", "VRMC_vrm"}));
  const Json& one = document["extensions"]["VRMC_vrm"];
  EXPECT_EQ(one["meta"]["name"], "Mia");
  EXPECT_EQ(one["meta"]["authors"], Json::array({"Ann"}));
  EXPECT_EQ(one["meta"]["references"], Json::array({"a parent"}));
  EXPECT_EQ(one["meta"]["avatarPermission"], "everyone");
  EXPECT_EQ(one["meta"]["allowExcessivelyViolentUsage"], false);
  EXPECT_EQ(one["meta"]["allowExcessivelySexualUsage"], true);
  EXPECT_EQ(one["meta"]["commercialUsage"],
            "personalNonProfit");  // the license says so, though the other word allows it
  EXPECT_EQ(one["meta"]["thumbnailImage"], 4);
  const Json& happy = one["expressions"]["preset"]["happy"];
  EXPECT_EQ(happy["morphTargetBinds"], Json::array({{{"node", 5}, {"index", 3}, {"weight", 0.5}}}));
  EXPECT_EQ(happy["materialColorBinds"],
            Json::array({{{"material", 0}, {"type", "color"}, {"targetValue", {1.0, 0.0, 0.0, 1.0}}}}));
  EXPECT_EQ(one["expressions"]["custom"]["Wink"]["isBinary"], true);
  EXPECT_EQ(one["firstPerson"]["meshAnnotations"], Json::array({{{"node", 5}, {"type", "thirdPersonOnly"}}}));
  EXPECT_EQ(one["lookAt"]["type"], "expression");
  EXPECT_EQ(one["lookAt"]["offsetFromHeadBone"], Json({0.0, 0.06, -0.1}));
  EXPECT_EQ(one["lookAt"]["rangeMapHorizontalInner"], Json({{"inputMaxValue", 80.0}, {"outputScale", 1.0}}));
  ASSERT_EQ(notes.size(), 3u);
  EXPECT_NE(notes[0].find("2 expressions, 2 spring chains"), std::string::npos) << notes[0];
  EXPECT_NE(notes[1].find("1 MToon"), std::string::npos) << notes[1];
  EXPECT_NE(notes[2].find("1 material changes"), std::string::npos) << notes[2];
}

TEST(VrmOne, SpringsAreChainsWithEnds) {
  Json document = older();
  (void)turn_vrm_zero_into_one(&document);
  const Json& springs = document["extensions"]["VRMC_springBone"]["springs"];
  ASSERT_EQ(springs.size(), 2u);
  const auto nodes_of = [](const Json& spring) {
    std::vector<size_t> nodes;
    for (const Json& joint : spring["joints"]) nodes.push_back(joint["node"]);
    return nodes;
  };
  EXPECT_EQ(nodes_of(springs[0]), (std::vector<size_t>{1, 2, 3, 6}));
  EXPECT_EQ(nodes_of(springs[1]), (std::vector<size_t>{4, 7}));
  EXPECT_EQ(springs[0]["joints"][0]["stiffness"], 0.7);
  EXPECT_EQ(springs[0]["joints"][0]["gravityDir"], Json({-0.0, -1.0, 0.0}));
  EXPECT_FALSE(springs[0]["joints"][3].contains("stiffness"));
  EXPECT_EQ(springs[0]["colliderGroups"], Json::array({0}));
  EXPECT_FALSE(springs[0].contains("center"));
  EXPECT_NEAR(document["nodes"][6]["translation"][1].get<double>(), -0.07, 1e-9);
  EXPECT_EQ(document["nodes"][3]["children"], Json::array({6}));
  EXPECT_NEAR(document["nodes"][7]["translation"][2].get<double>(), -0.07, 1e-9);
  const Json& collider = document["extensions"]["VRMC_springBone"]["colliders"][0];
  EXPECT_EQ(collider["node"], 0);
  EXPECT_EQ(collider["shape"]["sphere"]["offset"], Json({0.1, 0.2, -0.3}));
}

TEST(VrmOne, WithoutTheOlderExtensionNothingChanges) {
  Json document = older();
  document["extensions"]["VRMC_vrm"] = Json::object();
  const Json before = document;
  EXPECT_TRUE(turn_vrm_zero_into_one(&document).empty());
  EXPECT_EQ(document, before);
}

}  // namespace
}  // namespace sinew
