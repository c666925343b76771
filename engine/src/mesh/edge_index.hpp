// SPDX-License-Identifier: MIT
// Index of an edge in the one-ring lists of a mesh.
#ifndef SINEW_MESH_EDGE_INDEX_HPP
#define SINEW_MESH_EDGE_INDEX_HPP

#include "mesh/mesh.hpp"

namespace sinew {

// Index into col_indices of the neighbor `to` of `from`; the edge must be there.
inline uint32_t edge_index(const Mesh& mesh, uint32_t from, uint32_t to) {
  uint32_t low = mesh.row_offsets[from], high = mesh.row_offsets[from + 1];
  while (low + 1 < high) {
    const uint32_t middle = low + (high - low) / 2;
    if (mesh.col_indices[middle] <= to) {
      low = middle;
    } else {
      high = middle;
    }
  }
  return low;
}

}  // namespace sinew
#endif
