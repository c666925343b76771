// SPDX-License-Identifier: MIT
// The table of slots, and which joints of a target skeleton they hold.
#include "sinew_trainer/joint_slots.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>

#include "sinew_formats/error.hpp"

namespace sinew {
namespace {

std::array<JointSlot, kSlots> make_slots() {
  std::array<JointSlot, kSlots> slots;
  size_t count = 0;
  const auto add = [&](SlotSide side, JointClass joint_class, uint8_t joints, bool end = false) {
    for (uint8_t number = 0; number < joints; ++number) slots.at(count++) = {joint_class, number, false, side};
    if (end) slots.at(count++) = {joint_class, 0, true, side};
  };
  add(SlotSide::kMiddle, kClassPelvis, 1);
  add(SlotSide::kMiddle, kClassSpine, 4);
  add(SlotSide::kMiddle, kClassNeck, 2);
  add(SlotSide::kMiddle, kClassHead, 1, true);
  add(SlotSide::kMiddle, kClassTail, 4, true);
  for (const SlotSide side : {SlotSide::kLeft, SlotSide::kRight}) {
    add(side, kClassClavicle, 1);
    add(side, kClassUpperArm, 1);
    add(side, kClassForearm, 1);
    add(side, kClassHand, 1, true);
    add(side, kClassHip, 1);
    add(side, kClassThigh, 1);
    add(side, kClassCalf, 1);
    add(side, kClassFoot, 1);
    add(side, kClassToe, 1, true);
    add(side, kClassEar, 1);
    add(side, kClassWing, 2, true);
  }
  return slots;
}

bool is_one_of(JointClass c, std::initializer_list<JointClass> classes) {
  return std::find(classes.begin(), classes.end(), c) != classes.end();
}

// A foot without toes ends where toes end.
JointClass slot_class(const TargetJoint& joint) {
  return joint.tip && joint.joint_class == kClassFoot ? kClassToe : joint.joint_class;
}

int depth_of(const TargetSkeleton& target, size_t joint) {
  int depth = 0;
  for (int j = target.joints[joint].parent; j >= 0; j = target.joints[static_cast<size_t>(j)].parent) ++depth;
  return depth;
}

}  // namespace

const std::array<JointSlot, kSlots>& joint_slots() {
  static const std::array<JointSlot, kSlots> slots = make_slots();
  return slots;
}

const std::vector<std::string>& slot_category_names() {
  static const std::vector<std::string> names = {"any", "biped", "quadruped", "bird", "fish"};
  return names;
}

SlotCategory slot_category(const std::string& name) {
  const std::vector<std::string>& names = slot_category_names();
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) {
    std::string list;
    for (const std::string& one : names) list += (list.empty() ? "" : ", ") + one;
    throw Error("category " + name + ": expected one of " + list);
  }
  return static_cast<SlotCategory>(found - names.begin());
}

bool in_category(const JointSlot& slot, SlotCategory category) {
  const JointClass c = slot.joint_class;
  const bool trunk = c <= kClassHead, arm = is_one_of(c, {kClassClavicle, kClassUpperArm, kClassForearm, kClassHand}),
             leg = is_one_of(c, {kClassHip, kClassThigh, kClassCalf, kClassFoot, kClassToe});
  switch (category) {
    case SlotCategory::kBiped:
      return trunk || arm || leg;
    case SlotCategory::kQuadruped:
      return trunk || arm || leg || is_one_of(c, {kClassTail, kClassEar});
    case SlotCategory::kBird:
      return trunk || leg || is_one_of(c, {kClassTail, kClassWing});
    case SlotCategory::kFish:
      return trunk || is_one_of(c, {kClassTail, kClassWing});
    case SlotCategory::kAny:
      break;
  }
  return true;
}

std::array<int, kSlots> assign_slots(const TargetSkeleton& target,
                                     const std::vector<std::array<double, 3>>& positions) {
  std::array<int, kSlots> held;
  held.fill(-1);
  std::vector<size_t> order(target.joints.size());
  std::iota(order.begin(), order.end(), size_t{0});
  std::vector<int> depth;
  for (size_t j = 0; j < order.size(); ++j) depth.push_back(depth_of(target, j));
  std::stable_sort(order.begin(), order.end(), [&](size_t a, size_t b) {
    return depth[a] != depth[b] ? depth[a] < depth[b] : std::fabs(positions[a][0]) > std::fabs(positions[b][0]);
  });
  const std::array<JointSlot, kSlots>& slots = joint_slots();
  const auto fits = [&](const JointSlot& slot, size_t j) {
    const TargetJoint& joint = target.joints[j];
    if (slot.joint_class != slot_class(joint) || slot.tip != joint.tip) return false;
    return slot.side == SlotSide::kMiddle || (slot.side == SlotSide::kLeft) == (positions[j][0] > 0);
  };
  for (size_t first = 0; first < kSlots;) {  // slots of one kind stand side by side
    size_t end = first + 1;
    while (end < kSlots && slots[end].number != 0) ++end;
    std::vector<size_t> joints;
    for (const size_t j : order)
      if (fits(slots[first], j)) joints.push_back(j);
    const size_t room = end - first, chosen = std::min(room, joints.size());
    for (size_t i = 0; i < chosen; ++i)
      held[first + i] = static_cast<int>(joints[room > 1 && chosen > 0 ? i * joints.size() / chosen : i]);
    first = end;
  }
  return held;
}

void connected_slots(const TargetSkeleton& target, const std::array<int, kSlots>& slots,
                     std::array<uint8_t, kSlotPairs>* connected) {
  connected->fill(0);
  std::vector<int> slot_of(target.joints.size(), -1);
  for (uint32_t s = 0; s < kSlots; ++s)
    if (slots[s] >= 0) slot_of[static_cast<size_t>(slots[s])] = static_cast<int>(s);
  for (uint32_t s = 0; s < kSlots; ++s) {
    if (slots[s] < 0) continue;
    int j = target.joints[static_cast<size_t>(slots[s])].parent;
    while (j >= 0 && slot_of[static_cast<size_t>(j)] < 0) j = target.joints[static_cast<size_t>(j)].parent;
    if (j < 0) continue;
    const auto other = static_cast<uint32_t>(slot_of[static_cast<size_t>(j)]);
    (*connected)[slot_pair(std::min(s, other), std::max(s, other))] = 1;
  }
}

}  // namespace sinew
