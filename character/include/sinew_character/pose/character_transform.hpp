// SPDX-License-Identifier: MIT
// A character as a whole elsewhere: turned by quarters, scaled to a height, put on the floor.
#ifndef SINEW_CHARACTER_CHARACTER_TRANSFORM_HPP
#define SINEW_CHARACTER_CHARACTER_TRANSFORM_HPP

#include <cstdint>
#include <string>
#include <vector>

#include "sinew_formats/base/box.hpp"
#include "sinew_formats/character.hpp"

namespace sinew {

// In this order: turns, height, floor.
struct CharacterTransform {
  std::vector<std::string>
      turns;           // quarters about the origin, one after the other: "x", "-x", "y", ...; x brings y to z
  double height = 0;   // meters along up, 0: as it is
  bool floor = false;  // the lowest vertex is at 0 along up
};

// Whether it changes nothing.
bool is_identity(const CharacterTransform& transform);

// Throws Error for a turn of another name and a height that is none.
void check_transform(const CharacterTransform& transform);

// Mesh, joints and, of a glTF, the whole document, whose animations go along below one node more. Weights stay.
//   up_axis  the axis that points up then
// Throws Error for a transform that check_transform() refuses, a height of a mesh that has none, and a document of several scenes.
Character transformed(Character character, const CharacterTransform& transform, Axis up_axis);

}  // namespace sinew
#endif
