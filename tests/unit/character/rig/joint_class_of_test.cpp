// SPDX-License-Identifier: MIT
// Classes of joints by the names that the usual makers give.
#include "sinew_character/joint_class_of.hpp"

#include <gtest/gtest.h>

#include <utility>

namespace sinew {
namespace {

using Below = std::vector<std::string_view>;

// "detail" where there is none.
std::string class_text(const std::string& name, const Below& below = {}) {
  const std::optional<JointClass> found = joint_class_of(name, below);
  return found ? joint_class_text(*found) : "detail";
}

// Name and class; a joint that stands in a limb has something below it.
using Named = std::vector<std::pair<std::string, std::string>>;
void expect_classes(const Named& rig, const Below& below) {
  for (const auto& [name, expected] : rig) EXPECT_EQ(class_text(name, below), expected) << name;
}

TEST(JointClassOf, Mixamo) {
  expect_classes({{"mixamorig:Hips", "pelvis"},
                  {"mixamorig:Spine2", "spine"},
                  {"mixamorig:Neck", "neck"},
                  {"mixamorig:Head", "head"},
                  {"mixamorig:HeadTop_End", "head"},
                  {"mixamorig:LeftShoulder", "clavicle"},
                  {"mixamorig:LeftArm", "upperarm"},
                  {"mixamorig:RightForeArm", "forearm"},
                  {"mixamorig:RightHand", "hand"},
                  {"mixamorig:RightHandThumb1", "detail"},
                  {"mixamorig:LeftHandMiddle1", "detail"},
                  {"mixamorig:LeftUpLeg", "thigh"},
                  {"mixamorig:LeftLeg", "calf"},
                  {"mixamorig:LeftFoot", "foot"},
                  {"mixamorig:LeftToeBase", "toe"},
                  {"LeftLeg", "calf"}},
                 {"LeftFoot"});
}

TEST(JointClassOf, Unreal) {
  expect_classes({{"root", "pelvis"},
                  {"pelvis", "pelvis"},
                  {"spine_03", "spine"},
                  {"neck_01", "neck"},
                  {"clavicle_l", "clavicle"},
                  {"upperarm_l", "upperarm"},
                  {"upperarm_twist_01_l", "detail"},
                  {"lowerarm_r", "forearm"},
                  {"hand_r", "hand"},
                  {"index_01_r", "detail"},
                  {"thigh_l", "thigh"},
                  {"calf_l", "calf"},
                  {"foot_l", "foot"},
                  {"ball_l", "toe"}},
                 {"ball_l"});
}

TEST(JointClassOf, Rigify) {
  expect_classes({{"DEF-spine.003", "spine"},
                  {"DEF-shoulder.L", "clavicle"},
                  {"DEF-upper_arm.L.001", "upperarm"},
                  {"DEF-forearm.R", "forearm"},
                  {"DEF-hand.R", "hand"},
                  {"DEF-f_index.01.L", "detail"},
                  {"DEF-thumb.01.L", "detail"},
                  {"DEF-breast.L", "detail"},
                  {"DEF-thigh.L", "thigh"},
                  {"DEF-shin.L", "calf"},
                  {"DEF-foot.L", "foot"},
                  {"DEF-toe.L", "toe"}},
                 {"DEF-toe.L"});
}

TEST(JointClassOf, MakeHuman) {
  expect_classes({{"root", "pelvis"},
                  {"spine05", "spine"},
                  {"neck02", "neck"},
                  {"pelvis.L", "detail"},
                  {"clavicle.L", "clavicle"},
                  {"shoulder01.L", "detail"},
                  {"upperarm01.L", "upperarm"},
                  {"upperarm02.L", "detail"},
                  {"lowerarm01.R", "forearm"},
                  {"lowerarm02.R", "detail"},
                  {"wrist.R", "hand"},
                  {"metacarpal2.R", "detail"},
                  {"finger3-1.R", "detail"},
                  {"upperleg01.L", "thigh"},
                  {"upperleg02.L", "detail"},
                  {"lowerleg01.L", "calf"},
                  {"foot.L", "foot"},
                  {"toe1-1.L", "detail"},
                  {"orbicularis03.L", "detail"},
                  {"jaw", "detail"},
                  {"eye.R", "detail"}},
                 {"x"});
}

TEST(JointClassOf, Quaternius) {
  expect_classes(
      {{"Body", "pelvis"},         {"Hips", "pelvis"},         {"Abdomen", "spine"},      {"Torso", "spine"},
       {"Shoulder.L", "clavicle"}, {"UpperArm.L", "upperarm"}, {"LowerArm.L", "forearm"}, {"Palm.L", "hand"},
       {"Middle1.L", "detail"},    {"MiddleHand.L", "hand"},   {"UpperLeg.R", "thigh"},   {"LowerLeg.R", "calf"},
       {"Foot.R", "foot"},         {"Tail1", "tail"},          {"Tailor", "other"},       {"Ear.L", "ear"},
       {"Wing.R", "wing"},         {"TopFin", "wing"},         {"Finial", "other"},       {"Hair3", "hair"},
       {"Bone.003", "other"}},
      {"x"});
}

TEST(JointClassOf, LegsDependOnWhatIsBoundBelow) {
  EXPECT_EQ(class_text("FrontLeg.L", {"FrontUpLeg.L"}), "clavicle");
  EXPECT_EQ(class_text("FrontLeg.L", {"FrontLowLeg.L"}), "upperarm");
  EXPECT_EQ(class_text("BackLeg.R", {"BackLowLeg.R", "BackUPLEG.R"}), "hip");
  EXPECT_EQ(class_text("BackLeg.R"), "thigh");
  EXPECT_EQ(class_text("FrontUpLeg.L", {"x"}), "upperarm");
  EXPECT_EQ(class_text("FrontLowerLeg.L"), "forearm");
  EXPECT_EQ(class_text("FrontFoot.L"), "hand");
  EXPECT_EQ(class_text("BackShoulder.L"), "hip");
  EXPECT_EQ(class_text("leg.L", {"foot.L"}), "calf");
  EXPECT_EQ(class_text("leg.L"), "thigh") << "a leg of one bone";
  EXPECT_EQ(class_text("leg", {"foot"}), "thigh") << "no side: nobody says that it is the lower one";
  EXPECT_EQ(class_text("Shoulders"), "spine");
}

TEST(JointClassOf, AHipOfOneSideBeginsALeg) {
  EXPECT_EQ(class_text("LeftHip", {"LeftKnee"}), "thigh");
  EXPECT_EQ(class_text("hip.R", {"upleg.R"}), "hip");
  EXPECT_EQ(class_text("hip", {"LeftKnee"}), "pelvis");
}

TEST(JointClassOf, PlainNames) {
  EXPECT_EQ(plain_joint_name("mixamorig:LeftForeArm"), "forearm");
  EXPECT_EQ(plain_joint_name("Leftover"), "leftover") << "no capital behind it: no side";
  EXPECT_EQ(plain_joint_name("l-upper_arm.002"), "upperarm");
  EXPECT_EQ(plain_joint_name("Leg.FrontA.L_end"), "legfrontaend");
  EXPECT_EQ(plain_joint_name("RThumb"), "thumb");
  EXPECT_EQ(plain_joint_name("a.L.R"), "ar") << "the gap between two sides belongs to the first";
  EXPECT_EQ(plain_joint_name("_L.001"), "");
  EXPECT_EQ(plain_joint_name(""), "");
  EXPECT_EQ(class_text(""), "other");
  EXPECT_EQ(class_text("leaf"), "other");
  EXPECT_EQ(class_text("Arm.L_leaf"), "upperarm");
}

}  // namespace
}  // namespace sinew
