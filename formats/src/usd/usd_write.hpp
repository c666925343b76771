// SPDX-License-Identifier: MIT
// A glTF document as USD: its text form with pictures beside it, or one package of both.
#ifndef SINEW_FORMATS_USD_USD_WRITE_HPP
#define SINEW_FORMATS_USD_USD_WRITE_HPP

#include <string>
#include <vector>

#include "gltf/gltf_model.hpp"
#include "sinew_formats/io.hpp"

namespace sinew {

// A .usda with its pictures beside it, the .usda last, or a .usdz: y up, metres, UsdSkel (openusd.org, "UsdSkel: Skeleton Schemas"): one skeleton
// with bind and rest transforms, meshes with influences and blend shapes, an animation a clip of which the first is bound, UsdPreviewSurface.
// A mesh without a skin that hangs on a joint gets weight 1 for it. Left out: animations of nodes that are no joints, alpha of colours.
//   path   ends with .usda or .usdz; pictures are named after it
//   model  a document as it was read
// Throws Error naming `path` for accessors that are broken.
std::vector<NamedBytes> usd_of(const std::string& path, const tinygltf::Model& model);

// A .usdz: a zip of stored files whose bytes begin at multiples of 64 (openusd.org, "Usdz File Format Specification").
// Names are those inside, in this order: the first file is the one that programs open. The same bytes for the same files.
// Throws Error naming `path` above 4 GiB.
std::vector<uint8_t> usd_package(const std::string& path, const std::vector<NamedBytes>& files);

}  // namespace sinew
#endif
