// SPDX-License-Identifier: MIT
// Levels of detail in one glTF file.
#ifndef SINEW_FORMATS_LOD_DOCUMENT_HPP
#define SINEW_FORMATS_LOD_DOCUMENT_HPP

#include <cstdint>
#include <string>
#include <vector>

namespace sinew {

// The first GLB, each of whose mesh nodes names those of the others in its extension MSFT_lod. They share its joints, skins, materials and
// pictures; programs that do not know the extension see the first level alone. A level is for half the height on the screen of the one before.
//   levels  of one document with other meshes, the whole one first
// Throws Error, which begins with `path`, for levels whose nodes, materials or skins differ.
std::vector<uint8_t> glb_of_levels(const std::string& path, const std::vector<std::vector<uint8_t>>& levels);

}  // namespace sinew
#endif
