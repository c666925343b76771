// SPDX-License-Identifier: MIT
// Where a surface bends, and what lies near.
#ifndef SINEW_CHARACTER_BAKE_BENDS_HPP
#define SINEW_CHARACTER_BAKE_BENDS_HPP

#include <vector>

#include "sinew_formats/character.hpp"

namespace sinew {

struct Bends {
  std::vector<size_t> joints;  // with a parent, such that vertices follow both what is below and something else
  std::vector<std::vector<double>> distances;  // [bends][J] joints between the bend and what follows a joint
  std::vector<std::vector<size_t>> of_vertex;  // [V] numbers of bends, the nearest first; none where nothing bends
};

Bends find_bends(const Character& character, size_t most_of_a_vertex);

}  // namespace sinew
#endif
