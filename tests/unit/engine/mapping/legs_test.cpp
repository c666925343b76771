// SPDX-License-Identifier: MIT
// Legs are the pairs that come near the ground.
#include "human_rig.hpp"

namespace sinew::mapping {
namespace {

TEST(MapLegs, AHumanHasOnePairAndADogTwo) {
  HumanRig human;
  const Read man(&human);
  ASSERT_EQ(man.anatomy.leg_count, 1);
  EXPECT_EQ(man.first(man.anatomy.legs[0].a), HumanRig::kThigh);
  EXPECT_EQ(man.first(man.anatomy.legs[0].b), HumanRig::kThigh + HumanRig::kRightLeg);
  EXPECT_FALSE(man.anatomy.quad);

  DogRig dog;
  const Read read(&dog);
  EXPECT_EQ(read.anatomy.leg_count, 2);
  EXPECT_TRUE(read.anatomy.quad);
  EXPECT_EQ(read.first(read.anatomy.hip_pair.a), DogRig::kHindLeg);
}

TEST(MapLegs, ArmsThatHangDownAreNoLegs) {
  HumanRig human;
  for (const size_t joint : {5, 6, 7, 8, 9, 10}) {  // along the body, hands at 0.95 of 1.7
    human.positions[3 * joint] = joint < 8 ? 0.2f : -0.2f;
    human.positions[3 * joint + 1] = 1.45f - 0.25f * static_cast<float>((joint - 5) % 3);
  }
  const Read read(&human);
  ASSERT_EQ(read.anatomy.leg_count, 1);
  EXPECT_EQ(read.first(read.anatomy.legs[0].a), HumanRig::kThigh);
  EXPECT_EQ(read.first(read.anatomy.arms.a), HumanRig::kUpperArm);
}

}  // namespace
}  // namespace sinew::mapping
