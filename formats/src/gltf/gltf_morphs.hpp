// SPDX-License-Identifier: MIT
// Corrective shapes in a glTF document.
#ifndef SINEW_FORMATS_GLTF_GLTF_MORPHS_HPP
#define SINEW_FORMATS_GLTF_GLTF_MORPHS_HPP

#include <string>

#include "sinew_formats/character.hpp"
#include "sinew_formats/morphs.hpp"

namespace sinew {

struct GltfJoints;

// Adds shapes as morph targets of the meshes that they move, behind those that are there; drivers as `extras` of these meshes;
// clips as weights in the document's animations, of which the last ones are `new_animations`.
void add_gltf_morphs(const std::string& path, const Character& character, const Morphs& morphs,
                     const GltfJoints& joints, size_t new_animations, GltfSource* source);

}  // namespace sinew
#endif
