// SPDX-License-Identifier: MIT
// A silhouette in triangles: its outline, and points of even distance within.
#ifndef SINEW_CHARACTER_PICTURE_MESH_PLANE_MESH_HPP
#define SINEW_CHARACTER_PICTURE_MESH_PLANE_MESH_HPP

#include <array>
#include <cstdint>
#include <vector>

#include "picture/mesh/contour.hpp"
#include "picture/mesh/inflation.hpp"

namespace sinew::picture {

struct PlaneMesh {
  std::vector<Point2> points;
  std::vector<std::array<uint32_t, 3>> triangles;  // left about as seen with y down
  std::vector<uint8_t> rim;                        // [points] 1 on an edge of one triangle alone
};
// About `wanted` points; fewer of a figure of few pixels, more where outlines need them.
PlaneMesh triangulate(const Mask& mask, const Inflation& inflation, size_t wanted);

}  // namespace sinew::picture
#endif
