// SPDX-License-Identifier: MIT
// Hips, spine, chest, head and arms.
#include "human_rig.hpp"

namespace sinew::mapping {
namespace {

TEST(MapBody, TheSpineLeadsFromTheHipsToTheHead) {
  HumanRig human;
  const Read read(&human);
  const Anatomy& a = read.anatomy;
  EXPECT_EQ(a.hip, HumanRig::kHips);
  ASSERT_EQ(a.spine_count, 4);
  for (int32_t k = 0; k < 4; ++k) EXPECT_EQ(a.spine[k], HumanRig::kSpine + k);
  EXPECT_EQ(a.spine[a.chest], HumanRig::kChest);
  EXPECT_EQ(a.spine[a.head], HumanRig::kHead);
  EXPECT_EQ(read.first(a.arms.a), HumanRig::kUpperArm);
  EXPECT_EQ(read.first(a.arms.b), HumanRig::kUpperArm + HumanRig::kRightArm);
  EXPECT_NEAR(a.trunk_position(a.at(HumanRig::kHips)), 0, 1e-6);
}

TEST(MapBody, ADogsSpineEndsInItsHeadNotInItsTail) {
  DogRig dog;
  const Read read(&dog);
  const Anatomy& a = read.anatomy;
  ASSERT_GT(a.spine_count, 0);
  EXPECT_EQ(a.spine[a.spine_count - 1], DogRig::kHead);
  ASSERT_EQ(a.others_count, 1);  // the tail
  EXPECT_EQ(a.limbs.joint(a.limb(a.others_first), 0), DogRig::kTail);
}

TEST(MapBody, WhatHasNoLegsAndIsLongLies) {
  SmallRig snake;
  snake.positions.clear();
  snake.parents.clear();
  for (int32_t k = 0; k < 8; ++k) {
    snake.positions.insert(snake.positions.end(), {0, k == 7 ? 0.15f : 0.1f, 0.3f * static_cast<float>(k)});
    snake.parents.push_back(k - 1);
  }
  const Read read(&snake);
  EXPECT_TRUE(read.anatomy.lying);
  EXPECT_EQ(read.anatomy.leg_count, 0);
}

TEST(MapBody, OfARigThatBeginsAtTheChestTheSpineLeadsToTheHeadNotToThePelvis) {
  HumanRig human;
  human.parents[HumanRig::kChest] = -1;
  human.parents[HumanRig::kSpine] = HumanRig::kChest;
  human.parents[HumanRig::kHips] = HumanRig::kSpine;
  const Read read(&human);
  const Anatomy& a = read.anatomy;
  EXPECT_EQ(a.hip, HumanRig::kChest);
  ASSERT_EQ(a.spine_count, 2);
  EXPECT_EQ(a.spine[1], HumanRig::kHead);
  EXPECT_EQ(read.first(a.hip_pair.a), HumanRig::kThigh);
}

TEST(MapBody, OneChainFromTheHeadBackwardsIsATailHoweverItBends) {
  SmallRig fish;
  fish.positions = {0.3f, 0.5f, 1, 0.3f, 0.5f, 0.3f, 0, 0.5f, -0.3f, -0.4f, 0.5f, -1};
  fish.parents = {-1, 0, 1, 2};
  const Read read(&fish);
  EXPECT_EQ(read.anatomy.spine_count, 0);
  ASSERT_EQ(read.anatomy.others_count, 1);
  EXPECT_EQ(read.anatomy.limb(read.anatomy.others_first).joint_count, 3);
}

TEST(MapBody, ATailGoesStraightOnBetweenFinsOfAsManyJoints) {
  SmallRig fish;
  fish.positions = {0, 0.5f, 1, 0, 0.5f, 1.2f, 0, 0.5f, 0.3f};
  fish.parents = {-1, 0, 0};  // head and tail on the root
  for (const float y : {0.2f, 0.0f, -0.2f}) {
    const int32_t first = static_cast<int32_t>(fish.parents.size());
    fish.positions.insert(fish.positions.end(), {0, 0.5f + y, -0.2f, 0, 0.5f + 2 * y, -0.5f});
    fish.parents.insert(fish.parents.end(), {2, first});
  }
  const Read read(&fish);
  ASSERT_TRUE(read.anatomy.lying);
  bool straight = false;
  for (int32_t k = 0; k < read.anatomy.others_count; ++k) {
    const Limb& chain = read.anatomy.limb(read.anatomy.others_first + k);
    straight = straight || (chain.joint_count == 3 && read.anatomy.limbs.joint(chain, 1) == 5);
  }
  EXPECT_TRUE(straight);
}

TEST(MapBody, WhiskersAtTheEndOfALongNeckAreNoArms) {
  HumanRig bird;  // its arms become whiskers of the head
  for (const size_t joint : {5, 6, 7, 8, 9, 10}) {
    bird.positions[3 * joint] *= 0.3f;
    bird.positions[3 * joint + 1] = 1.7f;
  }
  bird.parents[HumanRig::kUpperArm] = bird.parents[HumanRig::kUpperArm + HumanRig::kRightArm] = HumanRig::kHead;
  EXPECT_EQ(Read(&bird).anatomy.arms.a, -1);
}

}  // namespace
}  // namespace sinew::mapping
