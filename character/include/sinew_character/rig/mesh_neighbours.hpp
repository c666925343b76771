// SPDX-License-Identifier: MIT
// Which vertices of a mesh lie at one place, and which lie beside each other.
#ifndef SINEW_CHARACTER_MESH_NEIGHBOURS_HPP
#define SINEW_CHARACTER_MESH_NEIGHBOURS_HPP

#include <cstdint>
#include <vector>

#include "sinew_formats/character.hpp"

namespace sinew {

// [V] the first vertex with the same position: meshes are cut at seams of normals and textures, surfaces are not.
std::vector<uint32_t> first_at_position(const Character& character);
// [V] one-rings over what first_at_position() gave, so that seams and split vertices do not cut the surface: neighbours along edges, each
// once, ascending; empty for vertices that are not the first at their position.
std::vector<std::vector<uint32_t>> welded_rings(const Character& character, const std::vector<uint32_t>& first);

// [V] the vertices at the other end of an edge, once for each face that has it; and of two vertices at one place each has the
// other, so that walks go on across seams.
std::vector<std::vector<uint32_t>> neighbours_of(const Character& character);

}  // namespace sinew
#endif
