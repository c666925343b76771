// SPDX-License-Identifier: MIT
// The nodes of a document that show meshes: their parts together, and a mesh of its own for each that changes.
#ifndef SINEW_FORMATS_GLTF_MESH_NODES_HPP
#define SINEW_FORMATS_GLTF_MESH_NODES_HPP

#include <map>
#include <vector>

#include "gltf/gltf_source.hpp"

namespace sinew {

class MeshNodes {
 public:
  explicit MeshNodes(Json* document) : document_(*document) {
    if (!document_.contains("nodes")) return;
    for (const Json& node : document_["nodes"])
      if (node.contains("mesh")) ++users_[node["mesh"].get<int>()];
  }

  // The number of the mesh that `node` shows, for it alone: a copy where other nodes show the same.
  int own_mesh(int node) {
    Json& json = document_["nodes"][static_cast<size_t>(node)];
    const int mesh = json["mesh"].get<int>();
    if (users_[mesh] < 2) return mesh;
    --users_[mesh];
    Json& meshes = document_["meshes"];
    meshes.push_back(Json(meshes[static_cast<size_t>(mesh)]));
    const int own = static_cast<int>(meshes.size()) - 1;
    json["mesh"] = own;
    return own;
  }

 private:
  Json& document_;
  std::map<int, int> users_;  // mesh -> nodes
};

// Calls visit(first, last) for the parts of each node.
template <class Visit>
void for_each_node(const std::vector<GltfPart>& parts, Visit visit) {
  for (size_t first = 0; first < parts.size();) {
    size_t last = first;
    while (last < parts.size() && parts[last].node == parts[first].node) ++last;
    visit(first, last);
    first = last;
  }
}

}  // namespace sinew
#endif
