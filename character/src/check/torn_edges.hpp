// SPDX-License-Identifier: MIT
// Edges that a pose tears: rig gates, and checks.
#ifndef SINEW_CHARACTER_CHECK_TORN_EDGES_HPP
#define SINEW_CHARACTER_CHECK_TORN_EDGES_HPP

#include <array>
#include <cstdint>
#include <vector>

#include "sinew_formats/character.hpp"

namespace sinew {

using TornEdge = std::array<uint32_t, 2>;

// One for each corner whose edge to the next corner is more than 4 times as long as at rest, and longer by 2 % of the mesh's longest side.
std::vector<TornEdge> torn_edges(const Character& rest, const Character& posed);

}  // namespace sinew
#endif
