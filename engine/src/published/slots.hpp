// SPDX-License-Identifier: MIT
// A skeleton by the published method: joints in fixed slots, connections, their spanning tree.
#ifndef SINEW_PUBLISHED_SLOTS_HPP
#define SINEW_PUBLISHED_SLOTS_HPP

#include "published/joint_slots.hpp"
#include "rig/published.hpp"

namespace sinew::rigging {

// Outputs of both networks for a mesh.
struct SlotJoints {
  Vec3i positions[kSlots];         // grid units in the mirror frame
  int32_t presence[kSlots];        // logits, Q10
  int32_t scatter[kSlots];         // mean distance of what the points say from `positions`, grid units
  int32_t mesh[kMeshChannels];     // the mesh's row, Q10
  int16_t connection[kSlotPairs];  // logits, Q10
};

// Joints of one set, added to those of the sets before; `rows` are the first network's output.
//   attention  scratch, [kSetPoints]
void add_slot_joints(const SurfacePoint* points, const int16_t* rows, int64_t* attention, SlotJoints* sum);
// Rows of the second network, [kSlotPairs x kPairChannels].
void pair_rows(const SlotJoints& joints, int16_t* rows);
// Slots that hold a joint with a probability above one half, or the most probable one; joined by the tree of the most
// probable connections from the pelvis, or from the first slot; bone ends are children of their most probable parent.
// Parents come first. The spread is a quarter of the scatter of slots that hold a joint.
void join_slots(const SlotJoints& joints, BodyKind category, const RigOptions& options, Rig* rig);

// The second network of a model that open_slots_model() gave.
sinew_model connections_of(const sinew_model& model);

}  // namespace sinew::rigging
#endif
