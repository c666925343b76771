// SPDX-License-Identifier: MIT
// .usda and .usdz as a glTF document.
#ifndef SINEW_FORMATS_USD_GLTF_FROM_USD_HPP
#define SINEW_FORMATS_USD_GLTF_FROM_USD_HPP

#include <string>

#include "gltf/gltf_source.hpp"

namespace sinew {

bool is_usd_file(const std::string& path);

// One layer as text: meshes, UsdSkel (skeletons, influences, blend shapes, animations), UsdPreviewSurface with PNG and JPEG pictures; in metres,
// y up. Nothing is composed: references, payloads, sublayers and variants are left out, which a note tells, as are transforms that move.
// Throws Error for the binary form, for a broken text or package, and for arrays that do not fit.
GltfSource gltf_from_usd(const std::string& path);

}  // namespace sinew
#endif
