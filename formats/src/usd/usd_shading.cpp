// SPDX-License-Identifier: MIT
#include "usd/usd_shading.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>

#include "sinew_formats/error.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_formats/memory_files.hpp"
#include "text/text_lines.hpp"

namespace sinew {
namespace {

class MaterialReader {
 public:
  explicit MaterialReader(UsdStage* stage) : stage_(*stage) {}

  void add(const UsdPrim& material) {
    Json out = {{"name", UsdStage::name_of(material)}};
    const UsdPrim* surface = source_of(material, "outputs:surface");
    if (surface != nullptr && text_of(*surface, "info:id") == "UsdPreviewSurface") fill(*surface, &out);
    stage_.document()["materials"].push_back(std::move(out));
  }

 private:
  // The prim that an input is connected to; null for none.
  const UsdPrim* source_of(const UsdPrim& prim, const std::string& input) const {
    const UsdProperty* property = find_property(prim, input);
    if (property == nullptr || property->targets.empty()) return nullptr;
    const auto at = stage_.by_path.find(property->targets[0].substr(0, property->targets[0].find('.')));
    return at == stage_.by_path.end() ? nullptr : stage_.places[at->second].prim;
  }

  // The shader of a picture behind an input, if that is what is there.
  const UsdPrim* picture_at(const UsdPrim& surface, const char* input) const {
    const UsdPrim* prim = source_of(surface, input);
    return prim != nullptr && text_of(*prim, "info:id") == "UsdUVTexture" ? prim : nullptr;
  }

  static std::vector<double> numbers(const UsdPrim& prim, const char* name, const std::vector<double>& otherwise) {
    const UsdValue* value = find_value(prim, name);
    if (value == nullptr || value->numbers.size() != otherwise.size()) return otherwise;
    std::vector<double> out = value->numbers;
    for (double& number : out) number = std::isfinite(number) ? std::clamp(number, 0.0, 1.0) : 0.0;
    return out;
  }

  void fill(const UsdPrim& surface, Json* out) {
    Json pbr;
    std::vector<double> base = numbers(surface, "inputs:diffuseColor", {0.18, 0.18, 0.18});
    double opacity = numbers(surface, "inputs:opacity", {1})[0];
    if (const UsdPrim* picture = picture_at(surface, "inputs:diffuseColor")) {
      const std::vector<double> scale = numbers(*picture, "inputs:scale", {1, 1, 1, 1});
      base.assign(scale.begin(), scale.begin() + 3);
      if (source_of(surface, "inputs:opacity") == picture) opacity = scale[3];
      if (const int texture = texture_of(*picture); texture >= 0) pbr["baseColorTexture"] = {{"index", texture}};
    }
    const double cut = numbers(surface, "inputs:opacityThreshold", {0})[0];
    const bool see_through = opacity < 1 || source_of(surface, "inputs:opacity") != nullptr;
    if (cut > 0)
      (*out)["alphaMode"] = "MASK", (*out)["alphaCutoff"] = cut;
    else if (see_through)
      (*out)["alphaMode"] = "BLEND";
    pbr["baseColorFactor"] = {base[0], base[1], base[2], opacity};
    double metallic = numbers(surface, "inputs:metallic", {0})[0],
           rough = numbers(surface, "inputs:roughness", {0.5})[0];
    if (const UsdPrim* picture = picture_at(surface, "inputs:roughness");
        picture != nullptr && picture == picture_at(surface, "inputs:metallic")) {  // one picture, as glTF has it
      const std::vector<double> scale = numbers(*picture, "inputs:scale", {1, 1, 1, 1});
      rough = scale[1], metallic = scale[2];
      if (const int texture = texture_of(*picture); texture >= 0)
        pbr["metallicRoughnessTexture"] = {{"index", texture}};
    }
    pbr["metallicFactor"] = metallic;
    pbr["roughnessFactor"] = rough;
    (*out)["pbrMetallicRoughness"] = std::move(pbr);
    std::vector<double> glow = numbers(surface, "inputs:emissiveColor", {0, 0, 0});
    if (const UsdPrim* picture = picture_at(surface, "inputs:emissiveColor")) {
      const std::vector<double> scale = numbers(*picture, "inputs:scale", {1, 1, 1, 1});
      glow.assign(scale.begin(), scale.begin() + 3);
      if (const int texture = texture_of(*picture); texture >= 0) (*out)["emissiveTexture"] = {{"index", texture}};
    }
    if (glow != std::vector<double>{0, 0, 0}) (*out)["emissiveFactor"] = glow;
    if (const UsdPrim* picture = picture_at(surface, "inputs:normal"))
      if (const int texture = texture_of(*picture); texture >= 0) (*out)["normalTexture"] = {{"index", texture}};
  }

