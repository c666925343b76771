// SPDX-License-Identifier: MIT
// Finds skirts, coat tails and capes of a bound body that have no joints of their own.
#ifndef SINEW_SPRINGS_FIND_GARMENTS_HPP
#define SINEW_SPRINGS_FIND_GARMENTS_HPP

#include <array>
#include <cstdint>
#include <vector>

#include "sinew_character/springs/find_springs.hpp"

namespace sinew {

// A hanging sheet as a lattice of lines from its top to its hem.
struct Garment {
  SpringKind kind = SpringKind::kSkirt;
  size_t on = 0;                // its parent joint
  std::vector<size_t> parents;  // [lines] parent joints of the lines: panels of a skirt beside a leg move with it
  bool ring = false;            // it goes all the way around: the last line is beside the first
  float certainty = 0;          // 0..1
  std::vector<std::vector<Point3>>
      lines;  // [lines][rows + 1], from the top to the hem; of a ring from the front over the left
  std::vector<uint32_t> vertices;
  std::vector<std::array<double, 2>> coordinates;  // [vertices] how many lines along (0..lines) and how far down (0..1)
};

constexpr uint8_t kSwings = 1, kSwingsAsGarment = 2;

// The garments of a body with two legs; an empty list for other bodies. In horizontal cross-sections a skirt encloses both legs, and a cape is a
// sheet that hangs behind the trunk.
//   classes  [J] sinew_joint_class
//   swings   [J] kSwings: the joint swings already, kSwingsAsGarment: in a chain of cloth or hair
std::vector<Garment> find_garments(const Character& character, const std::vector<uint8_t>& classes,
                                   const std::vector<uint8_t>& swings);

}  // namespace sinew
#endif
