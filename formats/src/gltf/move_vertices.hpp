// SPDX-License-Identifier: MIT
// Vertices of a document moved by a matrix each: places, normals, tangents, and the morph targets of all three.
#ifndef SINEW_FORMATS_GLTF_MOVE_VERTICES_HPP
#define SINEW_FORMATS_GLTF_MOVE_VERTICES_HPP

#include <memory>
#include <string>
#include <vector>

#include "gltf/tinygltf.hpp"
#include "sinew_formats/affine.hpp"
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
//   with_joints  meshes without a skin that hang on a joint stay as they are, because moved_joints() takes them along
// Throws Error where the file's own skins know no common rest pose.
std::shared_ptr<const GltfSource> moved_document(const std::string& name, const GltfSource& source,
                                                 const std::vector<Affine>& matrices, bool with_joints);

}  // namespace sinew
#endif
