// SPDX-License-Identifier: MIT
// A motion of the character's own rig: names and hierarchy agree, and nothing is left to find.
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

}  // namespace sinew::mapping
#endif
