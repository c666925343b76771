// SPDX-License-Identifier: MIT
// The result of `sinew rig PICTURE` for a mesh's outline, in the mesh's units.
#ifndef SINEW_CHARACTER_PICTURE_MESH_DRAWING_HPP
#define SINEW_CHARACTER_PICTURE_MESH_DRAWING_HPP

#include <array>
#include <cstdint>
#include <vector>

#include "sinew_character/picture/figure.hpp"
#include "sinew_formats/base/point.hpp"
#include "sinew_formats/character.hpp"

namespace sinew {

// Triangles drawn as in a picture: x right, y up, z towards the viewer.
class MeshDrawing {
 public:
  //   vertices   [V] with an extent along x or y
  //   triangles  numbers of vertices
  //   pixels     along the longest side, at least 32
  MeshDrawing(const std::vector<Point3>& vertices, const std::vector<std::array<uint32_t, 3>>& triangles,
              uint32_t pixels);

  Figure figure() const;
  // Returns picture_mesh() of the figure, in the axes and units of the vertices. Throws Error if too few pixels are
  // covered.
  Character round_mesh() const;
  // Returns the visible corner nearest to a point of the inflated mesh: from the front, or for points behind the
  // plane (z < 0) from the back.
  uint32_t corner_at(const Vec3& p) const;

 private:
  void fill(const std::array<Point3, 3>& corners, const std::array<uint32_t, 3>& numbers);
  void put(size_t pixel, double depth, uint32_t corner);
  double x_of(double x) const;
  double y_of(double y) const;

  double scale_ = 1, left_ = 0, top_ = 0;
  uint32_t width_ = 0, height_ = 0;
  std::vector<double> near_, far_;                  // [height x width]
  std::vector<uint32_t> near_corner_, far_corner_;  // [height x width] vertex
};

}  // namespace sinew
#endif
