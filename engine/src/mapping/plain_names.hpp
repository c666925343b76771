// SPDX-License-Identifier: MIT
// What plain names of two bodies say of each other, where anatomy goes wrong.
#ifndef SINEW_MAPPING_PLAIN_NAMES_HPP
#define SINEW_MAPPING_PLAIN_NAMES_HPP

#include "mapping/hierarchy.hpp"
#include "mapping/matcher.hpp"

namespace sinew::mapping {

// Whether a map by anatomy goes against so many of the joints of limbs and heads that are named alike, each once in its rig, that its
// reading of one of the bodies is wrong; of upright ones alone. Then these joints are pinned; pins that the caller gave stay.
//   sources  [target n] the map
bool pin_plain_names(const Hierarchy& target, const Hierarchy& source, const int32_t* sources, Pins* pins);

}  // namespace sinew::mapping
#endif
