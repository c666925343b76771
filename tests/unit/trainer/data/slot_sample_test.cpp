// SPDX-License-Identifier: MIT
// Which joint of a skeleton each slot holds.
#include "data/slot_sample.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <tuple>

namespace sinew {
namespace {

using namespace rigging;

struct Body {
  TargetSkeleton target;
  std::vector<std::array<double, 3>> positions;
  int joint(JointClass c, int parent, double x = 0, bool tip = false) {
    TargetJoint joint;
    joint.joint_class = c;
    joint.parent = parent;
    joint.tip = tip;
    target.joints.push_back(joint);
    positions.push_back({x, 0, 0});
    return static_cast<int>(positions.size()) - 1;
  }
};

uint32_t slot_of(JointClass c, uint8_t number = 0, SlotSide side = SlotSide::kMiddle, bool tip = false) {
  for (uint32_t i = 0; i < kSlots; ++i) {
    const JointSlot& slot = joint_slots()[i];
    if (slot.joint_class == c && slot.number == number && slot.side == side && slot.tip == tip) return i;
  }
  ADD_FAILURE() << "no such slot: class " << static_cast<int>(c);
  return 0;
}

TEST(JointSlots, EverySlotIsAnother) {
  std::set<std::tuple<int, int, int, bool>> met;
  for (uint32_t i = 0; i < kSlots; ++i) {
    const JointSlot& slot = joint_slots()[i];
    met.emplace(slot.joint_class, slot.number, static_cast<int>(slot.side), slot.tip);
  }
  EXPECT_EQ(met.size(), kSlots);
  std::set<uint32_t> pairs;
  for (uint32_t i = 0; i < kSlots; ++i)
    for (uint32_t j = i + 1; j < kSlots; ++j) pairs.insert(slot_pair(i, j));
  EXPECT_EQ(pairs.size(), kSlotPairs);
  EXPECT_EQ(*pairs.rbegin(), kSlotPairs - 1);
}

TEST(JointSlots, SidesAreToldByPlace) {
  Body body;
  const int hips = body.joint(kClassPelvis, -1);
  const int right = body.joint(kClassThigh, hips, -0.1), left = body.joint(kClassThigh, hips, 0.1);
  const int toe = body.joint(kClassFoot, left, 0.1, true);
  const auto held = assign_slots(body.target, body.positions);
  EXPECT_EQ(held[slot_of(kClassPelvis)], hips);
  EXPECT_EQ(held[slot_of(kClassThigh, 0, SlotSide::kLeft)], left);
  EXPECT_EQ(held[slot_of(kClassThigh, 0, SlotSide::kRight)], right);
  EXPECT_EQ(held[slot_of(kClassToe, 0, SlotSide::kLeft, true)], toe) << "a foot without toes ends where toes end";
  EXPECT_EQ(held[slot_of(kClassCalf, 0, SlotSide::kLeft)], -1);
}

TEST(JointSlots, TheOuterOneOfTwoAndWhatHasNoSlot) {
  Body body;
  const int hips = body.joint(kClassPelvis, -1);
  body.joint(kClassUpperArm, hips, 0.1);
  const int outer = body.joint(kClassUpperArm, hips, 0.3);
  body.joint(kClassHair, hips);
  body.joint(kClassOther, hips);
  const auto held = assign_slots(body.target, body.positions);
  EXPECT_EQ(held[slot_of(kClassUpperArm, 0, SlotSide::kLeft)], outer);
  EXPECT_EQ(std::count_if(held.begin(), held.end(), [](int j) { return j >= 0; }), 2);
}

TEST(JointSlots, ALongChainIsThinnedAtEqualSteps) {
  Body body;
  int last = body.joint(kClassPelvis, -1);
  for (int i = 0; i < 8; ++i) last = body.joint(kClassTail, last);
  const auto held = assign_slots(body.target, body.positions);
  for (uint8_t i = 0; i < 4; ++i) EXPECT_EQ(held[slot_of(kClassTail, i)], 1 + 2 * i);
  std::array<uint8_t, kSlotPairs> connected;
  connected_slots(body.target, held, &connected);
  for (uint8_t i = 0; i < 3; ++i)
    EXPECT_EQ(connected[slot_pair(slot_of(kClassTail, i), slot_of(kClassTail, static_cast<uint8_t>(i + 1)))], 1)
        << "through joints without slots";
  EXPECT_EQ(connected[slot_pair(slot_of(kClassPelvis), slot_of(kClassTail))], 1);
  EXPECT_EQ(std::count(connected.begin(), connected.end(), 1), 4);
}

TEST(JointSlots, CategoriesSayWhatABodyHas) {
  const auto count = [](BodyKind category) {
    return std::count_if(joint_slots(), joint_slots() + kSlots,
                         [&](const JointSlot& slot) { return in_category(slot, category); });
  };
  EXPECT_EQ(count(BodyKind::kAny), kSlots);
  EXPECT_EQ(count(BodyKind::kBiped), 9 + 2 * 11);
  EXPECT_EQ(count(BodyKind::kQuadruped), 9 + 5 + 2 * 12);
  EXPECT_EQ(count(BodyKind::kBird), 9 + 5 + 2 * 9);
  EXPECT_EQ(count(BodyKind::kFish), 9 + 5 + 2 * 3);
}

}  // namespace
}  // namespace sinew
