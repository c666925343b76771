// SPDX-License-Identifier: MIT
// A whole document elsewhere: below one node that turns, scales and moves everything, animations too.
#ifndef SINEW_FORMATS_GLTF_PLACE_DOCUMENT_HPP
#define SINEW_FORMATS_GLTF_PLACE_DOCUMENT_HPP

#include <memory>
#include <string>

#include "sinew_formats/affine.hpp"
#include "sinew_formats/character.hpp"

namespace sinew {

// A copy of a document whose roots hang on a new node, the last one.
//   place   a rotation, the same scale along every axis, and a translation; world space
//   joints  [J] the Character's, placed
// Throws Error for a document of several scenes, and one whose nodes are broken.
std::shared_ptr<const GltfSource> placed_document(const std::string& name, const GltfSource& source,
                                                  const Affine& place, const std::vector<Joint>& joints);

}  // namespace sinew
#endif
