// SPDX-License-Identifier: MIT
// The skeleton of a body of solid parts: block animals.
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
  std::vector<Joint> joints;       // parents first; bone ends are called so
  std::vector<uint32_t> joint_of;  // [V] that moves the vertex's part
  std::array<float, 3> front = {0, 0, 1};
  bool front_seen = false;  // by small parts
};

// Connected parts that touch become a tree from the trunk, the part that most others touch. What is small, or lies within another, goes with
// it; every other part has a joint where it touches its parent. Names are by position: legs reach the ground, a tail is behind.
//   front       unit vector, horizontal
//   front_sure  false: small parts, eyes and a nose, say where the front is
// Returns nothing for a trunk that stands, or that has not two or more legs on both sides: votes know people and robots of parts better.
std::optional<PartSkeleton> part_skeleton(const Character& mesh, Axis up, const std::array<float, 3>& front,
                                          bool front_sure);

}  // namespace sinew
#endif
