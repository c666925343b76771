// SPDX-License-Identifier: MIT
// Materials of a character as USD's text.
#include "gltf/gltf_source.hpp"
#include "usd/usd_text.hpp"
#include "usd/usd_write.hpp"

namespace sinew {

// A picture of a material: the input that it feeds, and how its colors become values.
struct UsdMaterials::Picture {
  const char* name;
  int texture;
  std::vector<double> scale, bias;  // of four channels; empty: as they are
  const char* space;                // of colors: sRGB, raw
};

UsdMaterials::UsdMaterials(std::string stem, const tinygltf::Model& model) : stem_(std::move(stem)), model_(model) {
  std::set<std::string> taken;
  for (const tinygltf::Material& material : model.materials)
    names_.push_back(usd_free_name(material.name.empty() ? "material" : material.name, &taken));
}

std::string UsdMaterials::path_of(int material) const {
  if (material < 0 || static_cast<size_t>(material) >= names_.size()) return "";
  return "</Character/Materials/" + names_[static_cast<size_t>(material)] + ">";
}

bool UsdMaterials::two_sided(int material) const {
  return material >= 0 && static_cast<size_t>(material) < names_.size() &&
         model_.materials[static_cast<size_t>(material)].doubleSided;
}

std::string UsdMaterials::text() {
  if (names_.empty()) return "";
  std::string out = "    def Scope \"Materials\"\n    {\n";
  for (size_t m = 0; m < names_.size(); ++m) out += material(m);
  return out + "    }\n";
}

std::string UsdMaterials::material(size_t m) {
  const tinygltf::Material& from = model_.materials[m];
  const tinygltf::PbrMetallicRoughness& pbr = from.pbrMetallicRoughness;
  const std::string at = "</Character/Materials/" + names_[m];
  const std::string in = "                ";
  const std::vector<double> white = {1, 1, 1, 1}, black = {0, 0, 0},
                            base = pbr.baseColorFactor.size() == 4 ? pbr.baseColorFactor : white,
                            glow = from.emissiveFactor.size() == 3 ? from.emissiveFactor : black;
  const bool see_through = from.alphaMode == "BLEND" || from.alphaMode == "MASK";
  std::string shaders, surface;
  const auto fed = [&](const Picture& picture, const std::vector<std::pair<const char*, const char*>>& inputs) {
    if (picture.texture < 0) return false;
    const std::string text = shader(at, picture);
    if (text.empty()) return false;
    shaders += text;
    for (const auto& [input, output] : inputs)
      surface += in + input + ".connect = " + at + "/" + picture.name + ".outputs:" + output + ">\n";
    return true;
  };
  const Picture color = {"Color", pbr.baseColorTexture.index, base == white ? std::vector<double>() : base, {}, "sRGB"};
  std::vector<std::pair<const char*, const char*>> from_color = {{"color3f inputs:diffuseColor", "rgb"}};
  if (see_through) from_color.emplace_back("float inputs:opacity", "a");
  if (!fed(color, from_color)) {
    surface += in + "color3f inputs:diffuseColor = " + usd_tuple(base, 0, 3) + "\n";
    surface += in + "float inputs:opacity = " + usd_number(see_through ? base[3] : 1.0) + "\n";
  }
  if (from.alphaMode == "MASK")
    surface += in + "float inputs:opacityThreshold = " + usd_number(from.alphaCutoff) + "\n";
  const Picture glowing = {"Glow", from.emissiveTexture.index, {glow[0], glow[1], glow[2], 1}, {}, "sRGB"};
  if (glow != black && !fed(glowing, {{"color3f inputs:emissiveColor", "rgb"}}))
    surface += in + "color3f inputs:emissiveColor = " + usd_tuple(glow) + "\n";
  const Picture rough = {
      "Roughness", pbr.metallicRoughnessTexture.index, {1, pbr.roughnessFactor, pbr.metallicFactor, 1}, {}, "raw"};
  if (!fed(rough, {{"float inputs:roughness", "g"}, {"float inputs:metallic", "b"}}))
    surface += in + "float inputs:metallic = " + usd_number(pbr.metallicFactor) + "\n" + in +
               "float inputs:roughness = " + usd_number(pbr.roughnessFactor) + "\n";
  (void)fed({"Normal", from.normalTexture.index, {2, 2, 2, 1}, {-1, -1, -1, 0}, "raw"},
            {{"normal3f inputs:normal", "rgb"}});
  const std::string name = usd_name_line("            ", names_[m], from.name);
  std::string out = "        def Material \"" + names_[m] + "\"" + (name.empty() ? "" : " (\n" + name + "        )") +
                    "\n        {\n            token outputs:surface.connect = " + at +
                    "/Surface.outputs:surface>\n\n            def Shader \"Surface\"\n            {\n" + in +
                    "uniform token info:id = \"UsdPreviewSurface\"\n" + surface + in +
                    "token outputs:surface\n            }\n";
  if (!shaders.empty())
    out += "\n            def Shader \"Coordinates\"\n            {\n" + in +
           "uniform token info:id = \"UsdPrimvarReader_float2\"\n" + in + "string inputs:varname = \"st\"\n" + in +
           "float2 outputs:result\n            }\n" + shaders;
  return out + "        }\n";
}

std::string UsdMaterials::shader(const std::string& at, const Picture& picture) {
  const std::string file = picture_of(picture.texture), in = "                ";
  if (file.empty()) return "";
  const int sampler = model_.textures[static_cast<size_t>(picture.texture)].sampler;
  const auto wrap = [&](bool s) {
    if (sampler < 0 || static_cast<size_t>(sampler) >= model_.samplers.size()) return "repeat";
    const tinygltf::Sampler& from = model_.samplers[static_cast<size_t>(sampler)];
    const int how = s ? from.wrapS : from.wrapT;
    return how == TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE     ? "clamp"
           : how == TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT ? "mirror"
                                                          : "repeat";
  };
  std::string out = "\n            def Shader \"" + std::string(picture.name) + "\"\n            {\n" + in +
                    "uniform token info:id = \"UsdUVTexture\"\n" + in + "asset inputs:file = @./" + file + "@\n";
  if (!picture.scale.empty()) out += in + "float4 inputs:scale = " + usd_tuple(picture.scale) + "\n";
  if (!picture.bias.empty()) out += in + "float4 inputs:bias = " + usd_tuple(picture.bias) + "\n";
  return out + in + "float2 inputs:st.connect = " + at + "/Coordinates.outputs:result>\n" + in +
         "token inputs:sourceColorSpace = \"" + picture.space + "\"\n" + in + "token inputs:wrapS = \"" + wrap(true) +
         "\"\n" + in + "token inputs:wrapT = \"" + wrap(false) + "\"\n" + in + "float outputs:a\n" + in +
         "float outputs:b\n" + in + "float outputs:g\n" + in + "float outputs:r\n" + in +
         "float3 outputs:rgb\n            }\n";
}

// The name of a texture's picture, which becomes a file; "" for none that can.
std::string UsdMaterials::picture_of(int texture) {
  if (texture < 0 || static_cast<size_t>(texture) >= model_.textures.size()) return "";
  const int source = model_.textures[static_cast<size_t>(texture)].source;
  if (source < 0 || static_cast<size_t>(source) >= model_.images.size()) return "";
  const std::vector<unsigned char>& bytes = model_.images[static_cast<size_t>(source)].image;
  const char* type = image_type(bytes);
  if (type == nullptr) return "";
  const std::string kind = type + std::string("image/").size();
  const std::string name = stem_ + "_" + std::to_string(source) + "." + (kind == "jpeg" ? "jpg" : kind);
  if (pictures_.insert(source).second) files_.push_back({name, {bytes.begin(), bytes.end()}});
  return name;
}

}  // namespace sinew
