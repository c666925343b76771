// SPDX-License-Identifier: MIT
// Which limbs of a predicted skeleton are told as doubtful.
#include "sinew_character/predict/limb_doubts.hpp"

#include <gtest/gtest.h>

namespace sinew {
namespace {

struct Known {
  const char* name;
  float x, y;
  int parent;
  uint8_t joint_class;
};

// A person with arms out and one leg to each side, sure of all of it.
PredictedSkeleton person() {
  constexpr Known kJoints[] = {{"Hips", 0, 1, -1, SINEW_CLASS_PELVIS},
                               {"Spine", 0, 1.3f, 0, SINEW_CLASS_SPINE},
                               {"Head", 0, 1.6f, 1, SINEW_CLASS_HEAD},
                               {"LeftArm", .2f, 1.4f, 1, SINEW_CLASS_UPPER_ARM},
                               {"LeftForeArm", .5f, 1.4f, 3, SINEW_CLASS_FOREARM},
                               {"LeftHand", .8f, 1.4f, 4, SINEW_CLASS_HAND},
                               {"RightArm", -.2f, 1.4f, 1, SINEW_CLASS_UPPER_ARM},
                               {"RightForeArm", -.5f, 1.4f, 6, SINEW_CLASS_FOREARM},
                               {"RightHand", -.8f, 1.4f, 7, SINEW_CLASS_HAND},
                               {"LeftUpLeg", .1f, .9f, 0, SINEW_CLASS_THIGH},
                               {"LeftLeg", .1f, .5f, 9, SINEW_CLASS_CALF},
                               {"LeftFoot", .1f, .1f, 10, SINEW_CLASS_FOOT},
                               {"RightUpLeg", -.1f, .9f, 0, SINEW_CLASS_THIGH},
                               {"RightLeg", -.1f, .5f, 12, SINEW_CLASS_CALF},
                               {"RightFoot", -.1f, .1f, 13, SINEW_CLASS_FOOT}};
  PredictedSkeleton skeleton;
  for (const Known& one : kJoints) {
    skeleton.joints.push_back({one.name, {one.x, one.y, 0}, one.parent, true});
    skeleton.classes.push_back(one.joint_class);
    skeleton.ends.push_back(0);
    skeleton.partners.push_back(-1);
    skeleton.confidence.push_back(0.95f);
    skeleton.parent_confidence.push_back(0.9f);
  }
  skeleton.spread = 0.01f;
  skeleton.usable = 0.95f;
  return skeleton;
}

TEST(LimbDoubts, ASureSkeletonHasNone) {
  EXPECT_EQ(limb_doubts(person()).size(), 4u);
  EXPECT_TRUE(doubtful_limbs(person()).empty());
  EXPECT_EQ(doubts_text({}), "");
}

TEST(LimbDoubts, ALimbThatGuessesIsNamed) {
  PredictedSkeleton skeleton = person();
  for (const size_t j : {3u, 4u, 5u}) skeleton.confidence[j] = 0.05f;
  skeleton.spread = 0.08f;
  const std::vector<LimbDoubt> limbs = doubtful_limbs(skeleton);
  ASSERT_EQ(limbs.size(), 1u);
  EXPECT_EQ(limbs[0].name, "LeftArm");
  EXPECT_EQ(limbs[0].joints, (std::vector<int>{3, 4, 5}));
  EXPECT_EQ(doubts_text(limbs).rfind("warning: doubtful: LeftArm", 0), 0u);
}

}  // namespace
}  // namespace sinew
