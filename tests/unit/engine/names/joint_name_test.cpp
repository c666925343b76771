// SPDX-License-Identifier: MIT
// What names say, in the conventions of many programs and makers.
#include "names/joint_name.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace sinew::names {
namespace {

struct Known {
  const char* name;
  Part part;   // of all words
  Part plain;  // for maps
  int side;
  int number;
  bool end;
};

TEST(JointName, ConventionsAreRead) {
  const Known known[] = {
      {"mixamorig:LeftForeArm", Part::kLowerArm, Part::kLowerArm, 1, 0, false},
      {"upperarm_r", Part::kUpperArm, Part::kUpperArm, -1, 0, false},
      {"spine_03", Part::kSpine, Part::kSpine, 0, 3, false},
      {"Bip01 L Thigh", Part::kUpLeg, Part::kUpLeg, 1, 1, false},
      {"DEF-shin.R.001", Part::kLowLeg, Part::kLowLeg, -1, 1, false},
      {"HeadTop_End", Part::kHead, Part::kNone, 0, 0, true},
      {"Head_end", Part::kHead, Part::kHead, 0, 0, true},
      {"lhand", Part::kHand, Part::kHand, 1, 0, false},
      {"armleft", Part::kUpperArm, Part::kUpperArm, 1, 0, false},
      {"RightHandIndex2", Part::kIndex, Part::kIndex, -1, 2, false},
      {"FrontLowerLeg.L", Part::kLowLeg, Part::kForeLeg, 1, 0, false},
      {"frontleg_l", Part::kLeg, Part::kForeLeg, 1, 0, false},
      {"Leg.BackB.R", Part::kLeg, Part::kHindLeg, -1, 0, false},
      {"LowerBack", Part::kSpine, Part::kSpine, 0, 0, false},
      {"LeftKnee", Part::kLowLeg, Part::kLowLeg, 1, 0, false},
      {"char:def_l_elbow", Part::kLowerArm, Part::kLowerArm, 1, 0, false},
      {"lCollar", Part::kShoulder, Part::kShoulder, 1, 0, false},
      {"rButtock", Part::kHipJoint, Part::kHipJoint, -1, 0, false},
      {"Femur_R", Part::kUpLeg, Part::kUpLeg, -1, 0, false},
      {"humerus.L", Part::kUpperArm, Part::kUpperArm, 1, 0, false},
      {"LeftHip", Part::kHips, Part::kUpLeg, 1, 0, false},
      {"pelvis.L", Part::kHipJoint, Part::kHipJoint, 1, 0, false},
      {"MiddleHand.L", Part::kHand, Part::kHand, 1, 0, false},
      {"LeftHandMiddle1", Part::kMiddle, Part::kMiddle, 1, 1, false},
      {"ThighMid_l", Part::kUpLeg, Part::kUpLeg, 1, 0, false},
      {"Little_Proximal_L", Part::kPinky, Part::kNone, 1, 0, false},
      {"PalmR.L", Part::kMeta, Part::kMeta, 1, 0, false},
      {"upperarm_twist_01_l", Part::kUpperArm, Part::kNone, 1, 1, false},
      {"EyeBlinkTop", Part::kEye, Part::kNone, 0, 0, false},
      {"FaceJnt", Part::kFace, Part::kFace, 0, 0, false},
      {"Body", Part::kHips, Part::kHips, 0, 0, false},
      {"BodyArmor", Part::kNone, Part::kNone, 0, 0, false},
      {"LizardRArmPalm", Part::kHand, Part::kNone, -1, 0, false},
      {"toe_01_tip.L", Part::kToe, Part::kToe, 1, 1, false},
      {"bright", Part::kNone, Part::kNone, 0, 0, false},
      {"armature|Hips", Part::kHips, Part::kHips, 0, 0, false},
      {"\xEF\xBC\xA8\xEF\xBD\x85\xEF\xBD\x81\xEF\xBD\x84", Part::kHead, Part::kHead, 0, 0, false},  // full-width Head
      {"J7", Part::kNone, Part::kNone, 0, 7, false},
      {"pCube1", Part::kNone, Part::kNone, 0, 1, false},
      {"", Part::kNone, Part::kNone, 0, 0, false},
  };
  for (const Known& one : known) {
    const JointName got = read_joint_name(one.name);
    EXPECT_EQ(static_cast<int>(got.part), static_cast<int>(one.part)) << one.name;
    EXPECT_EQ(static_cast<int>(got.plain), static_cast<int>(one.plain)) << one.name;
    EXPECT_EQ(got.side, one.side) << one.name;
    EXPECT_EQ(got.number, one.number) << one.name;
    EXPECT_EQ(got.is_end(), one.end) << one.name;
  }
}

// Every user of the table reads a name by read_joint_name(), so a row that is found here is found by all.
TEST(JointName, EveryRowOfTheTableIsRead) {
  int count = 0;
  const Word* const all = words(&count);
  ASSERT_GT(count, 150);
  for (int i = 0; i < count; ++i) {
    const Word& word = all[i];
    EXPECT_EQ(find_word({word.text, static_cast<int>(std::string(word.text).size())}), &word)
        << word.text << " is there twice";
    const JointName got = read_joint_name(word.text);
    const bool side = (word.flags & (kLeft | kRight)) != 0;
    EXPECT_EQ(got.side, (word.flags & kLeft) != 0 ? 1 : side ? -1 : 0) << word.text;
    if (!side) {
      EXPECT_EQ(got.flags & ~kHind, word.flags & ~kHind) << word.text;
    }
    EXPECT_EQ(static_cast<int>(got.part), static_cast<int>(word.part)) << word.text;
    if (word.part == Part::kNone || side) continue;
    for (const std::string& name : {std::string("Left_") + word.text, std::string("x:") + word.text + ".R",
                                    std::string("Bip01_") + word.text + "_end"})
      EXPECT_NE(static_cast<int>(read_joint_name(name.c_str()).part), static_cast<int>(Part::kNone)) << name;
  }
}

TEST(JointName, NothingIsTooLongOrStrange) {
  EXPECT_EQ(read_joint_name(std::string(5000, 'a').c_str()).part, Part::kNone);
  std::string mixed;
  for (int i = 0; i < 500; ++i) mixed += i % 2 == 0 ? "a" : "1";
  EXPECT_LE(read_joint_name(mixed.c_str()).count, kMostWords);
  EXPECT_EQ(read_joint_name((std::string(400, 'x') + ":LeftHand").c_str()).part, Part::kHand);
  EXPECT_EQ(read_joint_name("\xC3\xA4rm\xFF\x01").side, 0);
  EXPECT_EQ(read_joint_name("\xEF\xBC").part, Part::kNone);
  EXPECT_EQ(read_joint_name(nullptr).count, 0);
  EXPECT_EQ(read_joint_name("x9999999999").number, 999999);
}

TEST(JointName, NumbersThatToolsAppendAreNone) {
  EXPECT_EQ(read_joint_name("LeftHandIndex4").own_number, 4);
  EXPECT_EQ(read_joint_name("spine_03_021").own_number, 3);
  EXPECT_EQ(read_joint_name("finger2.001").own_number, 2);
  EXPECT_EQ(read_joint_name("head").own_number, -1);
  EXPECT_EQ(read_joint_name("").own_number, -1);
}

// Three letters and digits behind two underscores, whatever they would say as words; an end, a number and a word before them count.
TEST(JointName, IdsThatToolsAppendSayNothing) {
  for (const char* id : {"__k3W", "__Rdx", "__vyh", "__7L2"}) {
    const JointName thigh = read_joint_name(("Bip01_L_Thigh" + std::string(id)).c_str());
    EXPECT_EQ(thigh.plain, Part::kUpLeg) << id;
    EXPECT_EQ(thigh.side, 1) << id;
    EXPECT_TRUE(thigh.exact) << id;
    EXPECT_EQ(read_joint_name(("Tail2" + std::string(id)).c_str()).own_number, 2) << id;
  }
  EXPECT_TRUE(read_joint_name("Head__end").is_end());
  EXPECT_EQ(read_joint_name("Tail__003").own_number, read_joint_name("Tail_003").own_number);
}

TEST(JointName, SidesAreExchangedInTheirOwnWriting) {
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
                                                                  {"LEFT_ARM", "RIGHT_ARM"},
                                                                  {"lhand", "rhand"},
                                                                  {"armleft", "armright"},
                                                                  {"ball_l", "ball_r"}};
  for (const auto& [left, right] : pairs) {
    EXPECT_EQ(read_joint_name(left.c_str()).side, 1) << left;
    EXPECT_EQ(read_joint_name(right.c_str()).side, -1) << right;
    char other[64];
    ASSERT_TRUE(other_side_name(left.c_str(), other, sizeof other)) << left;
    EXPECT_EQ(other, right);
    ASSERT_TRUE(other_side_name(right.c_str(), other, sizeof other)) << right;
    EXPECT_EQ(other, left);
    EXPECT_EQ(read_joint_name(left.c_str()).other_side_key, read_joint_name(right.c_str()).other_side_key) << left;
    EXPECT_FALSE(other_side_name(left.c_str(), other, right.size())) << "no room for the 0";
  }
  for (const char* name : {"Hips", "Spine.001", "bright", "cleft", "Leftover", "Root", "tail", "leg", "ring", ""})
    EXPECT_EQ(read_joint_name(name).side, 0) << name;
}

TEST(JointName, OverlapIsSharedOverAll) {
  const JointName a = read_joint_name("upper_arm_twist"), b = read_joint_name("arm_twist_2");
  EXPECT_DOUBLE_EQ(overlap(a.hashes, a.count, b.hashes, b.count), 0.5);
  EXPECT_EQ(overlap(a.hashes, a.count, b.hashes, 0), 0);
}

}  // namespace
}  // namespace sinew::names
