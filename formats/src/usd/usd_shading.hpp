// SPDX-License-Identifier: MIT
// Materials of a stage (UsdPreviewSurface) as those of its document.
#ifndef SINEW_FORMATS_USD_USD_SHADING_HPP
#define SINEW_FORMATS_USD_USD_SHADING_HPP

#include <map>
#include <string>

#include "usd/usd_stage.hpp"

namespace sinew {

// Adds every Material with its PNG and JPEG pictures, from the package or beside the file; what is missing is told. Numbers by path.
std::map<std::string, int> add_usd_materials(UsdStage* stage);

}  // namespace sinew
#endif
