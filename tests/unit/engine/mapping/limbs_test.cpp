// SPDX-License-Identifier: MIT
// Chains and what branches off them.
#include "mapping/limbs.hpp"

#include "human_rig.hpp"

namespace sinew::mapping {
namespace {

TEST(MapLimbs, AChainHasItsJointsInTheirOrderAndItsLength) {
  HumanRig human;
  const Read read(&human);
  const Anatomy& a = read.anatomy;
  const Limb& arm = a.limb(a.arms.a);
  ASSERT_EQ(arm.joint_count, 3);
  for (int32_t k = 0; k < 3; ++k) EXPECT_EQ(a.limbs.joint(arm, k), HumanRig::kUpperArm + k);
  EXPECT_EQ(a.limbs.last_joint(arm), HumanRig::kHand);
  EXPECT_EQ(arm.attach, HumanRig::kChest);
  EXPECT_NEAR(arm.length, 0.5, 0.001);
  EXPECT_NEAR(a.limbs.lowest(arm, {0, 1, 0}), 1.45, 1e-6);
}

TEST(MapLimbs, FingersAreSubsOfTheHandAndTwistsAreNot) {
  HumanRig human;
  for (const float x : {1.0f, -1.0f}) {
    const int32_t arm = x > 0 ? HumanRig::kUpperArm : HumanRig::kUpperArm + HumanRig::kRightArm;
    for (const float z : {-0.03f, 0.0f, 0.03f}) {  // three fingers of two
      const int32_t first = static_cast<int32_t>(human.parents.size());
      human.positions.insert(human.positions.end(), {x * 0.78f, 1.45f, z, x * 0.82f, 1.45f, z});
      human.parents.insert(human.parents.end(), {arm + 2, first});
    }
    human.positions.insert(human.positions.end(), {x * 0.32f, 1.45f, 0});  // in the middle of the upper arm
    human.parents.push_back(arm);
  }
  const Read read(&human);
  const Anatomy& a = read.anatomy;
  const Limb& arm = a.limb(a.arms.a);
  EXPECT_EQ(a.limbs.end_subs(arm), 3);
  int32_t twists = 0, subs = 0;
  a.limbs.each_sub(arm, [&](int32_t sub) {
    ++subs;
    twists += a.limbs.is_twist(arm, sub) ? 1 : 0;
    EXPECT_EQ(a.limbs.is_twist(arm, sub), a.limb(sub).attach == HumanRig::kUpperArm);
  });
  EXPECT_EQ(subs, 4);
  EXPECT_EQ(twists, 1);
}

TEST(MapLimbs, AnArmGoesOnWithTheHandBesideAThumbOnTheSameSpot) {
  HumanRig human;
  for (const float x : {1.0f, -1.0f}) {
    const int32_t hand = x > 0 ? HumanRig::kHand : HumanRig::kHand + HumanRig::kRightArm;
    const int32_t finger = static_cast<int32_t>(human.parents.size());
    human.positions.insert(human.positions.end(), {x * 0.78f, 1.45f, 0, x * 0.7f, 1.45f, 0, x * 0.72f, 1.42f, 0.07f});
    human.parents.insert(human.parents.end(),
                         {hand, hand - 1, finger + 1});  // finger, thumb and its end on the forearm
  }
  const Read read(&human);
  const Limb& arm = read.anatomy.limb(read.anatomy.arms.a);
  ASSERT_EQ(arm.joint_count, 4);
  EXPECT_EQ(read.anatomy.limbs.joint(arm, 2), HumanRig::kHand);
}

}  // namespace
}  // namespace sinew::mapping
