// SPDX-License-Identifier: MIT
// Motion for a character that lies in a plane: bones turn about the line of sight alone and keep their lengths.
#ifndef SINEW_CHARACTER_PLANE_MOTION_HPP
#define SINEW_CHARACTER_PLANE_MOTION_HPP

#include "sinew_character/jobs/animate_job.hpp"
#include "sinew_character/picture/picture_job.hpp"

namespace sinew {

// Plays `input` on `out`, which is a picture's character with the skeleton of `picture`. Joints are mapped and the clip is retargeted on a body that faces +z and has
// its sides apart, by add_motion(); then every bone turns as its projection does. Limbs that swing to and from the viewer do so sideways. The lowest foot
// is as high over the floor as the body's.
//   depth  keep what bones do out of the plane
void add_picture_motion(const PictureCharacter& picture, bool depth, const AnimateOptions& options,
                        const MotionInput& input, const StepsOf& steps, AnimatedCharacter* out);

// The bundled clip for a picture that is given no motion.
const char* default_clip(BodyClass body);

}  // namespace sinew
#endif
