// SPDX-License-Identifier: MIT
// Motion for a character in a plane: bones rotate only about the line of sight and keep their lengths.
#ifndef SINEW_CHARACTER_PLANE_MOTION_HPP
#define SINEW_CHARACTER_PLANE_MOTION_HPP

#include <cstdint>
#include <vector>

#include "sinew_character/jobs/animate_job.hpp"
#include "sinew_character/jobs/picture_job.hpp"
#include "sinew_character/jobs/picture_view.hpp"
#include "sinew_character/motion/map_skeleton.hpp"
#include "sinew_character/predict/fit_skeleton.hpp"
#include "sinew_formats/motion.hpp"

namespace sinew {

// Plays `input` on `out`, a picture's character with the skeleton of `picture`. The clip is retargeted by
// add_motion() onto a body that faces +z with separate sides; then each bone rotates like its projection. Limbs that
// swing towards and away from the viewer swing sideways instead. The lowest foot is as high above the floor as the
// body's.
//   depth  keep rotations out of the plane
void add_picture_motion(const PictureCharacter& picture, bool depth, const AnimateOptions& options,
                        const MotionInput& input, const StepsOf& steps, AnimatedCharacter* out);

// The built-in clip for a picture without a motion.
const char* default_clip(BodyClass body);

//   body     skeleton of a clip that faces +z with y up
//   classes  [J] sinew_joint_class
//   plane    the same joints in the picture's plane, in the same order
Clip clip_in_plane(const Motion& body, const Clip& clip, const std::vector<uint8_t>& classes, PictureView view,
                   const Motion& plane);
// The clip in the picture's axes, in three dimensions.
Clip clip_with_depth(const Motion& body, const Clip& clip, PictureView view, const Motion& plane);

// Maps limbs, the head and the pelvis of `target` and `source`: the n-th joint of a class and side, parents first,
// matches the n-th of the other. Sides come from names; bone ends are left out. Works for skeletons that are not
// connected like a body, for which anatomy fails.
std::vector<sinew_map_pin> pins_by_class(const LabeledSkeleton& target, const LabeledSkeleton& source);

}  // namespace sinew
#endif
