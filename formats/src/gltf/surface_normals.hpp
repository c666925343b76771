// SPDX-License-Identifier: MIT
// Normals of a character's surface, at rest and under a corrective shape.
#ifndef SINEW_FORMATS_GLTF_SURFACE_NORMALS_HPP
#define SINEW_FORMATS_GLTF_SURFACE_NORMALS_HPP

#include <array>
#include <cmath>
#include <map>
#include <vector>

#include "gltf/gltf_source.hpp"
#include "sinew_formats/morphs.hpp"

namespace sinew {

inline Point3 to_direction(const Vec3& v) {
  return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}

// Area-weighted normals of the welded surface, vertex by vertex.
class SurfaceNormals {
 public:
  explicit SurfaceNormals(const Character& character) : character_(character), faces_of_(character.vertices.size()) {
    for (const Vec3& v : character.vertices) positions_.push_back(to_direction(v));
    for (uint32_t f = 0; f < character.face_count(); ++f)
      for (size_t c = character.face_offsets[f]; c < character.face_offsets[f + 1]; ++c)
        faces_of_[character.face_vertices[c]].push_back(f);
    for (uint32_t v = 0; v < positions_.size(); ++v) rest_.push_back(normal_of(v, positions_));
  }

  const Point3& rest(uint32_t vertex) const { return rest_[vertex]; }

  // With the shape at weight 1: of the vertices beside those that it moves. Of length 1 or 0.
  std::map<uint32_t, Point3> under(const MorphShape& shape) {
    std::map<uint32_t, Point3> normals;
    move(shape, 1);
    for (const uint32_t moved : shape.vertices)
      for (const uint32_t f : faces_of_[moved])
        for (size_t c = character_.face_offsets[f]; c < character_.face_offsets[f + 1]; ++c) {
          const uint32_t v = character_.face_vertices[c];
          if (normals.count(v) == 0) normals[v] = normal_of(v, positions_);
        }
    move(shape, 0);
    return normals;
  }

 private:
  void move(const MorphShape& shape, double weight) {
    for (size_t i = 0; i < shape.vertices.size(); ++i) {
      const Point3 rest = to_direction(character_.vertices[shape.vertices[i]]),
                   interpolation = to_direction(shape.moves[i]);
      for (size_t c = 0; c < 3; ++c) positions_[shape.vertices[i]][c] = rest[c] + weight * interpolation[c];
    }
  }

  Point3 normal_of(uint32_t vertex, const std::vector<Point3>& positions) const {
    Point3 normal{};
    for (const uint32_t f : faces_of_[vertex])
      for (size_t c = character_.face_offsets[f] + 2; c < character_.face_offsets[f + 1]; ++c) {
        const Point3& at = positions[character_.face_vertices[character_.face_offsets[f]]];
        Point3 u{}, v{};
        for (size_t i = 0; i < 3; ++i) {
          u[i] = positions[character_.face_vertices[c - 1]][i] - at[i];
          v[i] = positions[character_.face_vertices[c]][i] - at[i];
        }
        for (size_t i = 0; i < 3; ++i) normal[i] += u[(i + 1) % 3] * v[(i + 2) % 3] - u[(i + 2) % 3] * v[(i + 1) % 3];
      }
    const double length = std::hypot(normal[0], normal[1], normal[2]);
    for (double& x : normal) x = length > 1e-300 ? x / length : 0;
    return normal;
  }

  const Character& character_;
  std::vector<std::vector<uint32_t>> faces_of_;  // [V]
  std::vector<Point3> positions_, rest_;         // [V]
};

// `v` rotated by the shortest rotation of `from` to `to`, all of length 1.
inline Point3 turned(const Point3& v, const Point3& from, const Point3& to) {
  const Point3 axis = {from[1] * to[2] - from[2] * to[1], from[2] * to[0] - from[0] * to[2],
                       from[0] * to[1] - from[1] * to[0]};
  const double cosine = from[0] * to[0] + from[1] * to[1] + from[2] * to[2];
  if (!(cosine > -0.99)) return v;
  const Point3 across = {axis[1] * v[2] - axis[2] * v[1], axis[2] * v[0] - axis[0] * v[2],
                         axis[0] * v[1] - axis[1] * v[0]};
  const double along = (axis[0] * v[0] + axis[1] * v[1] + axis[2] * v[2]) / (1 + cosine);
  return {cosine * v[0] + across[0] + along * axis[0], cosine * v[1] + across[1] + along * axis[1],
          cosine * v[2] + across[2] + along * axis[2]};
}

}  // namespace sinew
#endif
