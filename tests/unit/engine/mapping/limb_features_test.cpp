// SPDX-License-Identifier: MIT
// What limbs are compared by.
#include "human_rig.hpp"

namespace sinew::mapping {
namespace {

TEST(MapLimbFeatures, ArmsPointOutwardAtTheChestAndLegsDownAtTheHips) {
  HumanRig human;
  const Read read(&human);
  const Anatomy& a = read.anatomy;
  for (const int32_t limb : {a.arms.a, a.arms.b}) {
    const LimbFeatures& arm = a.features[limb];
    EXPECT_NEAR(arm.attach, 1, 0.25);
    EXPECT_GT(arm.axis.x, 0.99);  // outward on either side
    EXPECT_TRUE(arm.arm);
    EXPECT_FALSE(arm.hip || arm.grounded);
  }
  for (const int32_t limb : {a.legs[0].a, a.legs[0].b}) {
    const LimbFeatures& leg = a.features[limb];
    EXPECT_NEAR(leg.attach, 0, 0.25);
    EXPECT_LT(leg.axis.y, -0.9);
    EXPECT_TRUE(leg.hip && leg.grounded);
    EXPECT_FALSE(leg.arm);
  }
}

TEST(MapLimbFeatures, DoNotDependOnTheSize) {
  HumanRig human, large;
  for (float& x : large.positions) x *= 100;
  const Read read(&human), other(&large);
  const LimbFeatures& one = read.anatomy.features[read.anatomy.arms.a];
  const LimbFeatures& two = other.anatomy.features[other.anatomy.arms.a];
  EXPECT_NEAR(one.log_length, two.log_length, 1e-5);
  EXPECT_NEAR(one.attach, two.attach, 1e-5);
}

TEST(MapLimbFeatures, LegsOfAnInsectAreCountedFromTheRear) {
  InsectRig insect;
  const Read read(&insect);
  ASSERT_EQ(read.anatomy.leg_count, 3);
  for (int32_t pair = 0; pair < 3; ++pair) {
    for (int32_t k = 0; k < read.anatomy.limbs.count; ++k) {
      if (read.first(k) != InsectRig::kLegs + 6 * pair) continue;
      EXPECT_NEAR(read.anatomy.features[k].rank, 0.5 * pair, 1e-9);
    }
  }
}

}  // namespace
}  // namespace sinew::mapping
