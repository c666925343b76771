// SPDX-License-Identifier: MIT
// Per-vertex surface quantities of the welded mesh, the second half of stage 2.
#ifndef SINEW_MESH_SURFACE_HPP
#define SINEW_MESH_SURFACE_HPP

#include "mesh/mesh.hpp"

namespace sinew {

struct SurfaceScratch {
  uint8_t* boundary = nullptr;    // [U] in: 1 where an edge of the vertex has only one triangle
  Vec3l* normal_sums = nullptr;   // [U]
  int64_t* angle_sums = nullptr;  // [U]
};

// Fills normals, areas, mean_curvature, gauss_curvature and edge_length from positions, triangles and the
// CSR.
void measure_surface(const SurfaceScratch& scratch, const Threads& threads, Mesh* mesh);

}  // namespace sinew
#endif
