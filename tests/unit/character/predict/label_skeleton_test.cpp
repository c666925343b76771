// SPDX-License-Identifier: MIT
// Classes of whole skeletons by their names: every template's, and those of makers with habits of their own.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "sinew_character/predict/fit_skeleton.hpp"
#include "sinew_character/predict/skeleton_template.hpp"
#include "sinew_formats/error.hpp"

namespace sinew {
namespace {

uint8_t class_of(const LabeledSkeleton& s, const std::string& name) {
  for (size_t j = 0; j < s.joints.size(); ++j)
    if (s.joints[j].name == name) return s.classes[j];
  ADD_FAILURE() << "no joint " << name;
  return SINEW_CLASS_OTHER;
}

TEST(LabelSkeleton, EveryTemplatesClassesAreKnown) {
  for (const TemplateInfo& info : skeleton_templates()) {
    const LabeledSkeleton s = label_skeleton(skeleton_template(info.name));
    for (size_t j = 0; j < s.joints.size(); ++j)
      EXPECT_NE(s.classes[j], SINEW_CLASS_OTHER) << info.name << " " << s.joints[j].name;
    const bool body = info.name != "hand" && info.name != "fish" && info.name != "spider" && info.name != "bird";
    for (const uint8_t wanted : {SINEW_CLASS_PELVIS, SINEW_CLASS_HEAD, SINEW_CLASS_UPPER_ARM, SINEW_CLASS_CALF})
      EXPECT_TRUE(!body || std::count(s.classes.begin(), s.classes.end(), wanted) > 0) << info.name << " " << +wanted;
  }
}

TEST(LabelSkeleton, ATemplateFittedToItselfStaysItself) {
  for (const TemplateInfo& info : skeleton_templates()) {
    const LabeledSkeleton s = label_skeleton(skeleton_template(info.name));
    const FittedSkeleton fitted = fit_skeleton(s, s, {});
    for (size_t j = 0; j < s.joints.size(); ++j) {
      EXPECT_NEAR(fitted.joints[j].position.x, s.joints[j].position.x, 3e-6f) << info.name << " " << s.joints[j].name;
      EXPECT_NEAR(fitted.joints[j].position.y, s.joints[j].position.y, 3e-6f) << info.name << " " << s.joints[j].name;
      EXPECT_NEAR(fitted.joints[j].position.z, s.joints[j].position.z, 3e-6f) << info.name << " " << s.joints[j].name;
    }
    EXPECT_EQ(fitted.symmetric, info.name != "hand") << info.name;
  }
}

TEST(LabelSkeleton, OneConventionFitsIntoAnother) {
  const std::vector<std::string> humans = {"mixamo", "unreal", "vrm", "rigify"};
  for (const std::string& mine : humans) {
    for (const std::string& other : humans) {
      const LabeledSkeleton s = label_skeleton(skeleton_template(mine));
      const FittedSkeleton fitted = fit_skeleton(s, label_skeleton(skeleton_template(other)), {});
      EXPECT_GE(fitted.matched, 19u) << mine << " " << other;
      for (size_t j = 0; j < s.joints.size(); ++j)  // they are drawn on one body
        EXPECT_NEAR(fitted.joints[j].position.y, s.joints[j].position.y, 0.02f)
            << mine << " in " << other << " " << s.joints[j].name;
    }
  }
}

TEST(LabelSkeleton, SharedPrefixesAndSidesInFront) {
  std::vector<Joint> joints;
  for (const char* name : {"J_Bip_C_Hips", "J_Bip_C_Spine", "J_Bip_C_Head", "J_Bip_L_UpperArm", "J_Bip_R_UpperArm"})
    joints.push_back({name, {}, static_cast<int>(joints.size()) - 1, {}});
  const LabeledSkeleton s = label_skeleton(joints);
  EXPECT_EQ(class_of(s, "J_Bip_C_Hips"), SINEW_CLASS_PELVIS);
  EXPECT_EQ(class_of(s, "J_Bip_L_UpperArm"), SINEW_CLASS_UPPER_ARM);
}

TEST(LabelSkeleton, RigifysSpineHasAPelvisAndAHead) {
  const LabeledSkeleton s = label_skeleton(skeleton_template("rigify"));
  EXPECT_EQ(class_of(s, "DEF-spine"), SINEW_CLASS_PELVIS);
  EXPECT_EQ(class_of(s, "DEF-spine.003"), SINEW_CLASS_SPINE);
  EXPECT_EQ(class_of(s, "DEF-spine.004"), SINEW_CLASS_NECK);
  EXPECT_EQ(class_of(s, "DEF-spine.006"), SINEW_CLASS_HEAD);
  EXPECT_EQ(class_of(s, "DEF-pelvis.L"), kClassDetail);
}

TEST(LabelSkeleton, ControlsAreDetailsAndEndsAreEnds) {
  const LabeledSkeleton unreal = label_skeleton(skeleton_template("unreal"));
  EXPECT_EQ(class_of(unreal, "ik_foot_l"), kClassDetail);
  const LabeledSkeleton mixamo = label_skeleton(skeleton_template("mixamo"));
  for (size_t j = 0; j < mixamo.joints.size(); ++j) {
    const std::string& name = mixamo.joints[j].name;
    EXPECT_EQ(mixamo.ends[j] != 0, name.find("_End") != std::string::npos) << name;
  }
}

TEST(LabelSkeleton, AFileInThePlaceOfAPrediction) {
  std::vector<Joint> joints = {{"Head", {0, 2, 0}, 1, {}},
                               {"Hips", {0, 1, 0}, -1, {}},
                               {"LeftArm", {1, 1.5f, 0}, 1, {}},
                               {"RightArm", {-1, 1.5f, 0}, 1, {}},
                               {"Head_end", {0, 2.5f, 0}, 0, {}}};
  const PredictedSkeleton s = skeleton_from_joints(joints);
  ASSERT_EQ(s.joints.size(), 5u);
  for (size_t j = 0; j < 5; ++j) EXPECT_LT(s.joints[j].parent, static_cast<int>(j));
  EXPECT_TRUE(s.mirrored);
  EXPECT_EQ(s.facing, 0u);
  EXPECT_EQ(std::count(s.ends.begin(), s.ends.end(), 1), 1);
  joints[2].position.y = 1;
  EXPECT_FALSE(skeleton_from_joints(joints).mirrored);
  joints[1].parent = 4;
  EXPECT_THROW(skeleton_from_joints(joints), Error);
  EXPECT_THROW(skeleton_from_joints({}), Error);
}

}  // namespace
}  // namespace sinew
