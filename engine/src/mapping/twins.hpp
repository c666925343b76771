// SPDX-License-Identifier: MIT
// Left and right of a body that stands in no mirrored pose: two children of one joint with the same bones.
#ifndef SINEW_MAPPING_TWINS_HPP
#define SINEW_MAPPING_TWINS_HPP

#include "mapping/frame.hpp"

namespace sinew::mapping {

// Where few of the joints that have such a twin are its mirror image, the twins become the frame's sides: their mean
// direction `across`, `plane` through the joints they hang on, `mate`, and `posed`. A frame with mirror images stays.
//   up    null: not known yet
//   twin  [n] scratch
void take_twins(const Hierarchy& rig, const Point* up, int32_t* twin, Frame* frame);

}  // namespace sinew::mapping
#endif
