// SPDX-License-Identifier: MIT
// How the surface lies around each vertex of the welded mesh, the second half of stage 2.
#ifndef SINEW_MESH_SHAPE_HPP
#define SINEW_MESH_SHAPE_HPP

#include "mesh/mesh.hpp"

namespace sinew {

// A triangle's contribution to its corners.
struct TriangleShape {
  int64_t twice_area;
  Vec3i normal;       // unit, Q24
  int32_t angles[3];  // of the corners
};

struct ShapeScratch {
  uint8_t* boundary = nullptr;         // [U] in: 1 where an edge of the vertex has only one triangle
  Vec3l* normal_sums = nullptr;        // [U]
  int64_t* angle_sums = nullptr;       // [U]
  TriangleShape* triangles = nullptr;  // [round_size() of the triangles]
};

// Fills normals, areas, mean_curvature, gauss_curvature and edge_length from positions, triangles and the CSR.
void find_shape(const ShapeScratch& scratch, const Threads& threads, Mesh* mesh);

}  // namespace sinew
#endif
