// SPDX-License-Identifier: MIT
// Limbs and trunk of a body by classes, and what counts as standing.
#include "motion/upright_body.hpp"

#include <gtest/gtest.h>

#include "sinew_character/motion/map_skeleton.hpp"
#include "sinew_formats/base/point.hpp"
#include "walking_motion.hpp"

namespace sinew {
namespace {

std::optional<UprightBody> body_of(const Motion& motion) {
  const MapRig rig = map_rig_of(motion);
  return find_upright_body(rig.joints, limb_classes(rig, {}));
}
std::vector<Point3> positions_of(const Motion& motion, const std::vector<Quaternion>& turns = {}) {
  MotionFrame frame;
  for (const MotionJoint& joint : motion.joints) frame.translations.push_back(joint.offset);
  frame.rotations = turns.empty() ? std::vector<Quaternion>(motion.joints.size(), kNoRotation4) : turns;
  return world_pose(motion, frame).positions;
}
size_t joint_of(const Motion& motion, const std::string& name) {
  for (size_t j = 0; j < motion.joints.size(); ++j)
    if (motion.joints[j].name == name) return j;
  ADD_FAILURE() << name;
  return 0;
}

TEST(UprightBody, IsFoundByClasses) {
  const Motion walk = walking_person();
  const std::optional<UprightBody> body = body_of(walk);
  ASSERT_TRUE(body);
  const auto name = [&](int joint) { return walk.joints.at(static_cast<size_t>(joint)).name; };
  EXPECT_EQ(name(body->hips), "Hips");
  EXPECT_EQ(name(body->chest), "Chest");
  EXPECT_EQ(name(body->head), "Head");
  EXPECT_TRUE(body->sided);
  EXPECT_EQ(name(body->legs[0].upper), "LeftUpLeg");
  EXPECT_EQ(name(body->legs[1].end), "RightFoot");
  EXPECT_EQ(name(body->legs[1].tip), "RightToeBase");
  EXPECT_EQ(name(body->arms[0].middle), "LeftForeArm");
  EXPECT_EQ(name(body->arms[1].end), "RightHand");
  Motion one_leg = walk;
  one_leg.joints[joint_of(walk, "LeftUpLeg")].name = "Prop";
  one_leg.joints[joint_of(walk, "LeftLeg")].name = "Prop2";
  EXPECT_FALSE(body_of(one_leg));
}

TEST(UprightBody, ALegThatBeginsWhereTheHipsAreBeginsAtItsNextJoint) {
  Motion walk = walking_person();
  for (const char* side : {"Left", "Right"}) {  // a joint of its own between hips and thigh, at the hips
    const size_t thigh = joint_of(walk, std::string(side) + "UpLeg");
    walk.joints.push_back({std::string(side) + "Thigh", walk.joints[thigh].parent, {0, 0, 0}});
    walk.joints[thigh].parent = static_cast<int>(walk.joints.size()) - 1;
  }
  const std::optional<UprightBody> body = body_of(walk);
  ASSERT_TRUE(body);
  EXPECT_EQ(walk.joints.at(static_cast<size_t>(body->legs[0].upper)).name, "LeftUpLeg");
}

TEST(UprightBody, StandsWithItsLegsBelowItAndItsSidesAlike) {
  const Motion walk = walking_person();
  const UprightBody body = body_of(walk).value();
  EXPECT_TRUE(is_upright(body, positions_of(walk)));
  const auto turned = [&](const char* name, const Quaternion& turn) {
    std::vector<Quaternion> turns(walk.joints.size(), kNoRotation4);
    turns[joint_of(walk, name)] = turn;
    return positions_of(walk, turns);
  };
  EXPECT_TRUE(is_upright(body, turned("LeftHand", axis_rotation(2, 1))));
  EXPECT_TRUE(is_upright(body, turned("Hips", axis_rotation(1, 2)))) << "it may face any direction";
  EXPECT_FALSE(is_upright(body, turned("Hips", axis_rotation(2, 3)))) << "upside down";
  EXPECT_FALSE(is_upright(body, turned("Spine", axis_rotation(0, 1.7)))) << "bent over";
  EXPECT_FALSE(is_upright(body, turned("LeftUpLeg", axis_rotation(0, -1)))) << "a step";
  EXPECT_FALSE(is_upright(body, turned("RightLeg", axis_rotation(0, 2)))) << "a knee";
  EXPECT_FALSE(is_upright(body, turned("LeftForeArm", axis_rotation(1, 2.9)))) << "a folded arm";
}

}  // namespace
}  // namespace sinew
