// SPDX-License-Identifier: MIT
// A glTF document as a binary FBX.
#ifndef SINEW_FORMATS_FBX_FBX_WRITE_HPP
#define SINEW_FORMATS_FBX_FBX_WRITE_HPP

#include <cstdint>
#include <string>
#include <vector>

#include "gltf/gltf_model.hpp"

namespace sinew {

// Bytes of an FBX 7.5, y up, in centimetres (UnitScaleFactor 1): models, limbs, meshes with skins, shapes, materials and pictures, a bind pose,
// animations. Assimp's own writer is not used: its skins do not come back whole (github.com/assimp/assimp, issues about FBX export of bones).
//   model  a document as it was read; what glTF has beside these (cameras, lights, extensions) is left out
// Throws Error naming `path` for accessors that are broken.
std::vector<uint8_t> fbx_of(const std::string& path, const tinygltf::Model& model);

}  // namespace sinew
#endif
