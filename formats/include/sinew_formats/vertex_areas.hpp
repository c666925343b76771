// SPDX-License-Identifier: MIT
// Surface area of each vertex.
#ifndef SINEW_FORMATS_VERTEX_AREAS_HPP
#define SINEW_FORMATS_VERTEX_AREAS_HPP

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "sinew_formats/character.hpp"

namespace sinew {

inline double triangle_area(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double u[3] = {double{b.x} - a.x, double{b.y} - a.y, double{b.z} - a.z};
  const double v[3] = {double{c.x} - a.x, double{c.y} - a.y, double{c.z} - a.z};
  return 0.5 * std::hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]);
}

// [V] a third of the area of each triangle around a vertex; polygons are fans. 0 without a surface. In squared units
// of the file.
inline std::vector<double> vertex_areas(const Character& character) {
  std::vector<double> areas(character.vertices.size(), 0.0);
  for (size_t f = 0; f + 1 < character.face_offsets.size(); ++f) {
    const uint32_t* const corners = character.face_vertices.data() + character.face_offsets[f];
    for (size_t k = 2; k < character.face_offsets[f + 1] - character.face_offsets[f]; ++k) {
      const uint32_t triangle[3] = {corners[0], corners[k - 1], corners[k]};
      const double third = triangle_area(character.vertices[triangle[0]], character.vertices[triangle[1]],
                                         character.vertices[triangle[2]]) /
                           3;
      for (const uint32_t v : triangle) areas[v] += third;
    }
  }
  return areas;
}

}  // namespace sinew
#endif
