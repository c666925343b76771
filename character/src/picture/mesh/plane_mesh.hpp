// SPDX-License-Identifier: MIT
// A silhouette in triangles, from its border and how thick it is where.
#ifndef SINEW_CHARACTER_PICTURE_MESH_PLANE_MESH_HPP
#define SINEW_CHARACTER_PICTURE_MESH_PLANE_MESH_HPP

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "picture/outline/raster.hpp"
#include "sinew_character/picture/figure.hpp"

namespace sinew::picture {

// The border of a mask as closed lines.

using Point2 = std::array<double, 2>;  // in pixels of the mask, x right, y down; a pixel's middle is at + 0.5
using Loop = std::vector<Point2>;      // closed; the figure is on the right hand

// Along the edges of pixels, stairs smoothed away. Loops of less than 12 edges are left out.
std::vector<Loop> contours_of(const Mask& mask);

// Indices into a loop, rising: no point of it is farther than `tolerance` from the lines between (Douglas, Peucker 1973), which are no longer than `longest`.
std::vector<size_t> simplified(const Loop& loop, double tolerance, double longest);

// How thick a silhouette is where: as round as it is wide.
struct Inflation {
  Grid<float> depth;   // pixels to the outline, 0 outside
  Grid<float> height;  // pixels from the picture plane to the surface: that of all balls inside of the outline together
};
Inflation inflate(const Mask& mask);

// A silhouette in triangles: its outline, and points of even distance within.
struct PlaneMesh {
  std::vector<Point2> points;
  std::vector<std::array<uint32_t, 3>> triangles;  // left about as seen with y down
  std::vector<uint8_t> rim;                        // [points] 1 on an edge of one triangle alone
};
// About `wanted` points; fewer of a figure of few pixels, more where outlines need them.
PlaneMesh triangulate(const Mask& mask, const Inflation& inflation, size_t wanted);

// Delaunay's triangulation of points in the plane, one after the other (Bowyer, Watson 1981), exact in 64-bit integers.
class Delaunay {
 public:
  // Coordinates of all points are 0..kMost: products of four differences, twelve of them, stay below 2^63.
  static constexpr int64_t kMost = 20000;

  Delaunay();
  // Its number, that of an earlier point at the same position.
  uint32_t insert(int64_t x, int64_t y);
  // Corners left about, numbers of insert(); those at the four corners of the plane are left out.
  std::vector<std::array<uint32_t, 3>> triangles() const;

 private:
  static constexpr uint32_t kFrame = 4;  // points of a square around all
  static constexpr int32_t kNone = -1;
  struct Triangle {
    std::array<uint32_t, 3> corners;
    std::array<int32_t, 3> beyond;  // across from each corner
    bool alive = true;
  };
  int64_t area(uint32_t a, uint32_t b, int64_t x, int64_t y) const;
  bool in_circle(const Triangle& t, int64_t x, int64_t y) const;
  size_t triangle_at(int64_t x, int64_t y) const;

  std::vector<std::array<int64_t, 2>> points_;
  std::vector<Triangle> all_;
  std::vector<int32_t> free_;
  size_t last_ = 0;
};

}  // namespace sinew::picture
#endif
