// SPDX-License-Identifier: MIT
// The frames of a retargeted motion. Behind sinew_retarget_height(), _ground() and _frame().
#ifndef SINEW_MOTION_RETARGET_HPP
#define SINEW_MOTION_RETARGET_HPP

#include "motion/retarget_plan.hpp"
#include "sinew/joint_limits.h"

namespace sinew::motion {

// A source's frame into the plan's source_rotations and source_positions, in the target's world. SINEW_OK or
// SINEW_ERROR_NOT_FINITE.
sinew_status pose_source(sinew_retarget* plan, const float* rotations, const float* translations);
// A target's frame into target_rotations and target_positions, and back.
void load_target(sinew_retarget* plan, const float* rotations, const float* translations);
void store_target(const sinew_retarget& plan, float* rotations, float* translations);
// The horizontal path from the target's position at rest to where a frame of the source would carry it, which a plan in place leaves out.
Vec3d travel_of(const sinew_retarget& plan, const float* rotations, const float* translations);
// Moves the target's body, target_positions, by an offset.
void move_target(sinew_retarget* plan, Vec3d offset);

// As in sinew/motion.h; the caller has checked for null pointers.
sinew_status source_height(sinew_retarget* plan, const float* rotations, const float* translations, float* height);
// The floor that a source stands on at rest is its floor; hips at the origin, as captures have them, stand on none.
bool stands_at_rest(const sinew_retarget& plan);
// Height of the lowest floor joint in the source's current pose.
double lowest_floor_joint(const sinew_retarget& plan);
sinew_status standing_height(const sinew_retarget& plan, float* heights, size_t count, float* ground);
sinew_status retarget_frame(sinew_retarget* plan, const float* rotations, const float* translations, float ground,
                            float* out_rotations, float* out_translations);

// Hard limits of joints, as robots have them: hinges, and balls with a swing and a twist. As in sinew/joint_limits.h; the caller has checked for null pointers.
sinew_status keep_joint_limits(const sinew_joint_limit* limits, uint32_t limit_count, uint32_t joint_count,
                               uint32_t frame_count, float* rotations);

}  // namespace sinew::motion
#endif
