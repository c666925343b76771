// SPDX-License-Identifier: MIT
// Rigs from files: what animate reads as a motion, map reads as a skeleton.
#include "sinew_character/motion/map_skeleton.hpp"

#include <gtest/gtest.h>

#include "expect_error.hpp"
#include "make_glb.hpp"
#include "sinew_formats/motion.hpp"
#include "temp_folder.hpp"
#include "walking_motion.hpp"

namespace sinew {
namespace {

TEST(MapRig, NodesThatMoveWithoutAMeshAreOne) {
  const TempFolder folder;
  GlbBuilder builder;
  builder.root({{"name", "hips"}, {"children", {1}}});
  builder.add("nodes", {{"name", "spine"}, {"translation", {0, 1, 0}}});
  EXPECT_ERROR((void)read_map_rig(folder.write("still.glb", builder.glb())), "still.glb", "without a skin");
  nlohmann::json animation = {
      {"name", "a"}, {"samplers", nlohmann::json::array()}, {"channels", nlohmann::json::array()}};
  animation["samplers"].push_back(
      {{"input", builder.accessor(std::vector<float>{0, 1}, "SCALAR")},
       {"output", builder.accessor(std::vector<float>{0, 0, 0, 1, 0, 0, 0.6f, 0.8f}, "VEC4")}});
  animation["channels"].push_back({{"sampler", 0}, {"target", {{"node", 0}, {"path", "rotation"}}}});
  builder.add("animations", animation);
  const MapRig rig = read_map_rig(folder.write("moving.glb", builder.glb()));
  ASSERT_EQ(rig.joints.size(), 2u);
  EXPECT_EQ(rig.joints[1].name, "spine");
  EXPECT_EQ(rig.joints[1].position.y, 1);
}

TEST(MapRig, AMotionIsSeenInItsStance) {
  const TempFolder folder;
  const Motion walk = walking_person(), written = with_random_axes(walk);
  const std::string path = folder.path() + "/walk.bvh";
  write_bvh(path, written, written.clips[0]);
  const MapRig rig = read_map_rig(path);
  for (const Joint& joint : rig.joints) {
    if (joint.name == "Head") {
      EXPECT_GT(joint.position.y, 0.5f);
    }
    if (joint.name == "LeftFoot") {
      EXPECT_LT(joint.position.y, -0.7f);
    }
  }
}

// A fish along z: a head, a tail of three joints, two fins whose tips lie where they are said to.
MapRig fish(const Vec3& tip) {
  MapRig rig;
  rig.joints = {{"a", {0, 0, 0}, -1},
                {"b", {0, 0, 0.6f}, 0},
                {"c", {0, 0, 1}, 1},
                {"d", {0, 0, -0.5f}, 0},
                {"e", {0, 0, -1}, 3},
                {"f", {0, 0, -1.4f}, 4},
                {"g", {0.2f, -0.1f, 0.3f}, 0},
                {"h", {tip.x, tip.y, tip.z}, 6},
                {"i", {-0.2f, -0.1f, 0.3f}, 0},
                {"j", {-tip.x, tip.y, tip.z}, 8}};
  return rig;
}

std::vector<int32_t> sources_of(const MapRig& target, const MapRig& source, MaybeAxis target_up, MaybeAxis source_up) {
  MapSkeletonOptions options;
  options.names = false;
  options.target_up = target_up;
  options.source_up = source_up;
  return map_skeleton(target, source, options).sources;
}

MapRig lying(MapRig rig) {  // z up
  for (Joint& joint : rig.joints) joint.position = {joint.position.x, -joint.position.z, joint.position.y};
  return rig;
}

TEST(MapRig, WhatHasNoLegsHasYUp) {
  const MapRig swept = fish({0.4f, -0.1f, -0.5f}), hanging = fish({0.4f, -0.6f, 0.3f});
  EXPECT_EQ(sources_of(swept, hanging, {}, {}), sources_of(swept, hanging, Axis::kY, Axis::kY));
  EXPECT_EQ(sources_of(hanging, swept, {}, {}), sources_of(hanging, swept, Axis::kY, Axis::kY));
}

TEST(MapRig, ABodyHasItsUpAlongItsLegs) {
  const MapRig person = map_rig_of(walking_person());
  const std::vector<int32_t> wanted = sources_of(person, person, Axis::kY, Axis::kY);
  EXPECT_EQ(sources_of(lying(person), person, {}, {}), wanted);
  EXPECT_EQ(sources_of(person, lying(person), {}, {}), wanted);
}

// Four legs and a tail. With `beside`, hips and spine hang side by side on a root where the hips are.
MapRig animal(bool beside) {
  MapRig rig;
  const auto add = [&](const std::string& name, const Vec3& at, int parent) {
    rig.joints.push_back({name, at, parent});
    return static_cast<int>(rig.joints.size()) - 1;
  };
  const int root = add("root", {0, 1, -0.5f}, -1), hips = beside ? add("hips", {0, 1, -0.5f}, root) : root;
  const int spine = add("spine", {0, 1.02f, -0.2f}, root), chest = add("chest", {0, 1.02f, 0.3f}, spine);
  const int neck = add("neck", {0, 1.2f, 0.5f}, chest), head = add("head", {0, 1.4f, 0.7f}, neck);
  add("nose", {0, 1.38f, 0.95f}, head);
  int tail = hips;
  for (int k = 1; k <= 3; ++k)
    tail = add("tail" + std::to_string(k), {0, 1.0f, -0.5f - 0.15f * static_cast<float>(k)}, tail);
  for (const float side : {1.0f, -1.0f}) {
    const std::string name = side > 0 ? "l_" : "r_";
    for (const bool fore : {false, true}) {
      const float z = fore ? 0.35f : -0.55f, x = side * 0.15f;
      const std::string leg = name + (fore ? "fore" : "hind");
      int at = add(leg + "1", {x, 0.9f, z}, fore ? chest : hips);
      at = add(leg + "2", {x, 0.5f, fore ? z - 0.05f : z + 0.08f}, at);
      at = add(leg + "3", {x, 0.1f, z}, at);
      add(leg + "4", {x, 0, z + 0.12f}, at);
    }
  }
  return rig;
}

TEST(MapRig, HipsBesideTheSpineLeaveTheTrunkWhole) {
  const MapRig plain = animal(false), beside = animal(true);
  const std::vector<int32_t> sources = sources_of(beside, plain, Axis::kY, Axis::kY);
  for (size_t j = 0; j < beside.joints.size(); ++j) {
    const std::string& name = beside.joints[j].name;
    if (name == "root" || name == "hips" || name.rfind("tail", 0) == 0) continue;
    EXPECT_GE(sources[j], 0) << name;
    if (sources[j] < 0) continue;
    EXPECT_EQ(plain.joints[static_cast<size_t>(sources[j])].name, name);
  }
}

// Shoulder, arm and hand, of which the map finds the shoulder to be the upper arm.
TEST(LimbClasses, AShoulderThatMovesAsAnUpperArmIsOne) {
  const auto rig = [](const std::vector<std::string>& names) {
    MapRig rig;
    for (const std::string& name : names) {
      const float x = static_cast<float>(rig.joints.size());
      rig.joints.push_back({name, {x, 1, 0}, static_cast<int>(rig.joints.size()) - 1});
      rig.ends.push_back(0);
    }
    return rig;
  };
  const MapRig target = rig({"Chest", "Shoulder.L", "Arm.L", "Hand.L"}),
               source = rig({"Spine", "LeftArm", "LeftForeArm", "LeftHand"}),
               whole = rig({"Spine", "LeftShoulder", "LeftArm", "LeftHand"});
  const std::vector<int> map = {0, 1, 2, 3};
  EXPECT_EQ(limb_classes(target, {}, &source, map)[1], SINEW_CLASS_UPPER_ARM);
  EXPECT_EQ(limb_classes(target, {}, &source, map)[2], SINEW_CLASS_FOREARM);
  EXPECT_EQ(limb_classes(target, {}, &whole, map)[1], SINEW_CLASS_CLAVICLE);
  EXPECT_EQ(limb_classes(target, {}, &whole, map)[2], SINEW_CLASS_UPPER_ARM);
}

}  // namespace
}  // namespace sinew
