// SPDX-License-Identifier: MIT
#include "usd/gltf_from_usd.hpp"

#include <algorithm>
#include <cmath>

#include "gltf/gltf_container.hpp"
#include "motion/npy.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/file_kinds.hpp"
#include "sinew_formats/file_names.hpp"
#include "sinew_formats/io.hpp"
#include "text/text_lines.hpp"
#include "usd/usd_mesh.hpp"
#include "usd/usd_package.hpp"
#include "usd/usd_rig.hpp"
#include "usd/usd_shading.hpp"
#include "usd/usd_stage.hpp"
#include "usd/usd_transform.hpp"

namespace sinew {
namespace {

constexpr double kUsualMetres = 0.01, kUsualTimeCodes = 24;  // where a layer does not say

double number_of(const UsdMetadata& metadata, const char* name, double otherwise) {
  const auto at = metadata.find(name);
  if (at == metadata.end() || at->second.numbers.empty()) return otherwise;
  const double number = at->second.numbers[0];
  return std::isfinite(number) && number > 1e-6 && number < 1e6 ? number : otherwise;
}

void read_layer(UsdStage* stage) {
  std::vector<uint8_t> bytes = read_file(stage->path);
  if (has_extension(stage->path, ".usdz")) {
    stage->is_package = true;
    stage->layer = first_in_package(bytes);
    stage->inside = unzip(stage->path, bytes);
    const auto at = stage->inside.find(stage->layer);
    if (at == stage->inside.end())
      throw Error(stage->path + ": expected a layer of USD as the package's first file, found none");
    if (has_extension(stage->layer, ".usdc"))
      throw Error(stage->path + ": expected USD's text form, found its binary form (crate) in " +
                  in_quotes(stage->layer) + "; usdcat --flatten --out NAME.usda makes text of it");
    bytes = at->second;
  }
  stage->root = parse_usda(stage->path, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

void find_stage(UsdStage* stage) {
  const UsdMetadata& metadata = stage->root.metadata;
  const double metres = number_of(metadata, "metersPerUnit", kUsualMetres);
  const auto up = metadata.find("upAxis");
  const bool z_up = up != metadata.end() && !up->second.texts.empty() && up->second.texts[0] == "Z";
  stage->to_metres = z_up ? Affine{metres, 0, 0, 0, 0, 0, metres, 0, 0, -metres, 0, 0}
                          : Affine{metres, 0, 0, 0, 0, metres, 0, 0, 0, 0, metres, 0};
  stage->time_codes =
      number_of(metadata, "timeCodesPerSecond", number_of(metadata, "framesPerSecond", kUsualTimeCodes));
}

bool has(const UsdMetadata& metadata, const char* name) { return metadata.count(name) != 0; }

bool is_left_out(const UsdPrim& prim) {
  if (prim.specifier != "def") return true;
  const auto active = prim.metadata.find("active");
  if (active != prim.metadata.end() && active->second.numbers == std::vector<double>{0}) return true;
  const std::string purpose = text_of(prim, "purpose");
  return purpose == "proxy" || purpose == "guide";
}

void find_places(UsdStage* stage) {
  bool composed = has(stage->root.metadata, "subLayers"), variants = false, moving = false;
  struct Open {
    const UsdPrim* prim;
    int parent;
  };
  std::vector<Open> open;
  for (const UsdPrim& prim : stage->root.children) open.push_back({&prim, -1});
  std::reverse(open.begin(), open.end());
  while (!open.empty()) {
    const Open next = open.back();
    open.pop_back();
    const UsdPrim& prim = *next.prim;
    for (const char* arc : {"references", "payload", "inherits", "specializes"})
      composed = composed || has(prim.metadata, arc);
    variants = variants || prim.has_variants;
    if (is_left_out(prim)) continue;
    UsdPlace place = {&prim, next.parent, kIdentity};
    const UsdTransform transform = usd_transform(stage->where(prim), prim);
    moving = moving || transform.animated;
    place.world = next.parent < 0 || transform.resets
                      ? transform.local
                      : multiply(stage->places[static_cast<size_t>(next.parent)].world, transform.local);
    const int number = static_cast<int>(stage->places.size());
    if (!stage->by_path.emplace(prim.path, stage->places.size()).second)
      throw Error(stage->where(prim) + ": expected prims of different names, found two of one");
    stage->places.push_back(place);
    for (size_t c = prim.children.size(); c-- > 0;) open.push_back({&prim.children[c], number});
  }
  std::vector<std::string>& notes = stage->out.notes;
  if (composed)
    notes.emplace_back(
        "warning: references to other layers were left out; usdcat --flatten --out NAME.usda puts all into one");
  if (variants)
    notes.emplace_back("warning: variants were left out; usdcat --flatten --out NAME.usda takes the chosen ones");
  if (moving) notes.emplace_back("animations beside those of skeletons were left out");
}

}  // namespace

std::string UsdStage::where(const UsdPrim& prim) const {
  return path + ": " + prim.type + (prim.type.empty() ? "" : " ") + in_quotes(prim.name);
}

const UsdProperty* UsdStage::inherited(size_t place, const std::string& name) const {
  for (int up = static_cast<int>(place); up >= 0; up = places[static_cast<size_t>(up)].parent)
    if (const UsdProperty* property = find_property(*places[static_cast<size_t>(up)].prim, name)) return property;
  return nullptr;
}

std::string UsdStage::name_of(const UsdPrim& prim) {
  const auto at = prim.metadata.find("customData:name");
  return at == prim.metadata.end() || at->second.texts.empty() ? prim.name : at->second.texts[0];
}

int add_vectors(const std::vector<float>& values, size_t width, bool vertex_attribute, bool with_bounds,
                UsdStage* stage) {
  const char* types[] = {"SCALAR", "VEC2", "VEC3", "VEC4"};
  const int accessor = add_accessor(&stage->out, values.data(), values.size() * sizeof(float), types[width - 1],
                                    TINYGLTF_COMPONENT_TYPE_FLOAT, values.size() / width, vertex_attribute, false);
  if (!with_bounds) return accessor;
  std::vector<float> low(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(width)), high = low;
  for (size_t i = 0; i < values.size(); ++i) {
    low[i % width] = std::min(low[i % width], values[i]);
    high[i % width] = std::max(high[i % width], values[i]);
  }
  stage->document()["accessors"].back()["min"] = low;
  stage->document()["accessors"].back()["max"] = high;
  return accessor;
}

bool is_usd_file(const std::string& path) {
  const FileKind* kind = file_kind(path);
  return kind != nullptr && kind->reader == FileReader::kUsd;
}

GltfSource gltf_from_usd(const std::string& path) {
  UsdStage stage;
  stage.path = path;
  stage.document() = {{"asset", {{"version", "2.0"}, {"generator", "sinew"}}}, {"scene", 0}};
  read_layer(&stage);
  find_stage(&stage);
  find_places(&stage);
  try {
    const std::map<std::string, int> materials = add_usd_materials(&stage);
    const std::vector<UsdRig> rigs = add_usd_rigs(&stage);
    const std::vector<UsdShapes> shapes = add_usd_meshes(rigs, materials, &stage);
    add_usd_animations(rigs, shapes, &stage);
    for (const UsdRig& rig : rigs)
      if (!stage.document().contains("skins")) stage.document()["skins"].push_back({{"joints", rig.nodes}});
    if (stage.roots.empty()) throw Error(path + ": expected a mesh or a skeleton, found none");
    stage.document()["scenes"] = {{{"nodes", stage.roots}}};
    GltfSource source = load_gltf(path, pack_glb(path, &stage.document(), std::move(stage.out.bytes)));
    source.notes = std::move(stage.out.notes);
    source.path.clear();
    return source;
  } catch (const Json::exception& error) {
    throw Error(path + ": expected names as UTF-8 text, found others: " + one_line(error.what()));
  }
}

}  // namespace sinew
