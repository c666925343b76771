// SPDX-License-Identifier: MIT
// Cotangent Laplacian of the welded mesh in integers.
#ifndef SINEW_SOLVE_LAPLACIAN_HPP
#define SINEW_SOLVE_LAPLACIAN_HPP

#include "mesh/mesh.hpp"

namespace sinew {

constexpr int kEdgeWeightBits = 24;
constexpr int32_t kCotangentLimit = 50;  // of needle triangles; README.md says why 50

// L[i][i] = sum of the row's weights, L[i][j] = -weight of edge (i, j).
struct EdgeWeights {
  // [E2] Q24, within +-50, in the order of the mesh's CSR: mean of the cotangents opposite to the edge over its faces.
  // A boundary edge counts its one cotangent in full.
  int32_t* weight = nullptr;

  bool allocate(Arena& arena, const Counts& counts);
};

// Cotangent of the angle at `apex` of triangle (apex, b, c), Q24, limited to +-50. The triangle must not be degenerate.
int32_t cotangent_q24(Vec3i apex, Vec3i b, Vec3i c);

// Negative weights (obtuse triangles) stay as they are: the matrix is positive semi-definite with them.
// Returns SINEW_OK or SINEW_ERROR_WORKSPACE.
sinew_status weigh_edges(const Mesh& mesh, const Counts& counts, Arena& arena, EdgeWeights* out);

}  // namespace sinew
#endif