  // The number of a texture; -1 where its picture is none.
  int texture_of(const UsdPrim& shader) {
    const std::string file = text_of(shader, "inputs:file");
    const auto wrap = [&](const char* name) {
      const std::string how = text_of(shader, name, "repeat");
      return how == "clamp"    ? TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE
             : how == "mirror" ? TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT
                               : TINYGLTF_TEXTURE_WRAP_REPEAT;
    };
    const Json sampler = {{"wrapS", wrap("inputs:wrapS")}, {"wrapT", wrap("inputs:wrapT")}};
    const auto [known, is_new] = textures_.try_emplace(file + sampler.dump(), -1);
    if (!is_new) return known->second;
    const int image = image_of(file);
    if (image < 0) return -1;
    stage_.document()["samplers"].push_back(sampler);
    stage_.document()["textures"].push_back({{"sampler", stage_.document()["samplers"].size() - 1}, {"source", image}});
    return known->second = static_cast<int>(stage_.document()["textures"].size()) - 1;
  }

  std::optional<std::vector<uint8_t>> bytes_of(const std::string& file) const {
    namespace fs = std::filesystem;
    const fs::path relative = file;
    if (file.empty() || file.find('\0') != std::string::npos || relative.is_absolute()) return std::nullopt;
    if (stage_.is_package) {
      const std::string name = (fs::path(stage_.layer).parent_path() / relative).lexically_normal().generic_string();
      const auto at = stage_.inside.find(name);
      return at == stage_.inside.end() ? std::nullopt : std::optional(at->second);
    }
    const std::string beside = (fs::path(stage_.path).parent_path() / relative).string();
    if (!is_file(beside)) return std::nullopt;
    return read_file(beside);
  }

  int image_of(const std::string& file) {
    const auto [known, is_new] = images_.try_emplace(file, -1);
    if (!is_new) return known->second;
    const std::optional<std::vector<uint8_t>> bytes = bytes_of(file);
    const char* type = bytes ? image_type(*bytes) : nullptr;
    if (type == nullptr || (std::string(type) != "image/png" && std::string(type) != "image/jpeg")) {
      stage_.out.notes.push_back("warning: the picture " + in_quotes(file) +
                                 (bytes ? " is no PNG or JPEG" : " was not found") + " and was left out");
      return -1;
    }
    Json& document = stage_.document();
    stage_.out.bytes.resize((stage_.out.bytes.size() + 3) / 4 * 4);
    document["bufferViews"].push_back(
        {{"buffer", 0}, {"byteOffset", stage_.out.bytes.size()}, {"byteLength", bytes->size()}});
    stage_.out.bytes.insert(stage_.out.bytes.end(), bytes->begin(), bytes->end());
    if (!document.contains("buffers")) document["buffers"] = Json::array({Json::object()});
    document["images"].push_back({{"bufferView", document["bufferViews"].size() - 1}, {"mimeType", type}});
    return known->second = static_cast<int>(document["images"].size()) - 1;
  }

  UsdStage& stage_;
  std::map<std::string, int> textures_, images_;
};

}  // namespace

std::map<std::string, int> add_usd_materials(UsdStage* stage) {
  std::map<std::string, int> numbers;
  MaterialReader reader(stage);
  for (const UsdPlace& place : stage->places) {
    if (place.prim->type != "Material") continue;
    numbers.emplace(place.prim->path, static_cast<int>(numbers.size()));
    reader.add(*place.prim);
  }
  return numbers;
}

}  // namespace sinew
