// SPDX-License-Identifier: MIT
// Hard limits of joints, as robots have them: hinges, and balls with a swing and a twist. Behind sinew_keep_joint_limits().
#ifndef SINEW_MOTION_JOINT_LIMITS_HPP
#define SINEW_MOTION_JOINT_LIMITS_HPP

#include "sinew/joint_limits.h"

namespace sinew::motion {

// As in sinew/joint_limits.h; the caller has checked for null pointers.
sinew_status keep_joint_limits(const sinew_joint_limit* limits, uint32_t limit_count, uint32_t joint_count,
                               uint32_t frame_count, float* rotations);

}  // namespace sinew::motion
#endif
