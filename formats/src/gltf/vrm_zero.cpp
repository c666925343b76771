// SPDX-License-Identifier: MIT
// The extension VRM of 0.x (github.com/vrm-c/vrm-specification, specification/0.0), with words of 1.0 translated.
#include <array>
#include <utility>

#include "gltf/gltf_source.hpp"
#include "gltf/vrm.hpp"

namespace sinew {
namespace {

using Words = std::vector<std::pair<const char*, const char*>>;  // of 1.0, of 0.x

std::string word_of(const std::map<std::string, std::string>& said, const char* key, const Words& words,
                    const char* strictest) {
  const auto at = said.find(key);
  if (at != said.end())
    for (const auto& [newer, older] : words)
      if (at->second == newer) return older;
  return strictest;
}

std::string joined_authors(const VrmData& vrm) {
  std::string authors;
  for (const std::string& author : vrm.authors) authors += (authors.empty() ? "" : ", ") + author;
  return authors;
}

// Missing permissions are the strictest of the specification.
Json zero_meta(const VrmData& vrm) {
  const Words allow = {{"true", "Allow"}};
  const auto text = [&](const char* key) {
    const auto at = vrm.license.find(key);
    return at == vrm.license.end() ? std::string() : at->second;
  };
  const std::string url = text("otherLicenseUrl"), name = text("licenseName");
  return {
      {"title", vrm.title.empty() ? vrm.file_name : vrm.title},
      {"version", ""},
      {"author", joined_authors(vrm)},
      {"contactInformation", ""},
      {"reference", text("copyrightInformation")},
      {"allowedUserName",
       word_of(vrm.license, "avatarPermission",
               {{"onlySeparatelyLicensedPerson", "ExplicitlyLicensedPerson"}, {"everyone", "Everyone"}}, "OnlyAuthor")},
      {"violentUssageName", word_of(vrm.license, "allowExcessivelyViolentUsage", allow, "Disallow")},
      {"sexualUssageName", word_of(vrm.license, "allowExcessivelySexualUsage", allow, "Disallow")},
      {"commercialUssageName",
       word_of(vrm.license, "commercialUsage", {{"personalProfit", "Allow"}, {"corporation", "Allow"}}, "Disallow")},
      {"otherPermissionUrl", ""},
      {"licenseName", !name.empty() ? name
                      : url.empty() ? "Redistribution_Prohibited"
                                    : "Other"},
      {"otherLicenseUrl", url}};
}

// A thumb's parts are named from the proximal one in 0.x.
std::string older_bone(const std::string& bone) {
  const size_t thumb = bone.find("Thumb");
  if (thumb == std::string::npos) return bone;
  const std::string part = bone.substr(thumb + 5);
  return bone.substr(0, thumb + 5) + (part == "Metacarpal" ? "Proximal" : part == "Proximal" ? "Intermediate" : part);
}

Json zero_humanoid(const std::string& path, const VrmData& vrm, const std::vector<int>& joint_nodes) {
  Json bones = Json::array();
  for (const auto& [bone, node] : humanoid_nodes(path, vrm, joint_nodes))
    bones.push_back({{"bone", older_bone(bone)}, {"node", node}, {"useDefaultValues", true}});
  // Unity's defaults for a human.
  return {{"humanBones", std::move(bones)}, {"armStretch", 0.05},   {"legStretch", 0.05},
          {"upperArmTwist", 0.5},           {"lowerArmTwist", 0.5}, {"upperLegTwist", 0.5},
          {"lowerLegTwist", 0.5},           {"feetSpacing", 0.0},   {"hasTranslationDoF", false}};
}

Json first_person(const VrmData& vrm, const std::vector<int>& joint_nodes) {
  int head = -1;
  for (size_t j = 0; j < vrm.bones.size(); ++j)
    if (vrm.bones[j] == "head") head = joint_nodes[j];
  const Json range = {{"curve", {0, 0, 0, 1, 1, 1, 1, 0}}, {"xRange", 90}, {"yRange", 10}};
  return {{"firstPersonBone", head},          {"firstPersonBoneOffset", {{"x", 0}, {"y", 0}, {"z", 0}}},
          {"meshAnnotations", Json::array()}, {"lookAtTypeName", "Bone"},
          {"lookAtHorizontalInner", range},   {"lookAtHorizontalOuter", range},
          {"lookAtVerticalDown", range},      {"lookAtVerticalUp", range}};
}

// Expressions that both versions know: the words of 1.0 and of 0.x.
constexpr std::array<std::array<const char*, 2>, 17> kPresets = {{{"neutral", "neutral"},
                                                                  {"happy", "joy"},
                                                                  {"angry", "angry"},
                                                                  {"sad", "sorrow"},
                                                                  {"relaxed", "fun"},
                                                                  {"aa", "a"},
                                                                  {"ih", "i"},
                                                                  {"ou", "u"},
                                                                  {"ee", "e"},
                                                                  {"oh", "o"},
                                                                  {"blink", "blink"},
                                                                  {"blinkLeft", "blink_l"},
                                                                  {"blinkRight", "blink_r"},
                                                                  {"lookUp", "lookup"},
                                                                  {"lookDown", "lookdown"},
                                                                  {"lookLeft", "lookleft"},
                                                                  {"lookRight", "lookright"}}};

// Expressions of VRMC_vrm as blend shape groups.
Json blend_shapes(const Json& document) {
  Json groups = Json::array();
  const Json::json_pointer at("/extensions/VRMC_vrm/expressions");
  if (!document.contains(at)) return {{"blendShapeGroups", groups}};
  for (const char* kind : {"preset", "custom"}) {
    if (!document[at].contains(kind)) continue;
    for (const auto& [name, expression] : document[at][kind].items()) {
      std::string preset = "unknown";
      for (const auto& [newer, older] : kPresets)
        if (name == newer && std::string(kind) == "preset") preset = older;
      Json binds = Json::array();
      for (const Json& bind : expression.value("morphTargetBinds", Json::array())) {
        const Json& node = document["nodes"].at(bind.at("node").get<size_t>());
        if (node.contains("mesh"))
          binds.push_back(
              {{"mesh", node["mesh"]}, {"index", bind.at("index")}, {"weight", 100 * bind.value("weight", 1.0)}});
      }
      groups.push_back({{"name", name},
                        {"presetName", preset},
                        {"binds", std::move(binds)},
                        {"materialValues", Json::array()},
                        {"isBinary", expression.value("isBinary", false)}});
    }
  }
  return {{"blendShapeGroups", std::move(groups)}};
}

// Each material as glTF has it.
Json material_properties(const Json& document) {
  Json all = Json::array();
  if (document.contains("materials"))
    for (const Json& material : document["materials"])
      all.push_back({{"name", material.value("name", std::string())},
                     {"shader", "VRM_USE_GLTFSHADER"},
                     {"renderQueue", 2000},
                     {"floatProperties", Json::object()},
                     {"vectorProperties", Json::object()},
                     {"textureProperties", Json::object()},
                     {"keywordMap", Json::object()},
                     {"tagMap", Json::object()}});
  return all;
}

}  // namespace

std::string vrm_preset_of_zero(const std::string& zero) {
  for (const auto& [newer, older] : kPresets)
    if (zero == older) return newer;
  return "";
}

Json vrm_zero(const std::string& path, const VrmData& vrm, const std::vector<int>& joint_nodes, const Json& document) {
  Json own = Json::object();
  const Json::json_pointer at("/extensions/VRM");
  if (document.contains(at) && document[at].is_object()) own = document[at];
  own["exporterVersion"] = "sinew";
  own["specVersion"] = "0.0";
  const Json old_meta = own.value("meta", Json::object());
  if (!vrm.title.empty() || !vrm.license.empty() || old_meta.empty()) own["meta"] = zero_meta(vrm);
  own["meta"]["author"] = vrm.authors.empty() ? old_meta.value("author", std::string()) : joined_authors(vrm);
  if (vrm.title.empty() && old_meta.contains("title")) own["meta"]["title"] = old_meta["title"];
  own["humanoid"] = zero_humanoid(path, vrm, joint_nodes);
  Json view = first_person(vrm, joint_nodes);
  if (own.contains("firstPerson")) view.update(own["firstPerson"]);
  own["firstPerson"] = std::move(view);
  if (!own.contains("blendShapeMaster")) own["blendShapeMaster"] = blend_shapes(document);
  if (!own.contains("secondaryAnimation"))
    own["secondaryAnimation"] = {{"boneGroups", Json::array()}, {"colliderGroups", Json::array()}};
  if (!own.contains("materialProperties")) own["materialProperties"] = material_properties(document);
  return own;
}

}  // namespace sinew
