// SPDX-License-Identifier: MIT
// Finds the ground, backdrop or pedestal that a file has in addition to its body.
#ifndef SINEW_CHARACTER_SCENERY_HPP
#define SINEW_CHARACTER_SCENERY_HPP

#include <cstdint>
#include <vector>

#include "sinew_formats/character.hpp"

namespace sinew {

// Returns connected parts that may be scenery. Each is below everything else and at least half as large horizontally,
// or beside it and at least nine tenths as large; and it has less than half of the vertices. The votes decide whether
// the rest is a body. Returns [V] 1 for their vertices; empty if there are none.
std::vector<uint8_t> find_scenery(const Character& mesh, Axis up);

// Finds a pedestal that is one surface with the figure on it, as in sculptures: up to a third of the height, cross
// sections are constant, convex and wide, and directly above them half as large. Returns [V] like find_scenery().
std::vector<uint8_t> find_fused_base(const Character& mesh, Axis up);

}  // namespace sinew
#endif
