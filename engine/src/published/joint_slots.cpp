// SPDX-License-Identifier: MIT
// The table of slots, and rows of points that are not folded.
#include "published/joint_slots.hpp"

namespace sinew::rigging {
namespace {

struct SlotTable {
  JointSlot slots[kSlots] = {};
  uint32_t count = 0;

  constexpr void add(SlotSide side, JointClass joint_class, uint8_t joints, bool end = false) {
    for (uint8_t number = 0; number < joints; ++number) slots[count++] = {joint_class, number, false, side};
    if (end) slots[count++] = {joint_class, 0, true, side};
  }
};

constexpr SlotTable make_table() {
  SlotTable t;
  t.add(SlotSide::kMiddle, kClassPelvis, 1);
  t.add(SlotSide::kMiddle, kClassSpine, 4);
  t.add(SlotSide::kMiddle, kClassNeck, 2);
  t.add(SlotSide::kMiddle, kClassHead, 1, true);
  t.add(SlotSide::kMiddle, kClassTail, 4, true);
  constexpr SlotSide kSides[] = {SlotSide::kLeft, SlotSide::kRight};
  for (const SlotSide side : kSides) {
    t.add(side, kClassClavicle, 1);
    t.add(side, kClassUpperArm, 1);
    t.add(side, kClassForearm, 1);
    t.add(side, kClassHand, 1, true);
    t.add(side, kClassHip, 1);
    t.add(side, kClassThigh, 1);
    t.add(side, kClassCalf, 1);
    t.add(side, kClassFoot, 1);
    t.add(side, kClassToe, 1, true);
    t.add(side, kClassEar, 1);
    t.add(side, kClassWing, 2, true);
  }
  return t;
}
constexpr SlotTable kTable = make_table();
static_assert(kTable.count == kSlots, "the table fills all slots");

}  // namespace

const JointSlot* joint_slots() { return kTable.slots; }

bool in_category(const JointSlot& slot, BodyKind category) {
  const JointClass c = slot.joint_class;
  const bool trunk = c <= kClassHead, arm = c >= kClassClavicle && c <= kClassHand,
             leg = c >= kClassHip && c <= kClassToe, tail = c == kClassTail, wing = c == kClassWing;
  switch (category) {
    case BodyKind::kBiped:
      return trunk || arm || leg;
    case BodyKind::kQuadruped:
      return trunk || arm || leg || tail || c == kClassEar;
    case BodyKind::kBird:
      return trunk || leg || tail || wing;
    case BodyKind::kFish:
      return trunk || tail || wing;
    case BodyKind::kSnake:
      return trunk || tail;
    case BodyKind::kManyLegged:
      return trunk || arm || leg || tail;
    case BodyKind::kAny:
      break;
  }
  return true;
}

bool slots_task(uint32_t feature_set, ModelTask* task) {
  if (feature_set != kSlotsFeatureSet && feature_set != kConnectionsFeatureSet) return false;
  const bool first = feature_set == kSlotsFeatureSet;
  *task = ModelTask();
  task->id = kTaskRig;
  task->input_count = 1;
  task->inputs[0] = {first ? input_name("pnts") : input_name("pair"),
                     {Domain::kVertex, static_cast<uint16_t>(first ? uint32_t{kRigChannels} : kPairChannels)}};
  task->output = {first ? Domain::kPair : Domain::kVertex, static_cast<uint16_t>(first ? kSlotRow : 1)};
  task->far_neighbors = true;
  return true;
}

void unfold_features(const PointSet& set, int16_t* rows) {
  for (uint32_t i = 0; i < kSetPoints; ++i) {
    const int16_t* const from = set.features + size_t{i} * kRigChannels;
    int16_t* const to = rows + size_t{i} * kRigChannels;
    for (uint32_t c = 0; c < kRigChannels; ++c) to[c] = from[c];
    if (PointSet::on_left(set.points[i])) continue;
    constexpr uint32_t kAcross[] = {kRigPosition, kRigNormal, kRigMedial, kRigRelative};
    for (const uint32_t c : kAcross) to[c] = static_cast<int16_t>(from[c] == INT16_MIN ? INT16_MAX : -from[c]);
    to[kRigExtents] = from[kRigExtents + 1];
    to[kRigExtents + 1] = from[kRigExtents];
  }
}

}  // namespace sinew::rigging
