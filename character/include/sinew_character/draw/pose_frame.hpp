// SPDX-License-Identifier: MIT
// Camera framing for pictures of a moving character, so that all poses fit.
#ifndef SINEW_CHARACTER_POSE_FRAME_HPP
#define SINEW_CHARACTER_POSE_FRAME_HPP

#include <vector>

#include "sinew_formats/base/box.hpp"
#include "sinew_formats/character.hpp"

namespace sinew {

// The scale is constant; the picture follows the body over the floor at a constant height.
struct PoseFrame {
  std::vector<Vec3> middles;  // center of each pose
  float radius =
      0;  // radius of a sphere around each center that contains the pose, seen from the side or slightly from above; in the mesh's units
};

// Geometry that does not move and extends beyond everything that moves, such as a ground, is ignored.
//   character  at rest, with at least one vertex
//   poses      at least one, with the character's vertices
PoseFrame frame_poses(const Character& character, const std::vector<Character>& poses, Axis up);

}  // namespace sinew
#endif
