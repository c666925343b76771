// SPDX-License-Identifier: MIT
// Targets of the published method: which of a skeleton's joints each slot of the engine's published/joint_slots.hpp holds.
#ifndef SINEW_TRAINER_JOINT_SLOTS_HPP
#define SINEW_TRAINER_JOINT_SLOTS_HPP

#include <array>
#include <cstdint>
#include <vector>

#include "published/joint_slots.hpp"
#include "sinew_data_sets/target_skeleton.hpp"

namespace sinew {

// The joint vector of a slot: position in the mirror frame (3) and offset from the skin, its length; all in longest sides. Then,
// of what a network says, how likely the slot holds a joint, 0 to 1.
constexpr uint32_t kSlotOffset = 3, kSlotPresence = 4, kSlotNumbers = 5;

// Which joint of a skeleton each slot holds, -1 for none. Joints come by their depth below the root, those nearer to the
// outside first; each takes the first free slot of its class and side. Of a chain that is longer than its slots, joints
// at equal steps stay. Classes without slots (hair, other) and what finds none free are left out.
//   positions  in  [target] in the mirror frame: x tells the side
std::array<int, rigging::kSlots> assign_slots(const TargetSkeleton& target,
                                              const std::vector<std::array<double, 3>>& positions);

// Pairs of slots that hang together: one's joint is the other's nearest ancestor with a slot.
//   connected  out  [rigging::kSlotPairs] 0 or 1
void connected_slots(const TargetSkeleton& target, const std::array<int, rigging::kSlots>& slots,
                     std::array<uint8_t, rigging::kSlotPairs>* connected);

}  // namespace sinew
#endif
