// SPDX-License-Identifier: MIT
// Faces of any topology as an OpenMesh half-edge mesh: where a face would make it non-manifold, it gets copies of its
// vertices.
#ifndef SINEW_DATA_SETS_DATASET_HALF_EDGE_MESH_HPP
#define SINEW_DATA_SETS_DATASET_HALF_EDGE_MESH_HPP

#include <OpenMesh/Core/Mesh/Traits.hh>
#include <OpenMesh/Core/System/omstream.hh>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "sinew_formats/character.hpp"

namespace sinew {

using HalfEdgeTraits = OpenMesh::DefaultTraitsDouble;

// Fills `mesh` with all `vertices` in order, copies behind them, and all `faces` (corners distinct). Returns the vertex
// each vertex of `mesh` comes from; face_origin gets the face each face of `mesh` comes from. Faces that cannot be
// added are tried again among themselves on fresh copies, layer by layer, so that what is connected there stays
// together.
template <class Mesh>
std::vector<uint32_t> fill_half_edges(const std::vector<Vec3>& vertices,
                                      const std::vector<std::vector<uint32_t>>& faces, Mesh* mesh,
                                      std::vector<size_t>* face_origin) {
  static const bool quiet = (omerr().disable(), true);  // refused faces are expected here, not news for the terminal
  static_cast<void>(quiet);
  using Handle = typename Mesh::VertexHandle;
  std::vector<uint32_t> origin;
  const auto add_vertex = [&](uint32_t from) {
    const Vec3& p = vertices[from];
    origin.push_back(from);
    return mesh->add_vertex({static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z)});
  };
  for (uint32_t v = 0; v < vertices.size(); ++v) add_vertex(v);

  std::vector<size_t> waiting(faces.size());
  for (size_t f = 0; f < faces.size(); ++f) waiting[f] = f;
  bool first_layer = true;
  while (!waiting.empty()) {
    std::unordered_map<uint32_t, Handle> copies;
    std::vector<size_t> refused;
    for (const size_t f : waiting) {
      std::vector<Handle> corners;
      for (const uint32_t v : faces[f]) {
        if (first_layer) {
          corners.push_back(Handle(static_cast<int>(v)));
          continue;
        }
        auto at = copies.find(v);
        if (at == copies.end()) at = copies.emplace(v, add_vertex(v)).first;
        corners.push_back(at->second);
      }
      bool fits = true;
      for (size_t c = 0; c < corners.size() && fits; ++c) {
        const auto edge = mesh->find_halfedge(corners[c], corners[(c + 1) % corners.size()]);
        fits = mesh->is_boundary(corners[c]) && (!edge.is_valid() || mesh->is_boundary(edge));
      }
      if (fits && mesh->add_face(corners).is_valid())
        face_origin->push_back(f);
      else
        refused.push_back(f);
    }
    waiting = std::move(refused);
    first_layer = false;
  }
  return origin;
}

}  // namespace sinew
#endif
