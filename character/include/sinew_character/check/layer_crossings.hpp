// SPDX-License-Identifier: MIT
// Where two layers come through each other: the skin through the cloth.
#ifndef SINEW_CHARACTER_LAYER_CROSSINGS_HPP
#define SINEW_CHARACTER_LAYER_CROSSINGS_HPP

#include <cstdint>
#include <utility>
#include <vector>

#include "sinew_formats/character.hpp"

namespace sinew {

// Pairs (triangle of a, triangle of b) that cross: an edge of one goes through the other. Sorted; triangles are numbered as faces are
// cut into fans from their first corner.
std::vector<std::pair<uint32_t, uint32_t>> crossing_pairs(const Character& a, const Character& b);

// How many of the pairs of a pose did not cross at rest, where cloth may lie on the skin or in it. Both sorted.
size_t new_crossings(const std::vector<std::pair<uint32_t, uint32_t>>& rest,
                     const std::vector<std::pair<uint32_t, uint32_t>>& posed);

}  // namespace sinew
#endif
