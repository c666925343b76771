// SPDX-License-Identifier: MIT
// What is left to be mended in a clip, limb by limb.
#ifndef SINEW_MOTION_MEASURE_CLIP_HPP
#define SINEW_MOTION_MEASURE_CLIP_HPP

#include "motion/contacts.hpp"

namespace sinew::motion {

// Behind sinew_retarget_measure() and sinew_retarget_spots(), in memory of the same size. `limbs` [kMostLimbs]; `spots` [frames x
// kMostLimbs] or null.
sinew_status measure_clip(sinew_retarget* plan, const sinew_motion_body* source, const sinew_motion_body& target,
                          const ClipInputs& inputs, Arena& arena, sinew_limb_measure* limbs, uint32_t* limb_count,
                          sinew_contact_spot* spots);

}  // namespace sinew::motion
#endif
