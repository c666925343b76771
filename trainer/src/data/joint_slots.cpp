// SPDX-License-Identifier: MIT
// Which joints of a target skeleton the slots hold.
#include "sinew_trainer/joint_slots.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>

namespace sinew {
namespace {

using namespace rigging;

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
  const JointSlot* const slots = joint_slots();
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
