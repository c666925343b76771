// SPDX-License-Identifier: MIT
// A coarser mesh instead of a very fine one: the stages after the mesh run on it, and its rows are interpolated back.
#ifndef SINEW_REDUCE_REDUCTION_HPP
#define SINEW_REDUCE_REDUCTION_HPP

#include "mesh/mesh.hpp"

namespace sinew {

// Where a vertex of the full mesh lies on the reduced one: up to three of its vertices with shares that sum to 32768.
// Unused entries have share 0.
struct SurfacePosition {
  uint32_t vertices[3];
  uint32_t shares[3];
};

// The reduced mesh. Its vertices are the means of clusters: each holds neighboring vertices of one part
// (or several whole small ones, where there are too many of them), in number alike, so that density stays
// where the artist put it. Triangles are those whose corners lie in three clusters, which keeps a closed surface closed
// (vertex clustering as a simplicial map). A cluster chain without triangles, as of a thin tube, keeps its neighbors
// by edges without a triangle.
struct Reduction {
  bool active = false;              // false: the full mesh is small enough, the rest is undefined
  Mesh mesh;                        // vertex_to_welded is not filled
  uint32_t* vertex = nullptr;       // [U full] reduced vertex
  uint32_t* fan_offsets = nullptr;  // [reduced vertices + 1] CSR into fans
  uint32_t* fans = nullptr;         // [3 T reduced] triangles at a vertex

  bool allocate(Arena& arena, const Counts& counts);
  // The nearest point to the full mesh's vertex on the reduced triangles at its cluster and, if it lies on their rim,
  // on those behind; where there are none, on the edges.
  SurfacePosition position(const Mesh& full, uint32_t full_vertex) const;
};

// Fills `out`, allocated for the same counts: active when the mesh exceeds what counts.surface() bounds. Returns
// SINEW_OK, SINEW_ERROR_WORKSPACE or SINEW_ERROR_CANCELLED.
sinew_status reduce_mesh(const Mesh& full, const Counts& counts, const Progress& progress, Arena& arena,
                         Reduction* out);

}  // namespace sinew
#endif
