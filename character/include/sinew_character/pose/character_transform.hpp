// SPDX-License-Identifier: MIT
// Transforms a whole character: rotation by multiples of 90 degrees, scale to a height, and translation to the floor.
#ifndef SINEW_CHARACTER_CHARACTER_TRANSFORM_HPP
#define SINEW_CHARACTER_CHARACTER_TRANSFORM_HPP

#include <cstdint>
#include <string>
#include <vector>

#include "sinew_formats/base/box.hpp"
#include "sinew_formats/character.hpp"

namespace sinew {

// Applied in this order: rotations, height, floor.
struct CharacterTransform {
  std::vector<std::string>
      turns;  // rotations by 90 degrees about an axis through the origin, in order: "x", "-x", "y", ...; x rotates y to z
  double height = 0;   // meters along up, 0: unchanged
  bool floor = false;  // the lowest vertex is at 0 along up
};

// Returns whether it changes nothing.
bool is_identity(const CharacterTransform& transform);

// Throws Error for an unknown rotation and an invalid height.
void check_transform(const CharacterTransform& transform);

// Transforms mesh, joints and, for a glTF, the whole document with its animations by an additional root node. Weights
// are unchanged.
//   up_axis  up axis after the rotations
// Throws Error for a transform that check_transform() rejects, a height for a mesh without extent, and a document
// with several scenes.
Character transformed(Character character, const CharacterTransform& transform, Axis up_axis);

}  // namespace sinew
#endif
