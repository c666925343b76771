// SPDX-License-Identifier: MIT
// Contents of an extension VRM of 0.x beside its bones, in terms of 1.0: meta, expressions, first person, look-at,
// springs (github.com/vrm-c/vrm-specification, specification/0.0 and VRMC_vrm-1.0).
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "gltf/gltf_source.hpp"
#include "gltf/vrm.hpp"

namespace sinew {
namespace {

std::string text_in(const Json& object, const char* key) {
  return object.contains(key) && object[key].is_string() ? object[key].get<std::string>() : std::string();
}

// Permissions of other users. Values of 0.x that are less precise than those of 1.0 become the strictest possible
// meaning.
void add_permissions(const Json& zero, Json* meta) {
  const std::string who = text_in(zero, "allowedUserName"), license = text_in(zero, "licenseName");
  const auto allows = [&](const char* key) { return text_in(zero, key) == "Allow"; };
  (*meta)["avatarPermission"] = who == "Everyone"                   ? "everyone"
                                : who == "ExplicitlyLicensedPerson" ? "onlySeparatelyLicensedPerson"
                                                                    : "onlyAuthor";
  (*meta)["allowExcessivelyViolentUsage"] = allows("violentUssageName");
  (*meta)["allowExcessivelySexualUsage"] = allows("sexualUssageName");
  const bool sells = allows("commercialUssageName") && license.find("_NC") == std::string::npos;
  (*meta)["commercialUsage"] = sells ? "personalProfit" : "personalNonProfit";
  const bool open = license.rfind("CC", 0) == 0;
  (*meta)["creditNotation"] = license == "CC0" ? "unnecessary" : "required";
  (*meta)["allowRedistribution"] = open;
  (*meta)["modification"] =
      open && license.find("_ND") == std::string::npos ? "allowModificationRedistribution" : "prohibited";
}

Json meta_of_zero(const Json& zero, const Json& document) {
  Json meta = {{"licenseUrl", "https://vrm.dev/licenses/1.0/"}, {"name", text_in(zero, "title")}};
  for (const auto& [older, newer] :
       {std::pair("version", "version"), std::pair("contactInformation", "contactInformation"),
        std::pair("otherLicenseUrl", "otherLicenseUrl")})
    if (const std::string text = text_in(zero, older); !text.empty()) meta[newer] = text;
  if (const std::string author = text_in(zero, "author"); !author.empty()) meta["authors"] = {author};
  if (const std::string from = text_in(zero, "reference"); !from.empty()) meta["references"] = {from};
  add_permissions(zero, &meta);
  const int texture = zero.value("texture", -1);
  if (texture >= 0 && document.contains("textures")) {
    const Json& picture = document["textures"].at(static_cast<size_t>(texture));
    if (picture.contains("source")) meta["thumbnailImage"] = picture["source"];
  }
  return meta;
}

Json nodes_with_mesh(const Json& document, const Json& mesh) {
  Json found = Json::array();
  for (size_t n = 0; n < document["nodes"].size(); ++n)
    if (document["nodes"][n].contains("mesh") && document["nodes"][n]["mesh"] == mesh) found.push_back(n);
  return found;
}

// Converts a color or a texture transform; false for a shader property without an equivalent in 1.0.
bool add_material_bind(const Json& value, const Json& document, Json* expression) {
  const std::string property = text_in(value, "propertyName");
  const std::vector<double> target = value.value("targetValue", std::vector<double>());
  const Json materials = document.value("materials", Json::array());
  size_t material = 0;
  while (material < materials.size() && text_in(materials[material], "name") != text_in(value, "materialName"))
    ++material;
  if (material == materials.size() || target.size() < 4) return false;
  constexpr std::array<std::array<const char*, 2>, 5> kColors = {{{"_Color", "color"},
                                                                  {"_EmissionColor", "emissionColor"},
                                                                  {"_ShadeColor", "shadeColor"},
                                                                  {"_RimColor", "rimColor"},
                                                                  {"_OutlineColor", "outlineColor"}}};
  for (const auto& [older, newer] : kColors)
    if (property == older) {
      (*expression)["materialColorBinds"].push_back({{"material", material}, {"type", newer}, {"targetValue", target}});
      return true;
    }
  if (property != "_MainTex_ST") return false;
  // Textures begin below in 0.x, above in glTF.
  (*expression)["textureTransformBinds"].push_back(
      {{"material", material}, {"scale", {target[0], target[1]}}, {"offset", {target[2], 1 - target[1] - target[3]}}});
  return true;
}

Json expressions_of_zero(const Json& groups, const Json& document, size_t* left_out) {
  Json expressions = Json::object();
  for (const Json& group : groups) {
    Json expression = {{"isBinary", group.value("isBinary", false)}};
    for (const Json& bind : group.value("binds", Json::array()))
      for (const Json& node : nodes_with_mesh(document, bind.at("mesh")))
        expression["morphTargetBinds"].push_back(
            {{"node", node}, {"index", bind.at("index")}, {"weight", bind.value("weight", 100.0) / 100}});
    for (const Json& value : group.value("materialValues", Json::array()))
      *left_out += add_material_bind(value, document, &expression) ? 0 : 1;
    const std::string name = text_in(group, "name"), preset = vrm_preset_of_zero(text_in(group, "presetName"));
    if (preset.empty())
      expressions["custom"][name.empty() ? "custom" + std::to_string(expressions["custom"].size()) : name] =
          std::move(expression);
    else
      expressions["preset"][preset] = std::move(expression);
  }
  return expressions;
}

Json first_person_of_zero(const Json& zero, const Json& document) {
  constexpr std::array<std::array<const char*, 2>, 4> kTypes = {{{"Auto", "auto"},
                                                                 {"Both", "both"},
                                                                 {"ThirdPersonOnly", "thirdPersonOnly"},
                                                                 {"FirstPersonOnly", "firstPersonOnly"}}};
  Json annotations = Json::array();
  for (const Json& old : zero.value("meshAnnotations", Json::array())) {
    std::string type = "auto";
    for (const auto& [older, newer] : kTypes)
      if (text_in(old, "firstPersonFlag") == older) type = newer;
    for (const Json& node : nodes_with_mesh(document, old.at("mesh")))
      annotations.push_back({{"node", node}, {"type", type}});
  }
  return annotations.empty() ? Json(nullptr) : Json{{"meshAnnotations", std::move(annotations)}};
}

Json look_at_of_zero(const Json& zero) {
  Json look = {{"type", text_in(zero, "lookAtTypeName") == "BlendShape" ? "expression" : "bone"},
               {"offsetFromHeadBone", vrm_zero_vector(zero.value("firstPersonBoneOffset", Json::object()))}};
  constexpr std::array<std::array<const char*, 2>, 4> kRanges = {{{"lookAtHorizontalInner", "rangeMapHorizontalInner"},
                                                                  {"lookAtHorizontalOuter", "rangeMapHorizontalOuter"},
                                                                  {"lookAtVerticalDown", "rangeMapVerticalDown"},
                                                                  {"lookAtVerticalUp", "rangeMapVerticalUp"}}};
  for (const auto& [older, newer] : kRanges)
    if (zero.contains(older))
      look[newer] = {{"inputMaxValue", zero[older].value("xRange", 90.0)},
                     {"outputScale", zero[older].value("yRange", 10.0)}};
  return look;
}

}  // namespace

std::vector<std::string> turn_vrm_zero_into_one(Json* document) {
  const Json::json_pointer at("/extensions/VRM");
  if (!document->contains(at) || !(*document)[at].is_object()) return {};
  if (document->contains(Json::json_pointer("/extensions/VRMC_vrm"))) return {};
  const Json zero = (*document)[at];
  drop_extension("VRM", document);
  Json one = {{"specVersion", "1.0"}, {"meta", meta_of_zero(zero.value("meta", Json::object()), *document)}};
  for (const Json& bone : zero.value("humanoid", Json::object()).value("humanBones", Json::array()))
    one["humanoid"]["humanBones"][text_in(bone, "bone")] = {{"node", bone.at("node")}};
  size_t left_out = 0;
  const Json master = zero.value("blendShapeMaster", Json::object());
  one["expressions"] = expressions_of_zero(master.value("blendShapeGroups", Json::array()), *document, &left_out);
  const Json view = zero.value("firstPerson", Json::object());
  if (Json annotations = first_person_of_zero(view, *document); !annotations.is_null())
    one["firstPerson"] = std::move(annotations);
  if (view.contains("firstPersonBone")) one["lookAt"] = look_at_of_zero(view);
  Json& extensions = (*document)["extensions"];
  Json& used = (*document)["extensionsUsed"];
  Json springs = vrm_springs_of_zero(zero.value("secondaryAnimation", Json::object()), document);
  const size_t spring_count = springs.is_null() ? 0 : springs["springs"].size();
  if (spring_count != 0) {
    extensions["VRMC_springBone"] = std::move(springs);
    used.push_back("VRMC_springBone");
  }
  std::vector<std::string> notes = {
      "converted VRM 0.x to 1.0: " + std::to_string(master.value("blendShapeGroups", Json::array()).size()) +
      " expressions, " + std::to_string(spring_count) + " spring chains" + (one.contains("lookAt") ? ", look-at" : "") +
      (one.contains("firstPerson") ? ", first person" : "") + ", meta"};
  extensions["VRMC_vrm"] = std::move(one);
  used.push_back("VRMC_vrm");
  size_t toon = 0;
  for (const Json& material : zero.value("materialProperties", Json::array()))
    toon += text_in(material, "shader") == "VRM/MToon" ? 1 : 0;
  if (toon != 0) notes.push_back(std::to_string(toon) + " MToon materials of VRM 0.x become plain glTF materials");
  if (left_out != 0)
    notes.push_back(std::to_string(left_out) +
                    " material changes of VRM 0.x expressions were left out: VRM 1.0 has none");
  return notes;
}

}  // namespace sinew
