// SPDX-License-Identifier: MIT
// Conventions: what the table calls a joint is read back as that joint.
#include <gtest/gtest.h>

#include <string>

#include "names/joint_name.hpp"
#include "sinew/names.h"

namespace sinew::names {
namespace {

std::string name_of(uint32_t naming, uint32_t joint_class, int side, uint32_t index) {
  char name[SINEW_JOINT_NAME_BYTES];
  return sinew_joint_standard_name(naming, joint_class, side, index, name) == SINEW_OK ? name : "";
}

TEST(StandardNames, Conventions) {
  EXPECT_EQ(name_of(SINEW_NAMING_SINEW, SINEW_CLASS_UPPER_ARM, 1, 0), "LeftArm");
  EXPECT_EQ(name_of(SINEW_NAMING_SINEW, SINEW_CLASS_SPINE, 0, 2), "Spine2");
  EXPECT_EQ(name_of(SINEW_NAMING_MIXAMO, SINEW_CLASS_CALF, -1, 0), "mixamorig:RightLeg");
  EXPECT_EQ(name_of(SINEW_NAMING_MIXAMO, SINEW_CLASS_THUMB, 1, 2), "mixamorig:LeftHandThumb3");
  EXPECT_EQ(name_of(SINEW_NAMING_VRM, SINEW_CLASS_SPINE, 0, 2), "upperChest");
  EXPECT_EQ(name_of(SINEW_NAMING_VRM, SINEW_CLASS_SPINE, 0, 3), "");
  EXPECT_EQ(name_of(SINEW_NAMING_UNREAL, SINEW_CLASS_INDEX, -1, 0), "index_01_r");
  EXPECT_EQ(name_of(SINEW_NAMING_RIGIFY, SINEW_CLASS_SPINE, 0, 0), "DEF-spine.001");
  EXPECT_EQ(name_of(SINEW_NAMING_MAKEHUMAN, SINEW_CLASS_RING, 1, 1), "finger4-2.L");
  EXPECT_EQ(name_of(SINEW_NAMING_UNREAL, SINEW_CLASS_UPPER_ARM, 0, 0), "") << "which side?";
  EXPECT_EQ(name_of(SINEW_NAMING_UNREAL, SINEW_CLASS_UPPER_ARM, 1, 1), "") << "it has one";
  EXPECT_EQ(name_of(SINEW_NAMING_UNREAL, 99, 0, 0), "");
  char name[SINEW_JOINT_NAME_BYTES] = "kept";
  EXPECT_EQ(sinew_joint_standard_name(6, 0, 0, 0, name), SINEW_ERROR_ARGUMENT);
  EXPECT_EQ(sinew_joint_standard_name(0, 0, 2, 0, name), SINEW_ERROR_ARGUMENT);
  EXPECT_EQ(sinew_joint_standard_name(0, 0, 0, 0, nullptr), SINEW_ERROR_ARGUMENT);
  EXPECT_EQ(sinew_joint_standard_name(2, 13, 0, 0, name), SINEW_ERROR_RANGE);
  EXPECT_STREQ(name, "kept");
}

TEST(StandardNames, AreReadBack) {
  for (uint32_t naming = 0; sinew_naming_text(naming) != nullptr; ++naming) {
    for (uint32_t joint_class = 0; joint_class <= SINEW_CLASS_PROP; ++joint_class) {
      for (const int side : {0, 1, -1}) {
        for (uint32_t index = 0; index < 4; ++index) {
          const std::string name = name_of(naming, joint_class, side, index);
          if (name.empty() || joint_class == SINEW_CLASS_OTHER) continue;
          const JointName got = read_joint_name(name.c_str());
          if (name.find("Left") != std::string::npos || name.find(".L") != std::string::npos)
            EXPECT_EQ(got.side, 1) << name;
          EXPECT_NE(got.part, Part::kNone) << name;
          if (got.side == 0 || naming == SINEW_NAMING_SINEW) continue;
          EXPECT_EQ(got.side, side) << name;
        }
      }
    }
  }
}

}  // namespace
}  // namespace sinew::names
