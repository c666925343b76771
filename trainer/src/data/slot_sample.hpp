// SPDX-License-Identifier: MIT
// Samples of the published method: a mesh as a graph of points of its surface, with the skeleton's joints in the slots of the
// engine's published/joint_slots.hpp.
#ifndef SINEW_TRAINER_DATA_SLOT_SAMPLE_HPP
#define SINEW_TRAINER_DATA_SLOT_SAMPLE_HPP

#include <array>
#include <cstdint>
#include <vector>

#include "data/rig_sample.hpp"
#include "published/joint_slots.hpp"
#include "sinew_data_sets/target_skeleton.hpp"
#include "sinew_trainer/sample.hpp"

namespace sinew {

// Which joint of a skeleton each slot holds, -1 for none. Joints come by their depth below the root, those nearer to the
// outside first; each takes the first free slot of its class and side. Of a chain that is longer than its slots, joints
// at equal steps stay. Classes without slots (hair, other) and what finds none free are left out.
//   positions  in  [target] in the mirror frame: x tells the side
std::array<int, rigging::kSlots> assign_slots(const TargetSkeleton& target,
                                              const std::vector<std::array<double, 3>>& positions);

// Pairs of connected slots: one's joint is the other's nearest ancestor with a slot.
//   connected  out  [rigging::kSlotPairs] 0 or 1
void connected_slots(const TargetSkeleton& target, const std::array<int, rigging::kSlots>& slots,
                     std::array<uint8_t, rigging::kSlotPairs>* connected);

// Steps of a point's position in its row (kRigPosition) in a longest side: twice the position, Q13.
constexpr double kPositionSteps = 16384;

// Targets of the first network for each slot, and of the second for each pair.
struct SlotSample : NetworkSample {
  std::vector<float> joints;  // [kSlots x 4] position in the mirror frame, offset from the skin; longest sides
  std::array<uint8_t, rigging::kSlots> present{};  // 1: the slot holds a joint; without one its joint is 0
  std::array<uint8_t, rigging::kSlotPairs> connected{};
};

// A set of points as both networks' sample: rows are not folded, and every point has one slot, which is present.
NetworkSample slot_points(const rigging::PointSet& set);
// Distance from a position to the nearest point of a sample of slot_points(), longest sides.
double skin_offset(const NetworkSample& sample, const std::array<double, 3>& position);
// As RigSource::make(). Throws Error for a skeleton without two joints that slots are for.
SlotSample make_slot_sample(const RigSource& source, uint64_t seed, double strength);

}  // namespace sinew
#endif
