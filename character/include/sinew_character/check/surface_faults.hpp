// SPDX-License-Identifier: MIT
// Faults of surfaces in a pose: layers that intersect, such as skin and cloth, and torn edges.
#ifndef SINEW_CHARACTER_CHECK_SURFACE_FAULTS_HPP
#define SINEW_CHARACTER_CHECK_SURFACE_FAULTS_HPP

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "sinew_formats/character.hpp"

namespace sinew {

// Returns pairs (triangle of a, triangle of b) that intersect: an edge of one passes through the other. Sorted;
// triangles are indexed after cutting faces into fans from their first corner.
std::vector<std::pair<uint32_t, uint32_t>> crossing_pairs(const Character& a, const Character& b);

// Returns the number of pairs that do not intersect at rest, where cloth may be on or in the skin. Both sorted.
size_t new_crossings(const std::vector<std::pair<uint32_t, uint32_t>>& rest,
                     const std::vector<std::pair<uint32_t, uint32_t>>& posed);

// Torn edges in a pose, for gates and checks.

using TornEdge = std::array<uint32_t, 2>;

// One per corner whose edge to the next corner is more than 4 times as long as at rest, and longer by 2 % of the
// mesh's longest side.
std::vector<TornEdge> torn_edges(const Character& rest, const Character& posed);

}  // namespace sinew
#endif
