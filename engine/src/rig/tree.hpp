// SPDX-License-Identifier: MIT
// Votes to a skeleton: folded joints, their tree, what the caller asks for, both sides.
#ifndef SINEW_RIG_TREE_HPP
#define SINEW_RIG_TREE_HPP

#include "core/arena.hpp"
#include "rig/folded_tree.hpp"
#include "rig/rig_joint.hpp"
#include "sinew/sinew.h"
#include "votes/interior.hpp"
#include "votes/votes.hpp"

namespace sinew::rigging {

struct RigOptions {
  bool fold =
      true;  // folded votes count on both sides; if not, joints of both sides are found apart and nothing is mirrored
  int32_t spine = -1;  // joints between pelvis and neck or head, at most kMaxSpine; -1: as the votes say
  bool toes = true;    // keep toe joints
  bool ends = true;    // keep bone ends
  BodyKind kind = BodyKind::kAny;
};

struct Rig {
  uint32_t count = 0;          // at least 1 when found
  RigJoint* joints = nullptr;  // [kMaxRigJoints]
  uint16_t spread = 0;         // Q16 of the side: geometric mean of all votes' spreads. Large: the votes know nothing

  bool allocate(Arena& arena);
};

// Joints in depth-first order: a joint, its bone end, its children by class; of two that mirror each other the branch
// at +x first. Partners differ in the sign of x and nothing else, their parents are partners or one joint. Where no
// votes gather, the one joint is a pelvis at the points' mean.
//   votes    in   at most kMaxRigPoints points, positions below 2^24 in size, probabilities at most 2^15
//   interior      of the mesh in the mirror frame, or null (folded_tree.hpp); its distances are overwritten
//   rig      out  allocated
//   arena         scratch, all of it released
// Returns SINEW_OK or SINEW_ERROR_WORKSPACE. Exact in integers: the same joints on every platform and for the points in
// any order.
sinew_status find_rig(const Votes& votes, const RigOptions& options, Interior* interior, Arena& arena, Rig* rig);

// The last stage of find_rig(), for a tree from elsewhere: the caller's options, then both sides.
void unfold_tree(const RigOptions& options, FoldedTree* tree, Rig* rig);

constexpr uint32_t kMaxSpine = 16;

// Replaces the spine joints between the pelvis and the neck or head by `joints` <= kMaxSpine at equal steps: from the
// first to the last that existed, or between the joints below and above if there were less than two. Without neck and
// head it is the longest chain of spine joints. Children of a removed joint become children of the nearest one. A
// root is no part of the chain, whatever its class. Fewer are made if the tree would be full; without such a chain
// the tree is unchanged.
void set_spine(FoldedTree* tree, uint32_t joints);

// A clavicle or hip that holds neither a joint nor an end holds the upper arm or thigh that was attached to the torso
// beside it; where there is none it is removed, because nothing bends there.
void settle_stubs(FoldedTree* tree);

// Removes toe joints, except a root. A foot that becomes a leaf ends at its heaviest toe; other children of a toe
// become children of the foot.
void drop_toes(FoldedTree* tree);

}  // namespace sinew::rigging
#endif
