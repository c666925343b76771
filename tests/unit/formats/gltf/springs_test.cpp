// SPDX-License-Identifier: MIT
// VRMC_springBone into Springs and back.
#include "sinew_formats/springs.hpp"

#include <gtest/gtest.h>

#include "expect_error.hpp"
#include "glb_round.hpp"

namespace sinew {
namespace {

using nlohmann::json;

void expect_at(const Point3& found, const Point3& expected) {
  for (size_t c = 0; c < 3; ++c) EXPECT_NEAR(found[c], expected[c], 1e-6) << c;
}

// The strip's hip and knee (turned a quarter about z), and below the knee a node that is no joint.
GlbBuilder strip_with_springs() {
  GlbBuilder builder = two_joint_strip();
  builder.document["nodes"][1]["rotation"] = {0, 0, std::sqrt(0.5), std::sqrt(0.5)};
  const int end = builder.add("nodes", {{"name", "knee_end"}, {"translation", {1, 0, 0}}});
  builder.document["nodes"][1]["children"].push_back(end);
  // The bind pose has the knee's own axes.
  const std::vector<float> binds = {1, 0,  0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0,  0, 0, 1,
                                    0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, -2, 0, 0, 1};
  builder.document["skins"][0]["inverseBindMatrices"] = builder.accessor(binds, "MAT4");
  builder.document["extensionsUsed"] = {"VRMC_springBone", "VRMC_springBone_extended_collider"};
  builder.document["extensions"]["VRMC_springBone"] = {
      {"specVersion", "1.0"},
      {"colliders",
       {{{"node", 0}, {"shape", {{"sphere", {{"offset", {0, 1, 0}}, {"radius", 0.5}}}}}},
        {{"node", 1}, {"shape", {{"capsule", {{"offset", {0, 0, 0}}, {"tail", {1, 0, 0}}, {"radius", 0.25}}}}}},
        {{"node", end}, {"shape", {{"sphere", {{"radius", 0.125}}}}}},
        {{"node", 1},
         {"shape", {{"sphere", {{"offset", {0, -10000, 0}}, {"radius", 0}}}}},
         {"extensions",
          {{"VRMC_springBone_extended_collider",
            {{"specVersion", "1.0"}, {"shape", {{"plane", {{"offset", {0, 0, 0}}, {"normal", {0, 1, 0}}}}}}}}}}}}},
      {"colliderGroups", {{{"name", "legs"}, {"colliders", {0, 1}}}, {{"colliders", {2, 3}}}}},
      {"springs",
       {{{"name", "tail"},
         {"center", 0},
         {"colliderGroups", {1, 0}},
         {"joints",
          {{{"node", 0},
            {"hitRadius", 0.05},
            {"stiffness", 2},
            {"gravityPower", 0.5},
            {"gravityDir", {0, 0, 1}},
            {"dragForce", 0.25}},
           {{"node", 1}},
           {{"node", end}}}}}}}};
  return builder;
}

TEST(Springs, AreReadInTheWorldsAxes) {
  const Character c = read(strip_with_springs());
  const std::optional<Springs> springs = read_springs("hero.vrm", c);
  ASSERT_TRUE(springs);
  EXPECT_TRUE(springs->notes.empty());
  ASSERT_EQ(springs->colliders.size(), 4u);
  expect_at(springs->colliders[0].offset, {0, 1, 0});
  EXPECT_EQ(springs->colliders[1].shape, ColliderShape::kCapsule);
  expect_at(springs->colliders[1].tail, {0, 1, 0});
  EXPECT_EQ(springs->colliders[2].joint, 1u);  // above the node that is no joint
  expect_at(springs->colliders[2].offset, {0, 1, 0});
  EXPECT_EQ(springs->colliders[3].shape, ColliderShape::kPlane);
  expect_at(springs->colliders[3].tail, {-1, 0, 0});
  ASSERT_EQ(springs->groups.size(), 2u);
  EXPECT_EQ(springs->groups[0].name, "legs");
  ASSERT_EQ(springs->chains.size(), 1u);
  const SpringChain& chain = springs->chains[0];
  EXPECT_EQ(chain.name, "tail");
  EXPECT_EQ(chain.center, 0);
  EXPECT_EQ(chain.groups, (std::vector<size_t>{1, 0}));
  ASSERT_EQ(chain.joints.size(), 2u);
  EXPECT_EQ(chain.turning_joints(), 2u);
  expect_at(*chain.end, {0, 1, 0});
  EXPECT_EQ(chain.joints[0].stiffness, 2);
  EXPECT_EQ(chain.joints[0].gravity_power, 0.5);
  expect_at(chain.joints[0].gravity, {0, 0, 1});
  EXPECT_EQ(chain.joints[0].drag, 0.25);
  EXPECT_EQ(chain.joints[1].stiffness, 1);  // the specification's defaults
  EXPECT_EQ(chain.joints[1].drag, 0.5);
}

TEST(Springs, SurviveWritingToTheNumber) {
  const GlbBuilder builder = strip_with_springs();
  const Character c = read(builder);
  const Springs springs = *read_springs("hero.glb", c);
  GlbOptions options;
  options.springs = &springs;
  const std::string glb = written(c, options);
  const json before = builder.document["extensions"]["VRMC_springBone"],
             after = json_of_glb(glb)["extensions"]["VRMC_springBone"];
  EXPECT_EQ(json_of_glb(glb)["nodes"].size(), builder.document["nodes"].size());  // the end is the node that was there
  EXPECT_EQ(after["colliderGroups"], before["colliderGroups"]);
  EXPECT_EQ(after["springs"][0]["joints"][0], before["springs"][0]["joints"][0]);
  EXPECT_EQ(after["springs"][0]["joints"][2], before["springs"][0]["joints"][2]);
  EXPECT_EQ(after["springs"][0]["center"], 0);
  const Springs again = *read_springs("hero.glb", reread(glb));
  ASSERT_EQ(again.colliders.size(), springs.colliders.size());
  for (size_t i = 0; i < springs.colliders.size(); ++i) {
    EXPECT_EQ(again.colliders[i].shape, springs.colliders[i].shape);
    EXPECT_EQ(again.colliders[i].joint, springs.colliders[i].joint);
    EXPECT_EQ(again.colliders[i].radius, springs.colliders[i].radius);
    expect_at(again.colliders[i].offset, springs.colliders[i].offset);
    expect_at(again.colliders[i].tail, springs.colliders[i].tail);
  }
  // Without springs of ours the file's own stay to the byte, unknown members too.
  GlbBuilder extras = builder;
  extras.document["extensions"]["VRMC_springBone"]["springs"][0]["extras"] = {{"mine", 1}};
  EXPECT_EQ(json_of_glb(written(read(extras)))["extensions"]["VRMC_springBone"],
            extras.document["extensions"]["VRMC_springBone"]);
}

TEST(Springs, WhatAFileHasBesideStaysWhereOnesAreAdded) {
  GlbBuilder builder = strip_with_springs();
  json& before = builder.document["extensions"]["VRMC_springBone"];
  before["springs"][0]["joints"][0]["extensions"] = {{"MINE_limit", {{"angle", 30}}}};
  before["colliders"].push_back(
      {{"node", 2}, {"shape", {{"sphere", {{"radius", 1}}}}}});  // of a node that hangs on no joint
  const Character c = read(builder);
  Springs springs = *read_springs("hero.glb", c);
  EXPECT_EQ(springs.notes.size(), 1u);
  springs.chains[0].joints[0].drag = 0.75;
  springs.colliders.push_back({"new", ColliderShape::kSphere, 1, {}, {}, 0.5});
  springs.groups.push_back({"new", {springs.colliders.size() - 1}});
  SpringChain chain;
  chain.name = "other";
  chain.joints = {{1}};
  chain.end = Point3{0, 1, 0};
  chain.groups = {springs.groups.size() - 1, 0};
  springs.chains.push_back(chain);
  GlbOptions options;
  options.springs = &springs;
  json expected = before, after = json_of_glb(written(c, options))["extensions"]["VRMC_springBone"];
  expected["springs"][0]["joints"][0]["dragForce"] = 0.75;
  EXPECT_EQ(after["springs"][0], expected["springs"][0]);
  EXPECT_EQ(after["springs"][1]["colliderGroups"], json({2, 0}));
  EXPECT_EQ(after["colliderGroups"][2]["colliders"], json({5}));
  ASSERT_EQ(after["colliders"].size(), 6u);
  after["colliders"].erase(5);
  EXPECT_EQ(after["colliders"], expected["colliders"]);
}

TEST(Springs, AnEndWithoutANodeGetsOne) {
  GlbBuilder builder = two_joint_strip();
  const Character c = read(builder);
  Springs springs;
  springs.colliders.push_back({"", ColliderShape::kInsideCapsule, 0, {0, 0.5, 0}, {0, 2, 0}, 3});
  springs.groups.push_back({"room", {0}});
  SpringChain chain;
  chain.joints = {{1}};
  chain.end = Point3{0, 0, -0.5};
  chain.groups = {0};
  springs.chains.push_back(chain);
  GlbOptions options;
  options.springs = &springs;
  const std::string glb = written(c, options);
  const json document = json_of_glb(glb);
  EXPECT_EQ(document["nodes"].back()["name"], "knee_end");
  const Springs again = *read_springs("hero.glb", reread(glb));
  ASSERT_EQ(again.chains.size(), 1u);
  expect_at(*again.chains[0].end, {0, 0, -0.5});
  EXPECT_EQ(again.colliders[0].shape, ColliderShape::kInsideCapsule);
  // None at all: nothing is left of the extension.
  const Springs none;
  options.springs = &none;
  EXPECT_FALSE(json_of_glb(written(reread(glb), options)).contains("extensions"));
}

// VRMC_springBone_limit 1.0-draft: a cone keeps an angle, a hinge an axis, which is the x of a frame whose y is the bone.
TEST(Springs, LimitsAreConesAndHinges) {
  GlbBuilder builder = strip_with_springs();
  json& joints = builder.document["extensions"]["VRMC_springBone"]["springs"][0]["joints"];
  joints[0]["extensions"]["VRMC_springBone_limit"] = {{"specVersion", "1.0-draft"},
                                                      {"limit", {{"cone", {{"angle", 0.5}}}}}};
  joints[1]["extensions"]["VRMC_springBone_limit"] = {{"specVersion", "1.0-draft"},
                                                      {"limit", {{"hinge", {{"angle", 0.25}}}}}};
  const Character c = read(builder);
  Springs springs = *read_springs("hero.vrm", c);
  EXPECT_TRUE(springs.notes.empty());
  const std::vector<SpringJoint>& read_joints = springs.chains[0].joints;
  EXPECT_NEAR(read_joints[0].limit, 0.5 * 57.29577951, 1e-6);
  EXPECT_EQ(length(read_joints[0].hinge), 0);
  EXPECT_NEAR(read_joints[1].limit, 0.25 * 57.29577951, 1e-6);
  // The knee's bone goes along its x; the shortest arc from y takes the frame's x to -y, which is the world's x there.
  expect_at(read_joints[1].hinge, {1, 0, 0});
  // Of a document that knows nothing of them any axis comes back.
  springs.chains[0].source = -1;
  for (const Point3& axis : {Point3{1, 0, 0}, Point3{0, 0, 1}, Point3{-0.6, 0, 0.8}}) {
    springs.chains[0].joints[1].hinge = axis;
    springs.chains[0].joints[1].limit = 0;
    GlbOptions options;
    options.springs = &springs;
    const std::string glb = written(c, options);
    const json used = json_of_glb(glb)["extensionsUsed"];
    EXPECT_NE(std::find(used.begin(), used.end(), "VRMC_springBone_limit"), used.end());
    const Springs again = *read_springs("hero.glb", reread(glb));
    expect_at(again.chains.back().joints[1].hinge, axis);
    EXPECT_EQ(again.chains.back().joints[1].limit, 0);
    EXPECT_NEAR(again.chains.back().joints[0].limit, 0.5 * 57.29577951, 1e-6);
  }
}

TEST(Springs, SmallFaultsAreTold) {
  GlbBuilder builder = strip_with_springs();
  json& springs = builder.document["extensions"]["VRMC_springBone"]["springs"];
  springs[0]["joints"][0]["dragForce"] = -0.1;
  springs.push_back({{"joints", {{{"node", 1}}, {{"node", 0}}}}});  // the other way round
  const Springs read_back = *read_springs("hero.vrm", read(builder));
  EXPECT_EQ(read_back.chains[0].joints[0].drag, 0);
  ASSERT_GE(read_back.notes.size(), 2u);
  EXPECT_NE(read_back.notes[0].find("dragForce is -0.1"), std::string::npos) << read_back.notes[0];
  EXPECT_NE(read_back.notes[1].find("is not a descendant of"), std::string::npos) << read_back.notes[1];
}

TEST(Springs, FollowASkeletonWithFewerJoints) {
  Character c = read(strip_with_springs());
  // The knee becomes part of the hip.
  c.joints.pop_back();
  for (auto& row : c.influences) row = {{0, 1.0f}};
  const Springs left = *read_springs("hero.glb", reread(written(c)));
  ASSERT_EQ(left.chains.size(), 1u);
  ASSERT_EQ(left.chains[0].joints.size(), 1u);
  expect_at(*left.chains[0].end, {0, 3, 0});  // two to the knee and one to its end
  ASSERT_EQ(left.colliders.size(), 4u);
  for (const SpringCollider& collider : left.colliders) EXPECT_EQ(collider.joint, 0u);
  expect_at(left.colliders[1].offset, {0, 2, 0});
  expect_at(left.colliders[1].tail, {0, 3, 0});
  EXPECT_EQ(left.groups[0].colliders.size(), 2u);
}

TEST(Springs, OfOlderFilesAreRead) {
  GlbBuilder builder = two_joint_strip();
  builder.document["extensionsUsed"] = {"VRM"};
  builder.document["extensions"]["VRM"]["secondaryAnimation"] = {
      {"boneGroups",
       {{{"comment", "tail"},
         {"stiffiness", 0.7},
         {"gravityPower", 0.2},
         {"gravityDir", {{"x", 0}, {"y", -1}, {"z", 0.5}}},
         {"dragForce", 0.3},
         {"hitRadius", 0.05},
         {"center", -1},
         {"bones", json::array({0})},
         {"colliderGroups", json::array({0})}}}},
      {"colliderGroups",
       {{{"node", 1}, {"colliders", {{{"offset", {{"x", 0.1}, {"y", 0.2}, {"z", 0.3}}}, {"radius", 0.15}}}}}}}};
  const Springs springs = *read_springs("hero.vrm", read(builder));
  ASSERT_EQ(springs.chains.size(), 1u);
  EXPECT_EQ(springs.chains[0].turning_joints(), 2u);
  expect_at(*springs.chains[0].end, {0, 0.07, 0});
  expect_at(springs.chains[0].joints[1].gravity, {0, -1, -0.5});
  expect_at(springs.colliders[0].offset, {0.1, 0.2, -0.3});
  EXPECT_FALSE(read_springs("hero.glb", read(two_joint_strip())));
}

TEST(Springs, RefuseWhatIsBroken) {
  const auto read_with = [](const char* at, const json& value) {
    GlbBuilder builder = strip_with_springs();
    builder.document["extensions"]["VRMC_springBone"][json::json_pointer(at)] = value;
    (void)read_springs("hero.vrm", read(builder));
  };
  EXPECT_ERROR(read_with("/colliders/0/node", 99), "hero.vrm", "colliders[0].node", "below 4", "99");
  EXPECT_ERROR(read_with("/colliders/1/shape/capsule/radius", -1), "colliders[1].shape.capsule.radius", "0 or more",
               "-1");
  EXPECT_ERROR(read_with("/colliders/0/shape", json::object()), "colliders[0].shape", "a sphere or a capsule");
  EXPECT_ERROR(read_with("/colliders/0/shape/sphere/offset", {1, 2}), "three numbers");
  EXPECT_ERROR(read_with("/colliderGroups/0/colliders/1", 7), "colliderGroups[0].colliders", "below 4");
  EXPECT_ERROR(read_with("/springs/0/colliderGroups/0", 2), "springs[0].colliderGroups", "below 2");
  EXPECT_ERROR(read_with("/springs/0/center", "hip"), "springs[0].center");
  EXPECT_ERROR(read_with("/springs/0/joints/0/stiffness", "much"), "stiffness", "much");
  EXPECT_ERROR(read_with("/springs/0/joints", 3), "springs[0].joints", "a list");
  EXPECT_ERROR(read_with("/springs", json::array({1})), "springs[0]", "an object");
}

}  // namespace
}  // namespace sinew
