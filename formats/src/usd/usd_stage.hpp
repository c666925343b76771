// SPDX-License-Identifier: MIT
// A layer of USD with the places of its prims, and the glTF document that is made of it.
#ifndef SINEW_FORMATS_USD_USD_STAGE_HPP
#define SINEW_FORMATS_USD_USD_STAGE_HPP

#include <map>
#include <string>
#include <vector>

#include "gltf/gltf_source.hpp"
#include "sinew_formats/base/affine.hpp"
#include "usd/usd_parse.hpp"

namespace sinew {

struct UsdPlace {
  const UsdPrim* prim = nullptr;
  int parent = -1;
  Affine world = kIdentity;  // in the stage's own units and axes
};

struct UsdStage {
  std::string path;  // of the file, for messages
  UsdPrim root;
  std::map<std::string, std::vector<uint8_t>> inside;  // files of a package
  bool is_package = false;
  std::string layer;             // its name in the package
  std::vector<UsdPlace> places;  // parents before children; prims that are defined and active
  std::map<std::string, size_t> by_path;
  Affine to_metres = kIdentity;  // y up
  double time_codes = 24;        // a second
  GltfSource out;                // nodes, meshes, ... are added to its document; notes for the user
  std::vector<size_t> roots;     // of the scene

  Json& document() { return out.document; }
  std::string where(const UsdPrim& prim) const;
  // The property of a prim or of the nearest one above it that has it; null for none.
  const UsdProperty* inherited(size_t place, const std::string& name) const;
  // The name that it was made with, else the prim's.
  static std::string name_of(const UsdPrim& prim);
};

// Floats as an accessor of vectors.
int add_vectors(const std::vector<float>& values, size_t width, bool vertex_attribute, bool with_bounds,
                UsdStage* stage);

}  // namespace sinew
#endif
