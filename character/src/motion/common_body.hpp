// SPDX-License-Identifier: MIT
// The common part of two characters of one mesh: makers dress one body in other clothes.
#ifndef SINEW_CHARACTER_MOTION_COMMON_BODY_HPP
#define SINEW_CHARACTER_MOTION_COMMON_BODY_HPP

#include <cstdint>
#include <vector>

#include "sinew_formats/character.hpp"

namespace sinew {

struct CommonBody {
  std::vector<uint32_t> first, second;  // [V] vertex of each character
  std::vector<uint32_t> triangles;      // [T x 3] into those
};

// Faces are compared in their order, vertices in the order in which faces name them: a file that was written and read again
// numbers them anew. As far as the two go together; of one character with itself all of it.
CommonBody common_body(const Character& first, const Character& second);

// Takes triangles out that are no skin: of the connected pieces only those that reach from a hand to the rest of the body stay, a
// quarter of all triangles or more, where there is one. Clothes and hair hang over what a hand touches.
//   in_hand  [joints of the first character]
void keep_skin(const Character& first, const std::vector<bool>& in_hand, CommonBody* body);

}  // namespace sinew
#endif
