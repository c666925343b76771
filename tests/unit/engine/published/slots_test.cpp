// SPDX-License-Identifier: MIT
// The published method's arithmetic behind its networks: joints by attention, rows of pairs, the tree.
#include "published/slots.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <vector>

namespace sinew::rigging {
namespace {

uint32_t slot_of(JointClass c, SlotSide side = SlotSide::kMiddle, bool tip = false) {
  for (uint32_t i = 0; i < kSlots; ++i) {
    const JointSlot& slot = joint_slots()[i];
    if (slot.joint_class == c && slot.number == 0 && slot.side == side && slot.tip == tip) return i;
  }
  ADD_FAILURE() << "no such slot";
  return 0;
}

TEST(Slots, AJointIsTheMeanOfPointsAndTheirOffsetsByAttention) {
  std::vector<SurfacePoint> points(kSetPoints);
  std::vector<int16_t> rows(size_t{kSetPoints} * kSlotRow, 0);
  for (uint32_t i = 0; i < kSetPoints; ++i) points[i].position = {static_cast<int32_t>(i) << 10, 0, -kSide / 2};
  int16_t* const first = &rows[size_t{5} * kSlotRow + 3 * kSlotChannels];
  int16_t* const second = &rows[size_t{9} * kSlotRow + 3 * kSlotChannels];
  for (uint32_t i = 0; i < kSetPoints; ++i) rows[size_t{i} * kSlotRow + 3 * kSlotChannels] = -32767;
  first[kSlotAttention] = 2048;  // four times as much as
  second[kSlotAttention] = 0;
  first[kSlotPointOffset + 1] = 1024;  // a sixteenth of the side
  first[kSlotLogit] = 500;
  second[kSlotLogit] = -2000;
  rows[kMeshRow + 7] = 77;
  std::vector<int64_t> attention(kSetPoints);
  const auto joints = std::make_unique<SlotJoints>();
  add_slot_joints(points.data(), rows.data(), attention.data(), joints.get());
  const Vec3i p = joints->positions[3];
  EXPECT_NEAR(p.x, (0.8 * 5 + 0.2 * 9) * 1024, 2);
  EXPECT_NEAR(p.y, 0.8 * kSide / 16, 40) << "2^-2 is off by 2^-15 at most";
  EXPECT_NEAR(p.z, -kSide / 2, 1);
  EXPECT_EQ(joints->presence[3], 0);
  EXPECT_NEAR(joints->scatter[3], 2 * 0.8 * 0.2 * std::hypot(4 * 1024, kSide / 16), 40);
  EXPECT_EQ(joints->mesh[7], 77);
  add_slot_joints(points.data(), rows.data(), attention.data(), joints.get());
  EXPECT_EQ(joints->positions[3].x, 2 * p.x) << "sets add up";
}

TEST(Slots, RowsOfPairsSayWhichAndHowFar) {
  const auto joints = std::make_unique<SlotJoints>();
  joints->positions[2] = {kSide / 4, 0, 0};
  joints->positions[5] = {0, kSide / 4, 0};
  joints->mesh[0] = 99;
  std::vector<int16_t> rows(size_t{kSlotPairs} * kPairChannels);
  pair_rows(*joints, rows.data());
  const int16_t* const row = &rows[size_t{slot_pair(2, 5)} * kPairChannels];
  EXPECT_EQ(row[kPairOffset], -2048);
  EXPECT_EQ(row[kPairOffset + 1], 2048);
  EXPECT_NEAR(row[kPairOffset + 3], 2048 * std::sqrt(2.0), 1);
  EXPECT_EQ(row[kPairFirst + 2], 8192);
  EXPECT_EQ(row[kPairSecond + 5], 8192);
  EXPECT_EQ(std::count(row + kPairFirst, row + kPairMesh, 0), 2 * kSlots - 2);
  EXPECT_EQ(row[kPairMesh], 99);
}

// A pelvis, a head with an end, a left thigh; the thigh likes the head a little.
struct Body {
  std::unique_ptr<SlotJoints> joints = std::make_unique<SlotJoints>();
  uint32_t pelvis = slot_of(kClassPelvis), head = slot_of(kClassHead), thigh = slot_of(kClassThigh, SlotSide::kLeft),
           end = slot_of(kClassHead, SlotSide::kMiddle, true);
  RigJoint room[kMaxRigJoints];
  Rig rig;

  Body() {
    for (int32_t& p : joints->presence) p = -3000;
    for (const uint32_t slot : {pelvis, head, thigh, end}) joints->presence[slot] = 2000;
    for (int16_t& c : joints->connection) c = -4000;
    connect(pelvis, head, 3000);
    connect(pelvis, thigh, 1000);
    connect(head, thigh, -500);
    connect(head, end, 2500);
    rig.joints = room;
  }
  void connect(uint32_t a, uint32_t b, int16_t logit) {
    joints->connection[slot_pair(std::min(a, b), std::max(a, b))] = logit;
  }
  void join(BodyKind category = BodyKind::kAny, const RigOptions& options = {}) {
    join_slots(*joints, category, options, &rig);
  }
};

TEST(Slots, TheSpreadIsAQuarterOfTheScatterOfJointsThatAreThere) {
  Body body;
  for (int32_t& one : body.joints->scatter) one = kSide;
  for (const uint32_t slot : {body.pelvis, body.head, body.thigh, body.end}) body.joints->scatter[slot] = kSide / 5;
  body.join();
  EXPECT_NEAR(body.rig.spread, 65536 / 20, 1);
}

TEST(Slots, TheTreeIsThatOfTheLikeliestConnections) {
  Body body;
  body.join();
  ASSERT_EQ(body.rig.count, 4u);
  EXPECT_EQ(body.rig.spread, 0);
  EXPECT_EQ(body.room[0].joint_class, kClassPelvis);
  EXPECT_EQ(body.room[0].parent, -1);
  EXPECT_EQ(body.room[1].joint_class, kClassHead);
  EXPECT_EQ(body.room[2].joint_class, kClassThigh);
  EXPECT_EQ(body.room[2].parent, 0);
  EXPECT_EQ(body.room[2].side, 1);
  EXPECT_EQ(body.room[3].tip, 1);
  EXPECT_EQ(body.room[3].parent, 1);
  EXPECT_EQ(body.room[3].joint_class, kClassHead);
  EXPECT_NEAR(body.room[0].confidence / 32768.0, 1 / (1 + std::exp(-2000 / 1024.0)), 1e-4);
  EXPECT_NEAR(body.room[2].parent_confidence / 32768.0, 1 / (1 + std::exp(-1000 / 1024.0)), 1e-4);
  body.connect(body.head, body.thigh, 1001);
  body.join();
  EXPECT_EQ(body.room[body.room[2].joint_class == kClassThigh ? 2 : 3].parent, 1) << "the head is likelier now";
}

TEST(Slots, OptionsAndCategoriesTakeSlotsAway) {
  Body body;
  RigOptions options;
  options.ends = false;
  body.join(BodyKind::kAny, options);
  EXPECT_EQ(body.rig.count, 3u);
  body.join(BodyKind::kFish);
  EXPECT_EQ(body.rig.count, 3u) << "a fish has no thigh";
  for (int32_t& p : body.joints->presence) p = -3000;
  body.joints->presence[body.thigh] = -100;
  body.join();
  EXPECT_EQ(body.rig.count, 1u);
  EXPECT_EQ(body.room[0].joint_class, kClassThigh) << "the likeliest, where none is likely";
}

}  // namespace
}  // namespace sinew::rigging
