// SPDX-License-Identifier: MIT
// A character as a whole elsewhere: turned by quarters, scaled to a height, put on the floor.
#ifndef SINEW_CHARACTER_PLACEMENT_HPP
#define SINEW_CHARACTER_PLACEMENT_HPP

#include <cstdint>
#include <string>
#include <vector>

#include "sinew_formats/base/axis.hpp"
#include "sinew_formats/character.hpp"

namespace sinew {

// In this order: turns, height, floor.
struct Placement {
  std::vector<std::string>
      turns;           // quarters about the origin, one after the other: "x", "-x", "y", ...; x brings y to z
  double height = 0;   // metres along up, 0: as it is
  bool floor = false;  // the lowest vertex is at 0 along up
};

bool places(const Placement& placement);

// Throws Error for a turn of another name and a height that is none.
void check_placement(const Placement& placement);

// Mesh, joints and, of a glTF, the whole document, whose animations go along below one node more. Weights stay.
//   up_axis  the axis that points up then
// Throws Error for a placement that check_placement() refuses, a height of a mesh that has none, and a document of several scenes.
Character placed(Character character, const Placement& placement, Axis up_axis);

}  // namespace sinew
#endif
