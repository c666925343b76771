// SPDX-License-Identifier: MIT
// How likely a predicted skeleton can be used, and which of its limbs are doubted.
#include "sinew_character/predict/predict_skeleton.hpp"

#include <gtest/gtest.h>

namespace sinew {
namespace {

TEST(UsableProbability, FallsWithTheSpreadAndWithoutAMirrorPlane) {
  float before = 1;
  for (const float spread : {0.0f, 0.02f, 0.04f, 0.06f, 0.08f, 0.12f, 1.0f}) {
    const float mirrored = usable_probability(spread, true), other = usable_probability(spread, false);
    EXPECT_LE(mirrored, before) << spread;
    EXPECT_LE(other, mirrored) << spread;
    EXPECT_GE(other, 0);
    before = mirrored;
  }
  EXPECT_GT(usable_probability(0.03f, false), 0.9f) << "people are usable in any pose";
  EXPECT_LT(usable_probability(0.09f, true), kDoubtfulUsable) << "a mesh unlike all is told";
}

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
  const std::vector<LimbDoubt> limbs = doubtful_limbs(skeleton);
  ASSERT_EQ(limbs.size(), 1u);
  EXPECT_EQ(limbs[0].name, "LeftArm");
  EXPECT_EQ(limbs[0].joints, (std::vector<int>{3, 4, 5}));
  EXPECT_EQ(doubts_text(limbs).rfind("warning: these limbs may be wrong: LeftArm", 0), 0u);
}

TEST(LimbDoubts, ALimbThatHardlyHangsOnAnythingIsDoubtedMore) {
  PredictedSkeleton skeleton = person();
  for (const size_t j : {3u, 4u, 5u, 6u, 7u, 8u}) skeleton.confidence[j] = 0.15f;
  skeleton.parent_confidence[7] = 0.001f;
  const std::vector<LimbDoubt> limbs = doubtful_limbs(skeleton);
  ASSERT_EQ(limbs.size(), 1u);
  EXPECT_EQ(limbs[0].name, "RightArm");
}

}  // namespace
}  // namespace sinew
