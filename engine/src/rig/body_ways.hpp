// SPDX-License-Identifier: MIT
// How far it is from joint to joint through the body.
#ifndef SINEW_RIG_BODY_WAYS_HPP
#define SINEW_RIG_BODY_WAYS_HPP

#include "rig/folded_tree.hpp"
#include "votes/interior.hpp"

namespace sinew::rigging {

// Each solid cell belongs to the joint that is nearest through the body, on both sides of the plane. Bones join what lies side by
// side: a path through a third joint's cells costs kPassing bits for each, and every path its length. Through
// the air it is four times as far.
//   interior  its distances become those from the joints
//   costs     out  [joints x joints] bits, Q16, below 2^24; the same in both directions
//   arena     scratch, all of it released
// Returns arena.ok().
bool find_body_ways(const FoldedTree* tree, Arena& arena, Interior* interior, int32_t* costs);

// The same by straight lines, where there is no body: 10 log2(e) bits for the side.
int32_t straight_cost(Vec3i a, Vec3i b);

}  // namespace sinew::rigging
#endif
