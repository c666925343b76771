// SPDX-License-Identifier: MIT
// The frames of a retargeted motion. Behind sinew_retarget_height(), _ground() and _frame().
#ifndef SINEW_MOTION_RETARGET_HPP
#define SINEW_MOTION_RETARGET_HPP

#include "motion/retarget_plan.hpp"

namespace sinew {

// As in sinew/motion.h; the caller has checked for null pointers.
sinew_status source_height(sinew_retarget* plan, const float* rotations, const float* translations, float* height);
sinew_status standing_height(const sinew_retarget& plan, float* heights, size_t count, float* ground);
sinew_status retarget_frame(sinew_retarget* plan, const float* rotations, const float* translations, float ground,
                            float* out_rotations, float* out_translations);

}  // namespace sinew
#endif
