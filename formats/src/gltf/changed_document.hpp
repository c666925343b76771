// SPDX-License-Identifier: MIT
// Copies of a document that differ in one thing: where vertices, joints or the whole stand, or which vertices corners name.
#ifndef SINEW_FORMATS_GLTF_CHANGED_DOCUMENT_HPP
#define SINEW_FORMATS_GLTF_CHANGED_DOCUMENT_HPP

#include <memory>
#include <string>
#include <vector>

#include "gltf/tinygltf.hpp"
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
//   with_joints  meshes without a skin that hang on a joint stay as they are, because moved_joints() takes them along
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

// A copy of a document whose roots hang on a new node, the last one.
//   transform  a rotation, the same scale along every axis, and a translation; world space
//   joints     [J] the Character's, transformed
// Throws Error for a document of several scenes, and one whose nodes are broken.
std::shared_ptr<const GltfSource> transformed_document(const std::string& name, const GltfSource& source,
                                                       const Affine& transform, const std::vector<Joint>& joints);

// A copy of a character's document with doubled vertices, in which corners name the vertices that they name now. All attributes and morph
// targets of a doubled vertex are those that it had; triangles become a list.
//   face_vertices  [corners] of the Character, as the reader ordered them
//   vertices       [V] of the Character, with the doubled ones: those have floats for positions moved to where they are now
std::shared_ptr<const GltfSource> cut_document(const std::string& name, const GltfSource& source,
                                               const std::vector<uint32_t>& face_vertices,
                                               const std::vector<Vec3>& vertices);

}  // namespace sinew
#endif
