// SPDX-License-Identifier: MIT
// Chains of joints for the parts of a body that no bone explains: limbs, tails, trunks and horns without votes.
#ifndef SINEW_RIG_COVERAGE_HPP
#define SINEW_RIG_COVERAGE_HPP

#include "rig/folded_tree.hpp"
#include "votes/interior.hpp"

namespace sinew::rigging {

// Adds a chain of joints for everything that stands out of the body farther than the bones below it explain: farther along the body
// than twice the bone's radius. The farthest first, at most kMostChains; of what a mirrored body has on both sides one, of what it
// has on one side one that is alone. Joints lie in the middle of what stands out, at equal steps, the last is the bone's end.
// No vote speaks for them: their confidence is 0. Their classes say where they are: a tail behind the torso, hair or an ear on a head,
// a leg where the floor is reached, else other.
//   interior  its distances are overwritten
//   tree      in, out: as grow_tree() leaves it
//   arena     scratch, all of it released
// Returns arena.ok().
bool cover_body(Arena& arena, Interior* interior, FoldedTree* tree);

}  // namespace sinew::rigging
#endif
