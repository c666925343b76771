// SPDX-License-Identifier: MIT
// Materials of a scene that Assimp read, with their pictures, as those of a glTF document. Only where the build has Assimp.
#ifndef SINEW_FORMATS_GLTF_SCENE_MATERIALS_HPP
#define SINEW_FORMATS_GLTF_SCENE_MATERIALS_HPP

#include <assimp/scene.h>

#include <string>

#include "sinew_formats/character.hpp"

namespace sinew {

// Adds all of them, in their order. Pictures that are missing or of another kind than PNG and JPEG are told in its notes.
void add_scene_materials(const std::string& path, const aiScene& scene, GltfSource* source);

}  // namespace sinew
#endif
