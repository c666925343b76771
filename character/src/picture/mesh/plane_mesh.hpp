// SPDX-License-Identifier: MIT
// A silhouette in triangles, from its border and how thick it is where.
#ifndef SINEW_CHARACTER_PICTURE_MESH_PLANE_MESH_HPP
#define SINEW_CHARACTER_PICTURE_MESH_PLANE_MESH_HPP

#include <array>
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

}  // namespace sinew::picture
#endif
