// SPDX-License-Identifier: MIT
// The published method's skeleton: a fixed list of slots, each for one joint that a body may have.
#ifndef SINEW_TRAINER_JOINT_SLOTS_HPP
#define SINEW_TRAINER_JOINT_SLOTS_HPP

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "rig/joint_class.hpp"
#include "sinew_datasets/target_skeleton.hpp"

namespace sinew {

enum class SlotSide : uint8_t { kMiddle, kLeft, kRight };  // left is +x of the mirror frame

struct JointSlot {
  JointClass joint_class = kClassOther;  // a bone end's is its joint's
  uint8_t number = 0;                    // along a chain, from the pelvis outwards
  bool tip = false;                      // a bone end
  SlotSide side = SlotSide::kMiddle;
};

// Trunk 9 (4 spine, 2 neck), tail 5, each side 15: arm 5, leg 6, ear, wing 3.
constexpr uint32_t kSlots = 44;
// Every two slots: i < j, row by row.
constexpr uint32_t kSlotPairs = kSlots * (kSlots - 1) / 2;
constexpr uint32_t slot_pair(uint32_t i, uint32_t j) { return i * (2 * kSlots - i - 1) / 2 + j - i - 1; }

const std::array<JointSlot, kSlots>& joint_slots();

// The joint vector of a slot: place in the mirror frame (3) and offset from the skin, which is the distance to the nearest
// vertex, all in longest sides; then, of what a network says, how likely the slot holds a joint, 0 to 1.
constexpr uint32_t kSlotOffset = 3, kSlotPresence = 4, kSlotNumbers = 5;

// What kind of body: says which slots may hold a joint.
enum class SlotCategory : uint8_t { kAny, kBiped, kQuadruped, kBird, kFish };
// "any", "biped", "quadruped", "bird", "fish".
const std::vector<std::string>& slot_category_names();
// Throws Error with the names that there are.
SlotCategory slot_category(const std::string& name);
// any: all. biped: trunk, arms, legs. quadruped: these, tail, ears. bird: trunk, legs, wings, tail. fish, and snakes: trunk,
// tail, wings for fins.
bool in_category(const JointSlot& slot, SlotCategory category);

// Which joint of a skeleton each slot holds, -1 for none. Joints come by their depth below the root, those nearer to the
// outside first; each takes the first free slot of its class and side. Of a chain that is longer than its slots, joints
// at equal steps stay. Classes without slots (hair, other) and what finds none free are left out.
//   places  in  [target] in the mirror frame: x tells the side
std::array<int, kSlots> assign_slots(const TargetSkeleton& target, const std::vector<std::array<double, 3>>& positions);

// Pairs of slots that hang together: one's joint is the other's nearest ancestor with a slot.
//   connected  out  [kSlotPairs] 0 or 1
void connected_slots(const TargetSkeleton& target, const std::array<int, kSlots>& slots,
                     std::array<uint8_t, kSlotPairs>* connected);

}  // namespace sinew
#endif
