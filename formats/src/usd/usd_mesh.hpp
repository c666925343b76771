// SPDX-License-Identifier: MIT
// Meshes of a stage as mesh nodes of its document.
#ifndef SINEW_FORMATS_USD_USD_MESH_HPP
#define SINEW_FORMATS_USD_USD_MESH_HPP

#include <map>
#include <string>
#include <vector>

#include "usd/usd_rig.hpp"
#include "usd/usd_stage.hpp"

namespace sinew {

// Adds every Mesh: polygons as triangles, normals, texture coordinates, colours, influences, blend shapes, materials by face sets.
//   materials  numbers in the document by the path of their prim
// Returns those with blend shapes. Throws Error for indices without a point, and arrays of other lengths than promised.
std::vector<UsdShapes> add_usd_meshes(const std::vector<UsdRig>& rigs, const std::map<std::string, int>& materials,
                                      UsdStage* stage);

}  // namespace sinew
#endif
