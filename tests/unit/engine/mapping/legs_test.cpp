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

TEST(MapLegs, ArmsThatReachTheGroundAreNoLegs) {
  HumanRig human;
  for (const size_t joint : {5, 6, 7, 8, 9, 10}) {
    human.positions[3 * joint] = joint < 8 ? 0.3f : -0.3f;
    human.positions[3 * joint + 1] = 1.45f - 0.7f * static_cast<float>((joint - 5) % 3);
  }
  const Read read(&human);
  ASSERT_EQ(read.anatomy.leg_count, 1);
  EXPECT_EQ(read.first(read.anatomy.legs[0].a), HumanRig::kThigh);
  EXPECT_EQ(read.first(read.anatomy.arms.a), HumanRig::kUpperArm);
}

TEST(MapLegs, OfAnInsectAllAreFoundAlthoughTheirKneesAreHigh) {
  InsectRig insect;
  const Read read(&insect);
  EXPECT_EQ(read.anatomy.leg_count, 3);
  EXPECT_GT(read.anatomy.frame.front.z, 0.99);  // its head carries jaws, its abdomen is longer
}

TEST(MapLegs, FinsUnderABellyAreNoLegs) {
  SmallRig fish;
  fish.positions = {0, 0.7f, 0.8f, 0, 0.7f, 0, 0, 0.7f, -0.8f};
  fish.parents = {-1, 0, 1};
  for (const float y : {0.1f, 0.12f}) {
    for (const float x : {0.1f, -0.1f}) {
      fish.positions.insert(fish.positions.end(), {x, y, 0.4f, 2 * x, y - 0.1f, 0.4f});
      fish.parents.insert(fish.parents.end(), {0, static_cast<int32_t>(fish.parents.size())});
    }
  }
  EXPECT_EQ(Read(&fish).anatomy.leg_count, 0);
}

}  // namespace
}  // namespace sinew::mapping
