// SPDX-License-Identifier: MIT
// Vertices of a document doubled, so that faces that shared them no longer do.
#ifndef SINEW_FORMATS_GLTF_CUT_VERTICES_HPP
#define SINEW_FORMATS_GLTF_CUT_VERTICES_HPP

#include <memory>
#include <string>
#include <vector>

#include "gltf/gltf_source.hpp"

namespace sinew {

// A copy of a character's document in which corners name the vertices that they name now. All attributes and morph targets of a doubled
// vertex are those that it had; triangles become a list.
//   face_vertices  [corners] of the Character, as the reader ordered them
//   vertex_count   of the Character, with the doubled ones
std::shared_ptr<const GltfSource> cut_document(const std::string& name, const GltfSource& source,
                                               const std::vector<uint32_t>& face_vertices, size_t vertex_count);

}  // namespace sinew
#endif
