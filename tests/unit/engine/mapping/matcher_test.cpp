// SPDX-License-Identifier: MIT
// Trunk for trunk and limb for limb between bodies of other counts and kinds, and what the caller pins.
#include "mapping/matcher.hpp"

#include <cmath>

#include "matched_rigs.hpp"

namespace sinew::mapping {
namespace {

// The human with `spines` joints between hips and neck; limbs begin at kFirstLimb of the human, moved by what is added.
struct SpineRig : SmallRig {
  int32_t neck = 0, moved = 0;

  explicit SpineRig(int32_t spines) {
    const HumanRig human;
    positions.assign(human.positions.begin(), human.positions.begin() + 3);
    parents = {-1};
    for (int32_t k = 1; k <= spines; ++k) {
      positions.insert(positions.end(), {0, 1 + 0.4f * static_cast<float>(k) / static_cast<float>(spines), 0});
      parents.push_back(k - 1);
    }
    neck = spines + 1;
    moved = neck - HumanRig::kNeck;
    for (size_t j = HumanRig::kNeck; j < human.parents.size(); ++j) {
      positions.insert(positions.end(), human.positions.begin() + static_cast<ptrdiff_t>(3 * j),
                       human.positions.begin() + static_cast<ptrdiff_t>(3 * j + 3));
      const int32_t parent = human.parents[j];
      parents.push_back(parent >= HumanRig::kChest ? parent + moved : parent);
    }
  }
};

TEST(MapMatcher, ARigIsItsOwnSource) {
  HumanRig a, b;
  const MatchedRigs same(&a, &b);
  for (int32_t i = 0; i < HumanRig::kCount; ++i) EXPECT_EQ(same.of(i), i);
  EXPECT_EQ(same.costs[HumanRig::kHips], 0);
  DogRig c, d;
  const MatchedRigs dogs(&c, &d);
  for (int32_t i = 0; i < static_cast<int32_t>(dogs.sources.size()); ++i) EXPECT_EQ(dogs.of(i), i);
}

TEST(MapMatcher, EveryJointOfTheShorterSpineGetsOneInOrder) {
  for (const auto& [few, many] : {std::pair(2, 5), std::pair(1, 3), std::pair(3, 4)}) {
    SpineRig a(few), b(many);
    const MatchedRigs shorter(&a, &b);
    int32_t last = 0;
    for (int32_t k = 1; k <= few; ++k) {
      EXPECT_GT(shorter.of(k), last) << "upwards";
      last = shorter.of(k);
    }
    if (few > 1) {
      EXPECT_EQ(shorter.of(few), many) << "the joint with the arms";
    }
    for (int32_t j = a.neck; j < static_cast<int32_t>(a.parents.size()); ++j)
      EXPECT_EQ(shorter.of(j), j - a.moved + b.moved) << "neck, head and limbs";
    SpineRig c(few), d(many);
    const MatchedRigs longer(&d, &c);
    int32_t found = 0;
    for (int32_t k = 1; k <= many; ++k) found += longer.of(k) >= 0 ? 1 : 0;
    EXPECT_EQ(found, few) << "others stay without";
  }
}

TEST(MapMatcher, ForelegsAreArmsAndHindLegsLegs) {
  HumanRig human;
  DogRig dog;
  const MatchedRigs matched(&human, &dog);
  EXPECT_EQ(matched.of(HumanRig::kHips), DogRig::kHips);
  EXPECT_EQ(matched.of(HumanRig::kThigh), DogRig::kHindLeg);
  EXPECT_EQ(matched.of(HumanRig::kThigh + HumanRig::kRightLeg), DogRig::kHindLeg + 3);
  EXPECT_EQ(matched.of(HumanRig::kUpperArm), DogRig::kForeLeg);
  EXPECT_EQ(matched.of(HumanRig::kUpperArm + HumanRig::kRightArm), DogRig::kForeLeg + 3);
  EXPECT_EQ(matched.of(HumanRig::kHead), DogRig::kHead);
}

TEST(MapMatcher, WhatIsMissingStaysWithout) {
  HumanRig human, armless;
  // Without arms: legs follow at once.
  armless.positions.erase(armless.positions.begin() + 15, armless.positions.begin() + 33);
  armless.parents = {-1, 0, 1, 2, 3, 0, 5, 6, 7, 0, 9, 10, 11};
  const MatchedRigs matched(&human, &armless);
  for (int32_t j = HumanRig::kUpperArm; j < HumanRig::kThigh; ++j) EXPECT_EQ(matched.of(j), -1) << j;
  for (int32_t j = HumanRig::kThigh; j < HumanRig::kCount; ++j) EXPECT_EQ(matched.of(j), j - 6) << j;
}

TEST(MapMatcher, PinsHoldLimbsTogether) {
  HumanRig a, b;
  const int32_t left = HumanRig::kForearm, right = HumanRig::kForearm + HumanRig::kRightArm;
  const MatchedRigs matched(&a, &b, {{left, HumanRig::kCalf}});
  EXPECT_EQ(matched.of(left), HumanRig::kCalf);
  EXPECT_EQ(matched.of(left - 1), HumanRig::kThigh);
  EXPECT_EQ(matched.of(right), HumanRig::kCalf + HumanRig::kRightLeg) << "on both sides";
  for (const int32_t leg : {int32_t{HumanRig::kThigh}, int32_t{HumanRig::kCalf}})
    EXPECT_TRUE(matched.of(leg) < 0 || matched.of(leg) < HumanRig::kThigh) << "the leg is given away";
}

TEST(MapMatcher, PinsInTheTrunkMoveItsJoints) {
  HumanRig a, b;
  const MatchedRigs moved(&a, &b, {{HumanRig::kSpine, HumanRig::kChest}});
  EXPECT_EQ(moved.of(HumanRig::kSpine), HumanRig::kChest);
  EXPECT_EQ(moved.of(HumanRig::kHead), HumanRig::kHead);
  HumanRig c, d;
  const MatchedRigs none(&c, &d, {{HumanRig::kSpine, -1}});
  EXPECT_EQ(none.of(HumanRig::kSpine), -1);
  EXPECT_EQ(none.of(HumanRig::kChest), HumanRig::kChest);
  EXPECT_EQ(none.of(HumanRig::kHand), HumanRig::kHand);
}

// Markers where hands end, `each` below every hand of the rig.
void add_hand_ends(HumanRig* human, int each) {
  human->ends.assign(human->parents.size(), 0);
  for (const float x : {1.0f, -1.0f}) {
    for (int k = 0; k < each; ++k) {
      human->positions.insert(human->positions.end(), {x * 0.85f, 1.45f, 0.02f * static_cast<float>(k)});
      human->parents.push_back(x > 0 ? int32_t{HumanRig::kHand} : HumanRig::kHand + HumanRig::kRightArm);
      human->ends.push_back(1);
    }
  }
}

TEST(MapMatcher, AnEndGoesToTheOnlyFreeLeafBelowItsParentsSource) {
  HumanRig a, b;
  add_hand_ends(&a, 1);
  add_hand_ends(&b, 1);
  const MatchedRigs one(&a, &b);
  EXPECT_EQ(one.of(HumanRig::kCount), HumanRig::kCount);
  EXPECT_EQ(one.of(HumanRig::kCount + 1), HumanRig::kCount + 1);
  EXPECT_GT(one.costs[HumanRig::kCount], one.costs[HumanRig::kHand]) << "no surer than its parent";
  HumanRig c, d;
  add_hand_ends(&c, 1);
  add_hand_ends(&d, 2);
  const MatchedRigs two(&c, &d);
  EXPECT_EQ(two.of(HumanRig::kHand), HumanRig::kHand);
  EXPECT_EQ(two.of(HumanRig::kCount), -1) << "which of two is not known";
}

TEST(MapMatcher, LengthsAddUpAlongAChain) {
  const Point points[] = {{3, 4, 0}, {3, 4, 2}, {3, 4, 2}};
  double sums[3] = {};
  add_up_lengths(points, 3, {0, 0, 0}, sums);
  EXPECT_DOUBLE_EQ(sums[0], 5);
  EXPECT_DOUBLE_EQ(sums[1], 7);
  EXPECT_DOUBLE_EQ(sums[2], 7);
}

}  // namespace
}  // namespace sinew::mapping
