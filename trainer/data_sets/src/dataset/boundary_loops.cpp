// SPDX-License-Identifier: MIT
// Loops of boundary edges, by half-edges.
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "dataset/half_edge_mesh.hpp"
#include "sinew_data_sets/dataset.hpp"

namespace sinew {
namespace {

using PolyMesh = OpenMesh::PolyMesh_ArrayKernelT<HalfEdgeTraits>;
using BoundaryEdge = std::pair<uint32_t, uint32_t>;

BoundaryEdge lower_first(uint32_t a, uint32_t b) { return {std::min(a, b), std::max(a, b)}; }

// Holes are loops of boundary half-edges with at least one edge that is a boundary of the faces themselves, not of a
// split.
size_t count_boundary_loops(const Character& character, const std::vector<std::vector<uint32_t>>& faces,
                            const std::map<BoundaryEdge, size_t>& faces_at) {
  PolyMesh mesh;
  std::vector<size_t> face_origin;
  const std::vector<uint32_t> origin = fill_half_edges(character.vertices, faces, &mesh, &face_origin);
  std::vector<char> seen(mesh.n_halfedges(), 0);
  size_t loops = 0;
  for (const auto start : mesh.halfedges()) {
    if (!mesh.is_boundary(start) || seen[static_cast<size_t>(start.idx())] != 0) continue;
    bool real = false;
    OpenMesh::HalfedgeHandle at = start;
    do {
      seen[static_cast<size_t>(at.idx())] = 1;
      const BoundaryEdge edge = lower_first(origin[static_cast<size_t>(mesh.from_vertex_handle(at).idx())],
                                            origin[static_cast<size_t>(mesh.to_vertex_handle(at).idx())]);
      real = real || faces_at.at(edge) == 1;
      at = mesh.next_halfedge_handle(at);
    } while (at != start);
    loops += real ? 1 : 0;
  }
  return loops;
}

}  // namespace

CheckReport check_training_character(const Character& character) {
  return check_character(character, [&](const auto& faces, const auto& faces_at) {
    return count_boundary_loops(character, faces, faces_at);
  });
}

}  // namespace sinew
