// SPDX-License-Identifier: MIT
// The surface that a screen shows: triangles, with vertices doubled along creases so that hard edges stay hard.
#ifndef SINEW_WEB_SURFACE_HPP
#define SINEW_WEB_SURFACE_HPP

#include <cstdint>
#include <vector>

#include "sinew_formats/character.hpp"

namespace sinew::web {

struct Surface {
  std::vector<uint32_t> vertex_of;  // [R] shown vertex -> vertex of the Character
  std::vector<uint32_t> triangles;  // [T x 3] shown vertices
};

// Polygons become fans. Two faces of a vertex share a shown vertex while their normals differ by less than 40 degrees.
Surface make_surface(const Character& character);

// Area-weighted normals of the shown vertices [R x 3] for the Character's vertices at `positions` [V x 3].
void surface_normals(const Surface& surface, const std::vector<float>& positions, std::vector<float>* normals);

}  // namespace sinew::web
#endif
