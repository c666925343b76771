// SPDX-License-Identifier: MIT
// One clip of a body in space becomes one in the picture's plane.
#ifndef SINEW_CHARACTER_PICTURE_PLANE_BONES_HPP
#define SINEW_CHARACTER_PICTURE_PLANE_BONES_HPP

#include <cstdint>
#include <vector>

#include "sinew_character/picture/picture_view.hpp"
#include "sinew_formats/motion.hpp"

namespace sinew {

//   body     a clip's skeleton that faces +z with y up
//   classes  [J] sinew_joint_class
//   plane    the same joints in the picture's plane, in the same order
Clip clip_in_plane(const Motion& body, const Clip& clip, const std::vector<uint8_t>& classes, PictureView view,
                   const Motion& plane);
// The clip in the picture's axes, with all that it does in space.
Clip clip_with_depth(const Motion& body, const Clip& clip, PictureView view, const Motion& plane);

}  // namespace sinew
#endif
