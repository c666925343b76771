// SPDX-License-Identifier: MIT
// A motion of the character's own rig: names and hierarchy agree, or hierarchy and rest positions do, and nothing is left to find.
#ifndef SINEW_MAPPING_SAME_RIG_HPP
#define SINEW_MAPPING_SAME_RIG_HPP

#include "mapping/hierarchy.hpp"
#include "sinew/map.h"

namespace sinew::mapping {

// Whether joints have joints of their names in the other rig, below the one of their parent's name: all but leaves and what holds the
// whole rig, and at least half of either rig. Then sources [target n] are those joints, -1 for what has none. targets [source n] is
// scratch.
bool is_same_rig(const sinew_skeleton& target, const sinew_skeleton& source, const Hierarchy& own,
                 const Hierarchy& other, int32_t* sources, int32_t* targets);

// The same of rigs under other names: every joint has as many children, which lie from it as the other's do, up to 30 % of a bone, both
// rigs in one size and turned alike; and no name says another side, nor one of ten another part. Then sources [target n] is whole. targets as above.
bool is_same_shape(const Hierarchy& own, const Hierarchy& other, int32_t* sources, int32_t* targets);

}  // namespace sinew::mapping
#endif
