// SPDX-License-Identifier: MIT
// Animations of a scene that Assimp read, as animations of a glTF document. Only where the build has Assimp.
#ifndef SINEW_FORMATS_GLTF_SCENE_ANIMATIONS_HPP
#define SINEW_FORMATS_GLTF_SCENE_ANIMATIONS_HPP

#include <assimp/scene.h>

#include <map>
#include <string>

#include "sinew_formats/character.hpp"

namespace sinew {

// Adds every animation that moves a node of the document; the others are told in its notes. Nodes are found by name and number, 0 is the
// scene's root, which stays. Keys are those of the file, from the first one on; a track that stands still has one key.
// Throws Error for numbers that are not finite.
void add_scene_animations(const std::string& path, const aiScene& scene, const std::map<std::string, size_t>& nodes,
                          GltfSource* source);

}  // namespace sinew
#endif
