// SPDX-License-Identifier: MIT
// The text form of USD (openusd.org, "Usda File Format Specification") as a tree of prims: one layer, nothing composed.
#ifndef SINEW_FORMATS_USD_USD_PARSE_HPP
#define SINEW_FORMATS_USD_USD_PARSE_HPP

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace sinew {

// A value without its nesting: what tuples and lists hold, in order.
struct UsdValue {
  std::vector<double> numbers;
  std::vector<std::string> texts;  // strings, tokens, assets, paths
  size_t width = 1;                // numbers of one element: 3 of point3f, 16 of matrix4d
};

using UsdMetadata = std::map<std::string, UsdValue>;  // of dictionaries "customData:name"

struct UsdProperty {
  std::string type;  // "float3[]", "rel"
  UsdValue value;    // empty where there is none
  bool has_value = false;
  std::map<double, UsdValue> samples;  // by time code
  std::vector<std::string> targets;    // of a relationship or a connection
  UsdMetadata metadata;
};

struct UsdPrim {
  std::string specifier, type, name;  // def, over, class
  std::string path;                   // "/Character/Mesh"
  UsdMetadata metadata;
  std::map<std::string, UsdProperty> properties;
  std::vector<UsdPrim> children;
  bool has_variants = false;  // which are left out
};

// The pseudo-root: its metadata is the layer's. Throws Error naming `path` and the line.
UsdPrim parse_usda(const std::string& path, std::string_view text);

// Null for none.
const UsdProperty* find_property(const UsdPrim& prim, const std::string& name);
// The value at the default time, else of the first sample; null for none.
const UsdValue* find_value(const UsdPrim& prim, const std::string& name);
// The first text of a property's value; `otherwise` for none.
std::string text_of(const UsdPrim& prim, const std::string& name, const std::string& otherwise = "");

}  // namespace sinew
#endif
