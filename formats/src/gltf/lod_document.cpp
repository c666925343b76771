// SPDX-License-Identifier: MIT
// Meshes of several documents in the first one, by the extension MSFT_lod.
#include "sinew_formats/lod_document.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "gltf/gltf_container.hpp"
#include "gltf/gltf_source.hpp"
#include "sinew_formats/error.hpp"
#include "text/text_lines.hpp"

namespace sinew {
namespace {

constexpr const char* kLodExtension = "MSFT_lod";

class LodDocument {
 public:
  LodDocument(const std::string& path, const std::vector<uint8_t>& whole)
      : path_(path), whole_(load_gltf(path, whole)), own_nodes_(whole_.document["nodes"].size()) {}

  void add(const std::vector<uint8_t>& glb) {
    const GltfSource level = load_gltf(path_, glb);
    if (count(level.document, "nodes") != own_nodes_ ||
        count(level.document, "materials") != count(whole_.document, "materials") ||
        skin_joints(level.document) != skin_joints(whole_.document))
      throw Error(path_ + ": expected levels with the same nodes, materials and skins, found others");
    ++level_;
    accessors_.clear();
    views_.clear();
    for (size_t n = 0; n < own_nodes_; ++n) {
      const Json& node = level.document["nodes"][n];
      if (!node.contains("mesh")) continue;
      Json mesh = level.document["meshes"].at(node["mesh"].get<size_t>());
      for (Json& primitive : mesh["primitives"]) take_accessors(level, &primitive);
      Json copy = Json::object();
      for (const char* key : {"matrix", "translation", "rotation", "scale", "skin", "weights"})
        if (node.contains(key)) copy[key] = node[key];
      copy["name"] = node.value("name", std::string("mesh")) + "_LOD" + std::to_string(level_);
      copy["mesh"] = whole_.document["meshes"].size();
      whole_.document["meshes"].push_back(std::move(mesh));
      whole_.document["nodes"][n]["extensions"][kLodExtension]["ids"].push_back(whole_.document["nodes"].size());
      whole_.document["nodes"].push_back(std::move(copy));
    }
  }

  std::vector<uint8_t> glb() {
    Json coverage = Json::array();
    for (int k = 1; k <= level_; ++k) coverage.push_back(std::ldexp(1.0, -k));
    coverage.push_back(0.0);  // however small it is, it is seen
    for (size_t n = 0; n < own_nodes_; ++n) {
      Json& node = whole_.document["nodes"][n];
      if (!node.contains(Json::json_pointer(std::string("/extensions/") + kLodExtension))) continue;
      if (!node.contains("extras") || node["extras"].is_object()) node["extras"]["MSFT_screencoverage"] = coverage;
    }
    Json& used = whole_.document["extensionsUsed"];
    if (std::find(used.begin(), used.end(), kLodExtension) == used.end()) used.push_back(kLodExtension);
    return pack_glb(path_, &whole_.document, std::move(whole_.bytes));
  }

 private:
  static size_t count(const Json& document, const char* key) {
    return document.contains(key) ? document[key].size() : 0;
  }

  static Json skin_joints(const Json& document) {
    Json joints = Json::array();
    if (document.contains("skins"))
      for (const Json& skin : document["skins"]) joints.push_back(skin["joints"]);
    return joints;
  }

  // Copies of a level's accessors, each once.
  void take_accessors(const GltfSource& level, Json* primitive) {
    const auto take = [&](Json* number) { *number = accessor(level, number->get<size_t>()); };
    for (Json& attribute : (*primitive)["attributes"]) take(&attribute);
    if (primitive->contains("indices")) take(&(*primitive)["indices"]);
    if (primitive->contains("targets"))
      for (Json& target : (*primitive)["targets"])
        for (Json& attribute : target) take(&attribute);
  }

  size_t accessor(const GltfSource& level, size_t number) {
    const auto found = accessors_.find(number);
    if (found != accessors_.end()) return found->second;
    Json copy = level.document["accessors"].at(number);
    if (copy.contains("bufferView")) copy["bufferView"] = view(level, copy["bufferView"].get<size_t>());
    if (copy.contains("sparse"))
      for (const char* part : {"indices", "values"})
        copy["sparse"][part]["bufferView"] = view(level, copy["sparse"][part]["bufferView"].get<size_t>());
    whole_.document["accessors"].push_back(std::move(copy));
    return accessors_[number] = whole_.document["accessors"].size() - 1;
  }

  size_t view(const GltfSource& level, size_t number) {
    const auto found = views_.find(number);
    if (found != views_.end()) return found->second;
    Json copy = level.document["bufferViews"].at(number);
    const size_t begin = copy.value("byteOffset", size_t{0}), size = copy["byteLength"].get<size_t>();
    if (begin > level.bytes.size() || size > level.bytes.size() - begin)
      throw Error(path_ + ": expected a level whose buffer views lie in its buffer, found another");
    whole_.bytes.resize((whole_.bytes.size() + 3) / 4 * 4);
    copy["byteOffset"] = whole_.bytes.size();
    const auto first = level.bytes.begin() + static_cast<std::ptrdiff_t>(begin);
    whole_.bytes.insert(whole_.bytes.end(), first, first + static_cast<std::ptrdiff_t>(size));
    whole_.document["bufferViews"].push_back(std::move(copy));
    return views_[number] = whole_.document["bufferViews"].size() - 1;
  }

  const std::string& path_;
  GltfSource whole_;
  const size_t own_nodes_;
  int level_ = 0;
  std::map<size_t, size_t> accessors_, views_;  // of the level in hand
};

}  // namespace

std::vector<uint8_t> glb_of_levels(const std::string& path, const std::vector<std::vector<uint8_t>>& levels) {
  try {
    LodDocument document(path, levels.at(0));
    for (size_t k = 1; k < levels.size(); ++k) document.add(levels[k]);
    return document.glb();
  } catch (const nlohmann::json::exception& error) {
    throw Error(path + ": cannot write, the input document has an unexpected form: " + one_line(error.what()));
  }
}

}  // namespace sinew
