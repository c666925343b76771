// SPDX-License-Identifier: MIT
// Materials as Phong, which is what every reader of FBX knows; pictures lie in the file, as Video content.
#include <algorithm>
#include <cmath>

#include "fbx/fbx_write.hpp"

namespace sinew {
namespace {

class Materials {
 public:
  Materials(const tinygltf::Model& model, FbxScene* scene)
      : model_(model), scene_(*scene), videos_(model.images.size(), 0) {}

  std::vector<int64_t> add() {
    std::vector<int64_t> ids;
    for (const tinygltf::Material& material : model_.materials) ids.push_back(add_material(material));
    bool bare = false;
    for (const tinygltf::Mesh& mesh : model_.meshes)
      for (const tinygltf::Primitive& primitive : mesh.primitives) bare = bare || primitive.material < 0;
    if (bare || ids.empty()) ids.push_back(add_material(plain()));
    return ids;
  }

 private:
  static tinygltf::Material plain() {
    tinygltf::Material material;
    material.name = "default";
    return material;
  }

  static std::array<double, 3> color(const std::vector<double>& from, double otherwise) {
    std::array<double, 3> out = {otherwise, otherwise, otherwise};
    for (size_t i = 0; i < 3 && i < from.size(); ++i) out[i] = from[i];
    return out;
  }

  int64_t add_material(const tinygltf::Material& from) {
    int64_t id = 0;
    FbxNode material = scene_.object("Material", from.name.empty() ? "material" : from.name, "Material", "", &id);
    material.add("Version").integer(102);
    material.add("ShadingModel").text("phong");
    material.add("MultiLayer").integer(0);
    const std::vector<double>& base = from.pbrMetallicRoughness.baseColorFactor;
    const double opacity = from.alphaMode == "BLEND" && base.size() == 4 ? base[3] : 1;
    const double rough = from.pbrMetallicRoughness.roughnessFactor;
    FbxNode properties("Properties70");
    properties.property_vector("DiffuseColor", "Color", "", "A", color(base, 1));
    properties.property("DiffuseFactor", "Number", "", "A").number(1);
    properties.property_vector("EmissiveColor", "Color", "", "A", color(from.emissiveFactor, 0));
    properties.property_vector("AmbientColor", "Color", "", "A", {0, 0, 0});
    properties.property_vector("SpecularColor", "Color", "", "A", {0.2, 0.2, 0.2});
    // Blender reads roughness back as 1 - sqrt(shininess) / 10.
    properties.property("ShininessExponent", "Number", "", "A").number(100 * (1 - rough) * (1 - rough));
    properties.property("ReflectionFactor", "Number", "", "A").number(from.pbrMetallicRoughness.metallicFactor);
    properties.property("TransparencyFactor", "Number", "", "A").number(1 - opacity);
    properties.property("Opacity", "double", "Number", "").number(opacity);
    material.add(std::move(properties));
    scene_.add("Material", std::move(material));
    add_texture(from.pbrMetallicRoughness.baseColorTexture.index, id, "DiffuseColor");
    add_texture(from.normalTexture.index, id, "NormalMap");
    add_texture(from.emissiveTexture.index, id, "EmissiveColor");
    return id;
  }

  void add_texture(int index, int64_t material, const char* property) {
    if (index < 0 || static_cast<size_t>(index) >= model_.textures.size()) return;
    const int source = model_.textures[static_cast<size_t>(index)].source;
    if (source < 0 || static_cast<size_t>(source) >= model_.images.size()) return;
    const std::string name = picture_name(static_cast<size_t>(source));
    const int64_t video = add_video(static_cast<size_t>(source), name);
    int64_t id = 0;
    FbxNode texture = scene_.object("Texture", name, "Texture", "", &id);
    texture.add("Type").text("TextureVideoClip");
    texture.add("Version").integer(202);
    texture.add("TextureName").text(fbx_name(name, "Texture"));
    texture.add("Media").text(fbx_name(name, "Video"));
    texture.add("FileName").text(name);
    texture.add("RelativeFilename").text(name);
    FbxNode properties("Properties70");
    properties.property_text("UVSet", "", "UVMap");
    properties.property("UseMaterial", "bool", "", "").integer(1);
    texture.add(std::move(properties));
    texture.add("ModelUVTranslation").number(0).number(0);
    texture.add("ModelUVScaling").number(1).number(1);
    texture.add("Texture_Alpha_Source").text("None");
    scene_.add("Texture", std::move(texture));
    scene_.connect(id, material, property);
    scene_.connect(video, id);
  }

  // With an extension, which readers go by.
  std::string picture_name(size_t i) const {
    const tinygltf::Image& image = model_.images[i];
    const char* type = image_type(image.image);
    const std::string extension =
        type == nullptr ? ".png" : std::string(".") + (std::string(type) == "image/jpeg" ? "jpg" : type + 6);
    if (image.image.empty() && !image.uri.empty()) return image.uri;
    std::string name = image.name.empty() ? "picture_" + std::to_string(i) : image.name;
    for (char& c : name)
      if (c == '/' || c == '\\' || c == ':') c = '_';
    return name.size() > extension.size() &&
                   name.compare(name.size() - extension.size(), extension.size(), extension) == 0
               ? name
               : name + extension;
  }

  int64_t add_video(size_t i, const std::string& name) {
    if (videos_[i] != 0) return videos_[i];
    FbxNode video = scene_.object("Video", name, "Video", "Clip", &videos_[i]);
    video.add("Type").text("Clip");
    FbxNode properties("Properties70");
    properties.property_text("Path", "XRefUrl", name);
    video.add(std::move(properties));
    video.add("UseMipMap").integer(0);
    video.add("Filename").text(name);
    video.add("RelativeFilename").text(name);
    const std::vector<unsigned char>& bytes = model_.images[i].image;
    if (!bytes.empty()) video.add("Content").bytes(bytes.data(), bytes.size());
    scene_.add("Video", std::move(video));
    return videos_[i];
  }

  const tinygltf::Model& model_;
  FbxScene& scene_;
  std::vector<int64_t> videos_;  // [images] 0: not yet there
};

}  // namespace

std::vector<int64_t> add_fbx_materials(const tinygltf::Model& model, FbxScene* scene) {
  return Materials(model, scene).add();
}

}  // namespace sinew
