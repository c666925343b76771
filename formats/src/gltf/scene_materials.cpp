// SPDX-License-Identifier: MIT
// Colours, opacity and pictures; what no glTF material has is left out.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <memory>
#include <vector>

#include "files/picture_files.hpp"
#include "gltf/gltf_source.hpp"
#include "gltf/scene_nodes.hpp"
#include "text/text_lines.hpp"

namespace sinew {
namespace {

class MaterialWriter {
 public:
  MaterialWriter(const std::string& path, const aiScene& scene, GltfSource* source)
      : scene_(scene), source_(*source), pictures_(path, &source->notes) {}

  void add_material(const aiMaterial& from) {
    aiString name;
    (void)from.Get(AI_MATKEY_NAME, name);
    std::array<float, 4> base = {1, 1, 1, 1};
    aiColor3D colour;
    if (from.Get(AI_MATKEY_COLOR_DIFFUSE, colour) == AI_SUCCESS) base = {colour.r, colour.g, colour.b, 1};
    float opacity = 1;
    // 0 is what exporters write who mean the opposite: nobody exports an invisible body.
    if (from.Get(AI_MATKEY_OPACITY, opacity) == AI_SUCCESS && opacity > 0 && opacity < 1) base[3] = opacity;
    Json material = {{"name", name.C_Str()}};
    const int texture = texture_of(from, {aiTextureType_BASE_COLOR, aiTextureType_DIFFUSE}, false);
    Json& surface = material["pbrMetallicRoughness"];
    surface = {{"metallicFactor", 0}, {"roughnessFactor", 0.9}};
    if (texture >= 0) {
      base[0] = base[1] = base[2] = 1;
      surface["baseColorTexture"] = {{"index", texture}};
    }
    for (float& channel : base) channel = std::isfinite(channel) ? std::clamp(channel, 0.0f, 1.0f) : 1.0f;
    surface["baseColorFactor"] = base;
    if (base[3] < 1) material["alphaMode"] = "BLEND";
    const int normal =
        texture_of(from, {aiTextureType_NORMALS, aiTextureType_NORMAL_CAMERA, aiTextureType_HEIGHT}, true);
    if (normal >= 0) material["normalTexture"] = {{"index", normal}};
    source_.document["materials"].push_back(std::move(material));
  }

 private:
  int texture_of(const aiMaterial& material, std::initializer_list<aiTextureType> kinds, bool normals) {
    for (const aiTextureType kind : kinds) {
      aiString name;
      if (material.GetTexture(kind, 0, &name) != AI_SUCCESS || name.length == 0 || name == aiString(".")) continue;
      const auto [at, is_new] = textures_.try_emplace(name.C_Str(), -1);
      if (!is_new) return at->second;
      Picture picture;
      if (const aiTexture* inside = scene_.GetEmbeddedTexture(name.C_Str()); inside != nullptr) {
        const uint8_t* bytes = reinterpret_cast<const uint8_t*>(inside->pcData);
        if (inside->mHeight == 0 && png_or_jpeg(bytes, inside->mWidth) != nullptr)
          picture = std::make_shared<std::vector<uint8_t> >(bytes, bytes + inside->mWidth);
        else
          source_.notes.push_back("embedded picture " + in_quotes(name.C_Str()) +
                                  " is no PNG or JPEG and was left out");
      } else {
        picture = pictures_.find(name.C_Str());
      }
      if (!picture || (normals && is_grey(*picture))) return -1;
      source_.bytes.resize((source_.bytes.size() + 3) / 4 * 4);
      source_.document["bufferViews"].push_back(
          {{"buffer", 0}, {"byteOffset", source_.bytes.size()}, {"byteLength", picture->size()}});
      source_.bytes.insert(source_.bytes.end(), picture->begin(), picture->end());
      if (!source_.document.contains("buffers")) source_.document["buffers"] = Json::array({Json::object()});
      source_.document["images"].push_back({{"bufferView", source_.document["bufferViews"].size() - 1},
                                            {"mimeType", png_or_jpeg(picture->data(), picture->size())}});
      source_.document["textures"].push_back({{"source", source_.document["images"].size() - 1}});
      return at->second = static_cast<int>(source_.document["textures"].size()) - 1;
    }
    return -1;
  }

  const aiScene& scene_;
  GltfSource& source_;
  PictureFiles pictures_;
  std::map<std::string, int> textures_;
};

}  // namespace

void add_scene_materials(const std::string& path, const aiScene& scene, GltfSource* source) {
  MaterialWriter writer(path, scene, source);
  for (unsigned m = 0; m < scene.mNumMaterials; ++m) writer.add_material(*scene.mMaterials[m]);
}

}  // namespace sinew
