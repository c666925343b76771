// SPDX-License-Identifier: MIT
// Sides and limbs of a rig by its joints' positions alone.
#include "human_rig.hpp"

namespace sinew::mapping {
namespace {

TEST(MapAnatomy, SidesAreThoseOfTheMirrorPlane) {
  HumanRig human;
  const Read read(&human);
  const Anatomy& a = read.anatomy;
  for (const int32_t joint : {0, 1, 2, 3, 4}) EXPECT_EQ(a.side[joint], 0) << joint;
  for (const int32_t joint : {5, 6, 7, 11, 12, 13, 14}) EXPECT_EQ(a.side[joint], 1) << joint;
  for (const int32_t joint : {8, 9, 10, 15, 16, 17, 18}) EXPECT_EQ(a.side[joint], -1) << joint;
  EXPECT_NEAR(a.x[HumanRig::kHand], 0.7, 1e-6);
  EXPECT_NEAR(a.tall, 1.7 - 0.02, 1e-6);
}

TEST(MapAnatomy, EveryLimbHangsOnTheTrunkAndHasItsMate) {
  HumanRig human;
  const Read read(&human);
  const Anatomy& a = read.anatomy;
  ASSERT_EQ(a.side_limbs, 4);
  for (int32_t k = 0; k < a.side_limbs; ++k) {
    const Limb& limb = a.limb(k);
    ASSERT_GE(limb.mate, 0);
    EXPECT_EQ(a.limb(limb.mate).mate, k);
    EXPECT_EQ(a.limb(limb.mate).side, -limb.side);
    EXPECT_TRUE(limb.attach == HumanRig::kChest || limb.attach == HumanRig::kHips);
  }
}

TEST(MapAnatomy, ARigOfOneJointHasNoLimbs) {
  SmallRig one;
  one.positions = {0, 0, 0};
  one.parents = {-1};
  const Read read(&one);
  EXPECT_EQ(read.anatomy.limbs.count, 0);
  EXPECT_EQ(read.anatomy.leg_count, 0);
  EXPECT_EQ(read.anatomy.arms.a, -1);
}

}  // namespace
}  // namespace sinew::mapping
