// SPDX-License-Identifier: MIT
// Sides in the names of many makers, and mirror images of joints by name and position.
#include "sinew_character/rig/joint_mirror.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace sinew {
namespace {

TEST(JointMirror, SidesOfNames) {
  const std::vector<std::pair<std::string, std::string>> pairs = {{"mixamorig:LeftArm", "mixamorig:RightArm"},
                                                                  {"leftUpperArm", "rightUpperArm"},
                                                                  {"thigh_l", "thigh_r"},
                                                                  {"Arm.L", "Arm.R"},
                                                                  {"DEF-upper_arm.L.001", "DEF-upper_arm.R.001"},
                                                                  {"L_Arm", "R_Arm"},
                                                                  {"l-arm", "r-arm"},
                                                                  {"LHipJoint", "RHipJoint"},
                                                                  {"Bip01 L UpperArm", "Bip01 R UpperArm"},
                                                                  {"arm_left", "arm_right"},
                                                                  {"ball_l", "ball_r"}};
  for (const auto& [left, right] : pairs) {
    EXPECT_EQ(side_of_name(left), Side::kLeft) << left;
    EXPECT_EQ(side_of_name(right), Side::kRight) << right;
    EXPECT_EQ(other_side_name(left), right);
    EXPECT_EQ(other_side_name(right), left);
  }
  for (const char* name : {"Hips", "Spine.001", "bright", "cleft", "Leftover", "Root", "tail", ""}) {
    EXPECT_EQ(side_of_name(name), Side::kNone) << name;
    EXPECT_EQ(other_side_name(name), name);
  }
}

TEST(JointMirror, PartnersByNameAndByPlace) {
  std::vector<Joint> joints = {{"root", {0.25f, 0, 0}, -1, {}},
                               {"arm_l", {1.25f, 1, 0}, 0, {}},
                               {"arm_r", {-0.75f, 1, 0}, 0, {}},
                               {"hand one", {2.25f, 1, 0}, 1, {}},
                               {"hand other", {-1.75f, 1, 0}, 2, {}}};
  JointMirror mirror = find_joint_mirror(joints);
  EXPECT_TRUE(mirror.exact);
  EXPECT_EQ(mirror.axis, 0u);
  EXPECT_FLOAT_EQ(mirror.plane, 0.25f);
  EXPECT_EQ(mirror.partners, (std::vector<int32_t>{0, 2, 1, 4, 3}));
  for (Joint& joint : joints) joint.position = {0, joint.position.y, joint.position.x};
  mirror = find_joint_mirror(joints);
  EXPECT_TRUE(mirror.exact);
  EXPECT_EQ(mirror.axis, 2u);
  joints[4].position.y = 1.2f;
  mirror = find_joint_mirror(joints);
  EXPECT_FALSE(mirror.exact);
  EXPECT_EQ(mirror.partners[4], -1);
  EXPECT_EQ(mirror.partners[1], 2);
}

TEST(JointMirror, ParentsHaveToBeMirrorImagesToo) {
  const std::vector<Joint> joints = {{"root", {0, 0, 0}, -1, {}},
                                     {"a_l", {1, 0, 0}, 0, {}},
                                     {"a_r", {-1, 0, 0}, 0, {}},
                                     {"b_l", {2, 0, 0}, 1, {}},
                                     {"b_r", {-2, 0, 0}, 0, {}}};
  EXPECT_FALSE(find_joint_mirror(joints).exact);
}

}  // namespace
}  // namespace sinew
