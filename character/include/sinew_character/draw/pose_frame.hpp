// SPDX-License-Identifier: MIT
// Where pictures of a moving character look, so that no pose leaves them.
#ifndef SINEW_CHARACTER_POSE_FRAME_HPP
#define SINEW_CHARACTER_POSE_FRAME_HPP

#include <vector>

#include "sinew_formats/base/box.hpp"
#include "sinew_formats/character.hpp"

namespace sinew {

// At one scale; the picture goes with the body over the floor, and its height stays.
struct PoseFrame {
  std::vector<Vec3> middles;  // of every pose
  float radius =
      0;  // of a ball around each that holds its pose, seen from the side or a little from above; the mesh's units
};

// What stands still and reaches farther than all that moves, such as a ground, is not framed.
//   character  at rest, with at least one vertex
//   poses      at least one, with the character's vertices
PoseFrame frame_poses(const Character& character, const std::vector<Character>& poses, Axis up);

}  // namespace sinew
#endif
