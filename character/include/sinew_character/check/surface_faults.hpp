// SPDX-License-Identifier: MIT
// What a pose does to surfaces: layers that come through each other, the skin through the cloth, and torn edges.
#ifndef SINEW_CHARACTER_CHECK_SURFACE_FAULTS_HPP
#define SINEW_CHARACTER_CHECK_SURFACE_FAULTS_HPP

#include <array>
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

// Edges that a pose tears: rig gates, and checks.

using TornEdge = std::array<uint32_t, 2>;

// One for each corner whose edge to the next corner is more than 4 times as long as at rest, and longer by 2 % of the mesh's longest side.
std::vector<TornEdge> torn_edges(const Character& rest, const Character& posed);

}  // namespace sinew
#endif
