// SPDX-License-Identifier: MIT
// Points spread evenly over a mesh's surface: what a skeleton is predicted from, however fine or coarse the mesh.
#ifndef SINEW_FRONT_SURFACE_POINTS_HPP
#define SINEW_FRONT_SURFACE_POINTS_HPP

#include "mesh/mesh.hpp"

namespace sinew::rigging {

constexpr uint32_t kSetPoints = 512;  // that a network sees at once
constexpr uint32_t kNoTriangle = 0xFFFFFFFFu;

struct SurfacePoint {
  Vec3i position;      // grid units
  Vec3i normal;        // Q14, as the triangle is wound; (0, 0, 0) without a triangle
  uint32_t triangle;   // of the mesh, or kNoTriangle for a mesh without area, whose points are vertices
  uint32_t corner[3];  // vertices
  uint16_t share[3];   // of the corners, Q15; they sum to 2^15
};

// A feature of a point, Q13, held within +-2.
constexpr int kToQ13 = kGridBits - 13;  // a share of the side in grid units to Q13
inline int16_t feature(int64_t value) { return clamp16(value, -16384, 16383); }

// `count` points, one in each of as many strata of the area: point i lies where the area of the triangles before it
// reaches a random share between i / count and (i + 1) / count. The same seed gives the same points.
void spread_points(const Mesh& mesh, uint32_t count, uint64_t seed, SurfacePoint* points);

// Whether nearly all of the surface faces one direction and its opposite: a card, a terrain. The sum of the squares
// of the eigenvalues of the normals' covariance is above 4/5 of the square of their sum then; it is 1/3 for a ball,
// 1/2 for a long tube, at most 0.72 for 490 characters.
bool is_sheet(const SurfacePoint* points, uint32_t count);
// A sheet's joints are no better than the middle line, however sure the votes are: no mesh of the training is one. Q16 of the side.
constexpr uint16_t kSheetSpread = 6554;

}  // namespace sinew::rigging
#endif
