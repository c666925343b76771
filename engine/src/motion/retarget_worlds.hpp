// SPDX-License-Identifier: MIT
// How the source's world lies in the target's: which way is up in both, and the rotation between them.
#ifndef SINEW_MOTION_RETARGET_WORLDS_HPP
#define SINEW_MOTION_RETARGET_WORLDS_HPP

#include "motion/retarget_plan.hpp"

namespace sinew::motion {

// Sets up and rotation of a plan whose map, anchors and floor joints are found.
void find_worlds(const RetargetOptions& options, sinew_retarget* plan);

}  // namespace sinew::motion
#endif
