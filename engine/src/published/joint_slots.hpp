// SPDX-License-Identifier: MIT
// The published method's skeleton: a fixed list of slots, each for one joint that a body may have; and the rows that its two
// networks read and write.
#ifndef SINEW_PUBLISHED_JOINT_SLOTS_HPP
#define SINEW_PUBLISHED_JOINT_SLOTS_HPP

#include "votes/body_kind.hpp"
#include "votes/rig_task.hpp"

namespace sinew::rigging {

enum class SlotSide : uint8_t { kMiddle, kLeft, kRight };  // left is +x of the mirror frame

struct JointSlot {
  JointClass joint_class;  // a bone end's is its joint's
  uint8_t number;          // along a chain, from the pelvis outwards
  bool tip;                // a bone end
  SlotSide side;
};

// Trunk 9 (4 spine, 2 neck), tail 5, each side 15: arm 5, leg 6, ear, wing 3.
constexpr uint32_t kSlots = 44;
// Every two slots: i < j, row by row.
constexpr uint32_t kSlotPairs = kSlots * (kSlots - 1) / 2;
constexpr uint32_t slot_pair(uint32_t i, uint32_t j) { return i * (2 * kSlots - i - 1) / 2 + j - i - 1; }

const JointSlot* joint_slots();  // [kSlots]

// Which slots may hold a joint. any: all. biped: trunk, arms, legs. quadruped: these, tail, ears. bird: trunk, legs, wings, tail.
// fish: trunk, tail, wings for fins. snake: trunk, tail. many-legged: trunk, arms, legs, tail.
bool in_category(const JointSlot& slot, BodyKind category);

// First network. It reads what votes' network reads of a point, not folded, and writes of every point for every slot:
// how much the slot points at it (log2), the joint's offset from it (3, kRigOffsetScale times the share of the side), whether
// the slot holds a joint (logit). Behind them stands the mesh's row for the second network, the same for all points.
constexpr uint32_t kSlotAttention = 0, kSlotPointOffset = 1, kSlotLogit = 4, kSlotChannels = 5;
constexpr uint32_t kMeshRow = kSlots * kSlotChannels, kMeshChannels = 32;
constexpr uint32_t kSlotRow = kMeshRow + kMeshChannels;
// Second network, a row for every two slots: offset vector from joint to joint and its length (shares of the side), which two
// slots, the mesh's row divided by kMeshRowDivisor. It writes the logit that the joints are connected.
constexpr uint32_t kPairOffset = 0, kPairFirst = 4, kPairSecond = kPairFirst + kSlots, kPairMesh = kPairSecond + kSlots;
constexpr uint32_t kPairChannels = kPairMesh + kMeshChannels;
constexpr int kMeshRowDivisor = 8;

bool slots_task(uint32_t feature_set, ModelTask* task);

// Rows of a set as the first network reads them: x is not folded.
//   rows  out  [kSetPoints x kRigChannels]
void unfold_features(const PointSet& set, int16_t* rows);

}  // namespace sinew::rigging
#endif
