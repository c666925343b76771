// SPDX-License-Identifier: MIT
// Vertices of a document doubled, so that faces that shared them no longer do.
#ifndef SINEW_FORMATS_GLTF_CUT_VERTICES_HPP
#define SINEW_FORMATS_GLTF_CUT_VERTICES_HPP

#include <memory>
#include <string>
#include <vector>

#include "sinew_formats/character.hpp"

namespace sinew {

// A copy of a character's document in which corners name the vertices that they name now. All attributes and morph targets of a doubled
// vertex are those that it had; triangles become a list.
//   face_vertices  [corners] of the Character, as the reader ordered them
//   vertices       [V] of the Character, with the doubled ones: those have floats for positions moved to where they are now
std::shared_ptr<const GltfSource> cut_document(const std::string& name, const GltfSource& source,
                                               const std::vector<uint32_t>& face_vertices,
                                               const std::vector<Vec3>& vertices);

}  // namespace sinew
#endif
