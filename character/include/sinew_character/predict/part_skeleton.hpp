// SPDX-License-Identifier: MIT
// Skeleton of a body of solid parts, such as block animals.
#ifndef SINEW_CHARACTER_PART_SKELETON_HPP
#define SINEW_CHARACTER_PART_SKELETON_HPP

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "sinew_formats/base/box.hpp"
#include "sinew_formats/character.hpp"

namespace sinew {

struct PartSkeleton {
  std::vector<Joint> joints;       // parents first; bone ends have names with _end
  std::vector<uint32_t> joint_of;  // [V] joint of the vertex's part
  std::array<float, 3> front = {0, 0, 1};
  bool front_seen = false;  // derived from small parts
};

// Makes a tree of touching parts from the torso, the part that touches most others. Parts that are small or inside
// another one move with it; every other part has a joint where it touches its parent. Names come from positions: legs
// reach the ground, a tail is behind.
//   front       unit vector, horizontal
//   front_sure  false: small parts, such as eyes and a nose, determine the front
// Returns nothing for an upright torso, or one without two or more legs on both sides: votes are better for people
// and robots of parts.
std::optional<PartSkeleton> part_skeleton(const Character& mesh, Axis up, const std::array<float, 3>& front,
                                          bool front_sure);

}  // namespace sinew
#endif
