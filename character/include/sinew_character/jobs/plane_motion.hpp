// SPDX-License-Identifier: MIT
// Motion for a character that lies in a plane: bones turn about the line of sight alone and keep their lengths.
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

// Plays `input` on `out`, which is a picture's character with the skeleton of `picture`. Joints are mapped and the clip is retargeted on a body that faces +z and has
// its sides apart, by add_motion(); then every bone turns as its projection does. Limbs that swing to and from the viewer do so sideways. The lowest foot
// is as high over the floor as the body's.
//   depth  keep what bones do out of the plane
void add_picture_motion(const PictureCharacter& picture, bool depth, const AnimateOptions& options,
                        const MotionInput& input, const StepsOf& steps, AnimatedCharacter* out);

// The bundled clip for a picture that is given no motion.
const char* default_clip(BodyClass body);

//   body     a clip's skeleton that faces +z with y up
//   classes  [J] sinew_joint_class
//   plane    the same joints in the picture's plane, in the same order
Clip clip_in_plane(const Motion& body, const Clip& clip, const std::vector<uint8_t>& classes, PictureView view,
                   const Motion& plane);
// The clip in the picture's axes, with all that it does in space.
Clip clip_with_depth(const Motion& body, const Clip& clip, PictureView view, const Motion& plane);

// Limbs, the head and the pelvis of `target` and `source`, joint by joint: the n-th of a class and a side of one, parents first, is
// the n-th of the other. Sides are those of the names; bone ends are left out. Also of a skeleton that does not hang together as a
// body does, which anatomy makes nothing of.
std::vector<sinew_map_pin> pins_by_class(const LabeledSkeleton& target, const LabeledSkeleton& source);

}  // namespace sinew
#endif
