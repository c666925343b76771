// SPDX-License-Identifier: MIT
// Names of joints: what a humanoid's are called, and that none comes twice.
#include <gtest/gtest.h>

#include <cstring>
#include <set>
#include <string>

#include "rig/rig_joint.hpp"
#include "rig_votes.hpp"

namespace sinew::rigging {
namespace {

using sinew_test::FoundRig;
using sinew_test::grid_point;

std::vector<std::string> names_of(const std::vector<RigJoint>& joints) {
  char names[kMaxRigJoints][kMaxJointName];
  std::memset(names, 'x', sizeof names);
  name_joints(joints.data(), static_cast<uint32_t>(joints.size()), names);
  std::vector<std::string> out;
  for (size_t i = 0; i < joints.size(); ++i) {
    EXPECT_NE(std::memchr(names[i], 0, kMaxJointName), nullptr);
    out.emplace_back(names[i]);
  }
  return out;
}

TEST(JointNames, AHumanoidsAreThoseOfHumanoidRigs) {
  const FoundRig found(sinew_test::votes_for(sinew_test::known_humanoid(), 60, 0.004, 7));
  EXPECT_EQ(names_of(found.joints),
            (std::vector<std::string>{
                "Hips",         "Spine",           "Spine1",          "Neck",          "Head",         "Head_end",
                "LeftShoulder", "LeftArm",         "LeftForeArm",     "LeftHand",      "LeftHand_end", "RightShoulder",
                "RightArm",     "RightForeArm",    "RightHand",       "RightHand_end", "LeftUpLeg",    "LeftLeg",
                "LeftFoot",     "LeftToeBase",     "LeftToeBase_end", "RightUpLeg",    "RightLeg",     "RightFoot",
                "RightToeBase", "RightToeBase_end"}));
}

TEST(JointNames, SidesOfJointsThatNothingMirrors) {
  std::vector<RigJoint> joints(5);
  const uint8_t classes[] = {kClassPelvis, kClassThigh, kClassThigh, kClassWing, kClassTail};
  for (size_t i = 0; i < 5; ++i) {
    joints[i] = {
        grid_point(i == 2 ? -0.1 : 0.1, 0, 0), static_cast<int16_t>(i == 0 ? -1 : 0), -1, classes[i], 0, 0, 0, 0};
  }
  EXPECT_EQ(names_of(joints), (std::vector<std::string>{"Hips", "LeftUpLeg", "RightUpLeg", "LeftWing", "Tail"}));
}

TEST(JointNames, TwoEndsOfOneJointHaveNumbers) {
  std::vector<RigJoint> joints(4);
  joints[0] = {grid_point(0, 0, 0), -1, 0, kClassHead, 0, 0, 0, 0};
  joints[1] = {grid_point(0.1, 0, 0), 0, 2, kClassHead, 1, 0, 0, 0};
  joints[2] = {grid_point(-0.1, 0, 0), 0, 1, kClassHead, 1, 0, 0, 0};
  joints[3] = {grid_point(0, 0.1, 0), 0, 3, kClassHead, 0, 0, 0, 0};
  EXPECT_EQ(names_of(joints), (std::vector<std::string>{"Head", "Head_end", "Head_end1", "Head1"}));
}

TEST(JointNames, NoneComesTwiceAndAllFit) {
  for (uint32_t seed = 0; seed < 40; ++seed) {
    const std::vector<std::string> names = names_of(FoundRig(sinew_test::random_votes(1500, 90, seed)).joints);
    EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), names.size()) << seed;
  }
  // As many as there can be, all alike.
  std::vector<RigJoint> joints(kMaxRigJoints);
  for (size_t i = 0; i < joints.size(); ++i) {
    const int16_t before = static_cast<int16_t>(i - 1);
    const bool tip = i % 2 == 1;
    joints[i] = {grid_point(-0.1, 0, 0),
                 static_cast<int16_t>(tip || i == 0 ? before : before - 1),
                 -1,
                 kClassToe,
                 static_cast<uint8_t>(tip ? 1 : 0),
                 0,
                 0,
                 0};
  }
  const std::vector<std::string> names = names_of(joints);
  EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), names.size());
  EXPECT_EQ(names.back(), "RightToeBase95_end");
}

}  // namespace
}  // namespace sinew::rigging
