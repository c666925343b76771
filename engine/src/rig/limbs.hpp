// SPDX-License-Identifier: MIT
// Limbs of a tree: which joint goes on from which, and what a whole limb is.
#ifndef SINEW_RIG_LIMBS_HPP
#define SINEW_RIG_LIMBS_HPP

#include "rig/folded_tree.hpp"

namespace sinew::rigging {

// Whether a joint of the second class is the next of an arm or a leg behind one of the first.
bool continues_limb(uint32_t from, uint32_t to);

// Returns whether a joint of an arm or a leg would be a child of a tail, an ear or hair, or an ear of an arm or a
// leg.
bool leaves_limb(uint32_t from, uint32_t to);

// Whether both joints are of paired classes and lie on two sides, further from the plane than 2.5 % of the side. Of a mirrored tree
// none do: both sides are one.
bool lies_across(const FoldedNode& a, const FoldedNode& b);

// For each joint of a tree, what the votes that it owns are for: [joints x kLimbs] sums of probabilities, Q15.
using LimbVotes = int64_t[kMaxFoldedJoints][kLimbs];

// For each joint of a tree, how high the bones are that its points vote for: sums of both ends, halved.
struct Heights {
  int64_t points[kMaxFoldedJoints] = {}, sum[kMaxFoldedJoints] = {};
};

// A branch of an arm that lies above the head is an ear if the arm continues by a surer bone, and its votes for arms
// are for ears: big ears and bunches of hair that are voted for as arms. For mirrored trees: in others it may be the
// other arm, raised. Returns whether there was any. The tree is to be grown again then.
bool free_ears(const Heights& heights, LimbVotes& votes, FoldedTree* tree);

// Classes compete along a whole limb, not joint by joint: each branch of the torso becomes an arm, a leg, a tail, an
// ear or hair, as most of the votes for its joints say. A thigh of an arm becomes an upper arm, a foot a hand, all of
// an ear an ear. Tails, ears and hair of an arm or a leg stay, and so do toes of an arm. Without a mirror all joints
// of a limb are on one side: of two arms or two legs, the left one is the one that begins, or else lies, further to
// the left of its parent; others are on their own side of that. Of two that fork from one joint, the one on the other
// side becomes a child of the torso.
//   votes  in, out: the sums of a limb's joints are added to its first
void settle_limbs(LimbVotes& votes, FoldedTree* tree);

// Which limbs of a settled tree are legs by where they are, in a body of that kind: the lowest pair of a biped's, the
// rearmost pair of a quadruped's; the others are arms. If a body has only one pair, the votes are kept. If the kind
// is unknown and there are exactly two pairs of legs, with the front pair on a spine that starts at the parent of the
// rear pair, the front pair are arms; limbs of one joint are ignored.
//   votes  in, out: of each joint, not summed; a limb's votes for arms and legs are moved to its class
// Returns whether the class of a limb differs from the tree, which must then be grown again.
bool steer_limbs(BodyKind kind, FoldedTree* tree, LimbVotes& votes);

}  // namespace sinew::rigging
#endif
