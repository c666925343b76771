// SPDX-License-Identifier: MIT
// Influences as the engine skins with them.
#ifndef SINEW_FORMATS_POSE_WEIGHT_ROWS_HPP
#define SINEW_FORMATS_POSE_WEIGHT_ROWS_HPP

#include <cstdint>
#include <vector>

#include "sinew_formats/character.hpp"

namespace sinew {

struct WeightRows {
  size_t slots = 1;                       // as many as the longest row has, at most SINEW_MAX_INFLUENCES
  std::vector<uint16_t> joints, weights;  // [V x slots] by falling weight, unorm16 of sum 65535
  std::vector<uint8_t> bound;             // [V] 0: no weight; its row is joint 0
};

// Of a character with a row for every vertex. Throws Error for a joint that does not exist.
WeightRows weight_rows(const Character& character);

}  // namespace sinew
#endif
