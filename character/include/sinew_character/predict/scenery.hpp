// SPDX-License-Identifier: MIT
// Finds the ground, backdrop or pedestal that a file has beside its body.
#ifndef SINEW_CHARACTER_SCENERY_HPP
#define SINEW_CHARACTER_SCENERY_HPP

#include <cstdint>
#include <vector>

#include "sinew_formats/character.hpp"

namespace sinew {

// Connected parts that may be scenery: each lies below all that is left and is at least half as large as that across up, or lies beside
// it and is nine tenths as large; and it has less than half of the vertices. Whether what is left is a body, the votes know.
// Returns [V] 1 for their vertices; empty where there are none.
std::vector<uint8_t> find_scenery(const Character& mesh, Axis up);

// A pedestal that is one surface with what stands on it, as sculptures have: up to a third of the height, sections are even, convex and
// wide, and right above they are half as large. Returns [V] as find_scenery() does.
std::vector<uint8_t> find_fused_base(const Character& mesh, Axis up);

}  // namespace sinew
#endif
