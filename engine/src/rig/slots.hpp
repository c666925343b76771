// SPDX-License-Identifier: MIT
// A skeleton by the published method: joints in fixed slots, connections, their spanning tree.
#ifndef SINEW_RIG_SLOTS_HPP
#define SINEW_RIG_SLOTS_HPP

#include "core/counts.hpp"
#include "kernels/table.hpp"
#include "mesh/mesh.hpp"
#include "network/network.hpp"
#include "rig/joint_slots.hpp"
#include "rig/tree.hpp"

namespace sinew::rigging {

struct SlotsPlan {
  sinew_model joints, connections;  // the file's two networks
  NetworkOptions network;
  BodyKind category = BodyKind::kAny;
};

// What both networks say of a mesh.
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
// Slots that more likely than not hold a joint, or the likeliest one; joined by the tree of the likeliest connections from the
// pelvis, or the first slot there is; bone ends hang on the joint that they likeliest hang on. Parents come first. The spread is a
// quarter of the scatter of slots that hold a joint.
void join_slots(const SlotJoints& joints, BodyKind category, const RigOptions& options, Rig* rig);

// All of it for a mesh in its mirror frame. Scratch is taken from the arena and released. Returns SINEW_OK,
// SINEW_ERROR_WORKSPACE or SINEW_ERROR_CANCELLED.
sinew_status find_slots(const SlotsPlan& plan, const RigOptions& options, const Mesh& mesh, const Kernels& kernels,
                        const Progress& progress, Arena& arena, Rig* rig);

}  // namespace sinew::rigging
#endif
