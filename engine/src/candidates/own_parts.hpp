// SPDX-License-Identifier: MIT
// Which leaf joints own a small part of the mesh and nothing else, as the joint of an eye does (before stage 3).
#ifndef SINEW_CANDIDATES_OWN_PARTS_HPP
#define SINEW_CANDIDATES_OWN_PARTS_HPP

#include "mesh/mesh.hpp"
#include "skeleton/skeleton.hpp"

namespace sinew {

// Fills owners [parts of the mesh]: the joint that owns the part, or kNoJoint. A joint that owns a part becomes
// unusable, so that it gets weight nowhere else; rows of the part are the joint alone (weights/finish.hpp).
//
// A usable leaf with a usable parent owns a part whose box's longest side is at most a 32nd of kSide and at most 2.5
// times the shortest one, if the joint is at most 0.3 of that side from the box's middle (in the largest coordinate), no
// other joint is within half of it, and the parent is between 2 and 6 of it away. All parts within 0.6 of the side from
// the middle are the joint's then, as the lens before an eye.
//
// Each bound leaves out something measured: joints of robots lie in hinges too, but near their parents or in discs; and
// tips of chains in strands of hair. Of 490 characters the rule changes one, a werewolf, and is right in both of its
// eyes; it is right in the ten eyes of five public avatars.
//
// Scratch is taken from the arena and released. Returns SINEW_OK or SINEW_ERROR_WORKSPACE.
sinew_status find_own_parts(const Mesh& mesh, const Counts& counts, Arena& arena, Skeleton* skeleton, uint16_t* owners);

}  // namespace sinew
#endif
