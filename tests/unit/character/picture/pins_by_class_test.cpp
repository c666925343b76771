// SPDX-License-Identifier: MIT
// Joints are paired by what they are, whatever they hang on.
#include "picture/pins_by_class.hpp"

#include <gtest/gtest.h>

#include "sinew/rig.h"

namespace sinew {
namespace {

LabelledSkeleton skeleton_of(const std::vector<std::pair<std::string, uint8_t>>& joints) {
  LabelledSkeleton out;
  for (const auto& [name, joint_class] : joints) {
    out.joints.push_back({name, {}, static_cast<int>(out.joints.size()) - 1, {}});
    out.classes.push_back(joint_class);
    out.ends.push_back(name.ends_with("_end") ? 1 : 0);
  }
  return out;
}

TEST(PinsByClass, LimbsArePairedBySideAndOrder) {
  const LabelledSkeleton target = skeleton_of({{"Hips", SINEW_CLASS_PELVIS},
                                               {"Spine", SINEW_CLASS_SPINE},
                                               {"RightForeArm", SINEW_CLASS_FOREARM},
                                               {"LeftArm", SINEW_CLASS_UPPER_ARM},
                                               {"LeftArm1", SINEW_CLASS_UPPER_ARM},
                                               {"LeftHand_end", SINEW_CLASS_HAND},
                                               {"Tail", SINEW_CLASS_TAIL}});
  const LabelledSkeleton source = skeleton_of({{"mixamorig:Hips", SINEW_CLASS_PELVIS},
                                               {"mixamorig:Spine", SINEW_CLASS_SPINE},
                                               {"mixamorig:LeftArm", SINEW_CLASS_UPPER_ARM},
                                               {"mixamorig:LeftForeArm", SINEW_CLASS_FOREARM},
                                               {"mixamorig:LeftHand", SINEW_CLASS_HAND},
                                               {"mixamorig:RightForeArm", SINEW_CLASS_FOREARM},
                                               {"mixamorig:Tail", SINEW_CLASS_TAIL}});
  std::vector<int32_t> sources(target.joints.size(), -1);
  for (const sinew_map_pin& pin : pins_by_class(target, source)) sources[pin.target] = pin.source;
  EXPECT_EQ(sources[0], 0);
  EXPECT_EQ(sources[1], -1) << "spines follow";
  EXPECT_EQ(sources[2], 5) << "not the left one";
  EXPECT_EQ(sources[3], 2);
  EXPECT_EQ(sources[4], -1) << "the source has one";
  EXPECT_EQ(sources[5], -1) << "an end";
  EXPECT_EQ(sources[6], -1) << "no limb";
}

}  // namespace
}  // namespace sinew
