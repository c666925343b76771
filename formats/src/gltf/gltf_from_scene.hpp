// SPDX-License-Identifier: MIT
// FBX and COLLADA as a glTF document, through Assimp where the build has it, and IQM.
#ifndef SINEW_FORMATS_GLTF_GLTF_FROM_SCENE_HPP
#define SINEW_FORMATS_GLTF_GLTF_FROM_SCENE_HPP

#include <cstdint>
#include <string>
#include <vector>

#include "sinew_formats/character.hpp"

namespace sinew {

bool is_scene_file(const std::string& path);  // .fbx, .dae, .iqm

// Mesh nodes, joints with their bind matrices, weights, UVs, normals, colors, blend shapes, materials with PNG and JPEG
// pictures, animations of nodes; in meters, Y up. What is not transferred is in the notes. Joints are the nodes that move vertices, what
// lies between them, and the leaves below them. Throws Error for what Assimp cannot read, and where it is not built in.
GltfSource gltf_from_scene(const std::string& path);

// The bytes that gltf_from_scene() loads, a GLB. In a build with SINEW_SCENES_ELSEWHERE the host defines it: WebAssembly has
// Assimp in a module of its own.
std::vector<uint8_t> scene_to_glb(const std::string& path, std::vector<std::string>* notes);
// The same of an IQM, without Assimp.
std::vector<uint8_t> iqm_to_glb(const std::string& path, std::vector<std::string>* notes);

}  // namespace sinew
#endif
