// SPDX-License-Identifier: MIT
// The bundled skeletons: all parse, names once, both sides alike.
#include "sinew_character/predict/skeleton_template.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include "expect_error.hpp"
#include "sinew_character/rig/joint_mirror.hpp"

namespace sinew {
namespace {

TEST(SkeletonTemplate, AllParse) {
  std::set<std::string> kinds;
  for (const TemplateInfo& info : skeleton_templates()) {
    kinds.insert(info.name);
    EXPECT_FALSE(info.about.empty()) << info.name;
    const std::vector<Joint> joints = skeleton_template(info.name);
    EXPECT_GT(joints.size(), 9u) << info.name;
    std::set<std::string> names;
    for (size_t j = 0; j < joints.size(); ++j) {
      EXPECT_TRUE(names.insert(joints[j].name).second) << info.name << " " << joints[j].name;
      EXPECT_EQ(joints[j].name.find_first_of(" \t"), std::string::npos);
      EXPECT_LT(joints[j].parent, static_cast<int>(j)) << info.name << " " << joints[j].name;
      EXPECT_EQ(joints[j].parent < 0, j == 0) << info.name << " has one root";
    }
    for (const Joint& joint : joints) {
      const auto other = std::find_if(joints.begin(), joints.end(),
                                      [&](const Joint& one) { return one.name == other_side_name(joint.name); });
      ASSERT_NE(other, joints.end()) << info.name << " " << joint.name;
      if (side_of_name(joint.name) == Side::kNone) continue;
      EXPECT_EQ(other->position.x, -joint.position.x);
      EXPECT_EQ(other->position.y, joint.position.y);
    }
  }
  EXPECT_EQ(kinds, (std::set<std::string>{"bird", "fish", "hand", "makehuman", "mixamo", "quadruped", "rigify",
                                          "spider", "unreal", "vrm"}));
}

TEST(SkeletonTemplate, NamesAreThoseOfTheConventions) {
  const auto has = [](const char* kind, const char* name, const char* parent) {
    const std::vector<Joint> joints = skeleton_template(kind);
    for (const Joint& joint : joints)
      if (joint.name == name && joint.parent >= 0) return joints[static_cast<size_t>(joint.parent)].name == parent;
    return false;
  };
  EXPECT_TRUE(has("mixamo", "mixamorig:RightHandIndex4", "mixamorig:RightHandIndex3"));
  EXPECT_TRUE(has("unreal", "lowerarm_twist_01_r", "lowerarm_r"));
  EXPECT_TRUE(has("vrm", "rightThumbMetacarpal", "rightHand"));
  EXPECT_TRUE(has("rigify", "DEF-shin.R", "DEF-thigh.R.001"));
  EXPECT_EQ(skeleton_template("mixamo").size(), 65u);
}

TEST(SkeletonTemplate, AnUnknownOneNamesThoseThereAre) {
  EXPECT_ERROR(skeleton_template("biped"), "unknown template biped", "mixamo", "quadruped");
}

}  // namespace
}  // namespace sinew
