// SPDX-License-Identifier: MIT
// Copies of a document that differ in one thing: where vertices, joints or the whole stand, or which vertices corners name.
#ifndef SINEW_FORMATS_GLTF_CHANGED_DOCUMENT_HPP
#define SINEW_FORMATS_GLTF_CHANGED_DOCUMENT_HPP

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "gltf/gltf_model.hpp"
#include "gltf/gltf_source.hpp"
#include "sinew_formats/base/affine.hpp"
#include "sinew_formats/character.hpp"

namespace sinew {

// Where a primitive is in the document.
struct PrimitiveAt {
  size_t mesh, primitive;
};

// Writes moved attributes of one primitive as new accessors.
//   primitive  as it was read
//   matrices   [its vertices] in the space of its mesh
//   orphans    gets the accessors that were replaced
// Throws Error naming `where` for accessors that are broken.
void move_vertices(const std::string& where, const tinygltf::Primitive& primitive, const std::vector<Affine>& matrices,
                   PrimitiveAt at, GltfSource* source, std::vector<int>* orphans);

// A copy of a character's document whose vertices are moved; joints, if it has any, stay behind.
//   matrices   [V] of the Character's vertices, world space
//   with_joints  meshes without a skin below a joint stay as they are, because moved_joints() moves them
// Throws Error where the file's own skins know no common rest pose.
std::shared_ptr<const GltfSource> moved_document(const std::string& name, const GltfSource& source,
                                                 const std::vector<Affine>& matrices, bool with_joints);

// A copy of a document whose joints stand elsewhere: their nodes, and the inverse bind matrices of its skins. What hangs on them goes with
// them, skins hold their meshes as before, animations go on from the same keys.
//   palette  [J] rest to posed, world space
//   joints   [J] the Character's, moved
// Throws Error for a document whose nodes or skins are broken.
std::shared_ptr<const GltfSource> moved_joints(const std::string& name, const GltfSource& source,
                                               const std::vector<Affine>& palette, const std::vector<Joint>& joints);

// A copy of a document whose roots are children of a new node, the last one.
//   transform  a rotation, the same scale along every axis, and a translation; world space
//   joints     [J] the Character's, transformed
// Throws Error for a document of several scenes, and one whose nodes are broken.
std::shared_ptr<const GltfSource> transformed_document(const std::string& name, const GltfSource& source,
                                                       const Affine& transform, const std::vector<Joint>& joints);

// A copy of a character's document with doubled vertices and the new vertices of corners. All attributes and morph
// targets of a doubled vertex are those that it had; triangles become a list.
//   face_vertices  [corners] of the Character, as the reader ordered them
//   vertices       [V] of the Character, with the doubled ones: those have floats for positions moved to where they are now
std::shared_ptr<const GltfSource> cut_document(const std::string& name, const GltfSource& source,
                                               const std::vector<uint32_t>& face_vertices,
                                               const std::vector<Vec3>& vertices);

// The nodes of a document that show meshes: their parts together, and a mesh of its own for each that changes.
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
