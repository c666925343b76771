// SPDX-License-Identifier: MIT
// Mesh to graph, target skeleton to slots.
#include "data/slot_sample.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>

#include "data/rig_sample.hpp"
#include "network/slot_network.hpp"
#include "sinew_formats/error.hpp"

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

NetworkSample slot_points(const PointSet& set) {
  NetworkSample s = point_sample(set);
  unfold_features(set, s.inputs[0].rows.data());
  s.candidate.assign(kSetPoints, 0);
  return s;
}

double skin_offset(const NetworkSample& sample, const std::array<double, 3>& position) {
  double least = 1e30;
  for (uint32_t v = 0; v < sample.vertices; ++v) {
    const int16_t* const row = &sample.inputs[0].rows[size_t{v} * kRigChannels];
    double squared = 0;
    for (size_t c = 0; c < 3; ++c) {
      const double d = position[c] - row[kRigPosition + c] / kPositionSteps;
      squared += d * d;
    }
    least = std::min(least, squared);
  }
  return std::sqrt(least);
}

SlotSample make_slot_sample(const RigSource& source, uint64_t seed, double strength) {
  const RigSource::PosedMesh posed_mesh = source.make_mesh(seed, {.strength = strength});
  SlotSample s;
  with_point_set(posed_mesh.engine, seed,
                 [&](const PointSet& set) { static_cast<NetworkSample&>(s) = slot_points(set); });
  s.name = source.name();
  s.family = source.family();
  const std::array<int, kSlots> held = assign_slots(source.target(), posed_mesh.joints);
  if (std::count_if(held.begin(), held.end(), [](int joint) { return joint >= 0; }) < 2)
    throw Error(source.name() + ": no two joints that there are slots for (trainer/README.md)");
  connected_slots(source.target(), held, &s.connected);
  s.joints.assign(size_t{kSlots} * 4, 0.0f);
  for (uint32_t slot = 0; slot < kSlots; ++slot) {
    if (held[slot] < 0) continue;
    s.present[slot] = 1;
    const Point3& position = posed_mesh.joints[static_cast<size_t>(held[slot])];
    for (uint32_t c = 0; c < 3; ++c) s.joints[4 * slot + c] = static_cast<float>(position[c]);
    s.joints[4 * slot + kSlotOffset] = static_cast<float>(skin_offset(s, position));
  }
  return s;
}

}  // namespace sinew
