// SPDX-License-Identifier: MIT
// Humanoid nodes of a VRM animation read; a VRM's license, bones and extension written.
#include "gltf/vrm.hpp"

#include <algorithm>

#include "gltf/gltf_source.hpp"
#include "sinew_formats/error.hpp"
#include "text/text_lines.hpp"

namespace sinew {
namespace {

constexpr const char* kExtension = "VRMC_vrm_animation";

class HumanoidReader {
 public:
  HumanoidReader(const std::string& path, const GltfSource& source) : path_(path), source_(source) {}

  std::optional<HumanoidNodes> read() {
    const Json* const extension = member(member(&source_.document, "extensions"), kExtension);
    if (extension == nullptr) return std::nullopt;
    const Json* const bones = member(member(extension, "humanoid"), "humanBones");
    if (bones == nullptr || bones->empty()) fail("humanoid.humanBones", "none");
    for (const auto& [name, bone] : bones->items())
      if (!nodes_.bones.emplace(static_cast<size_t>(node_of("humanBones." + name, bone)), name).second)
        fail("a separate node for each bone", "one node for two, " + in_quotes(name));
    const Json* const expressions = member(extension, "expressions");
    for (const char* list : {"preset", "custom"})
      if (const Json* const named = member(expressions, list))
        for (const auto& [name, one] : named->items())
          nodes_.others.insert(node_of("expressions." + std::string(list) + "." + name, one));
    if (const Json* const eyes = member(extension, "lookAt")) nodes_.others.insert(node_of("lookAt", *eyes));
    for (const tinygltf::Animation& animation : source_.model.animations)
      for (const tinygltf::AnimationChannel& channel : animation.channels)
        nodes_.left_out = nodes_.left_out || nodes_.carries_no_joint(channel.target_node);
    return std::move(nodes_);
  }

 private:
  [[noreturn]] void fail(const std::string& expected, const std::string& found) const {
    throw Error(path_ + ": extension " + kExtension + ": expected " + expected + ", found " + found);
  }
  static const Json* member(const Json* object, const char* name) {
    if (object == nullptr || !object->is_object()) return nullptr;
    const auto found = object->find(name);
    return found == object->end() || !found->is_object() ? nullptr : &*found;
  }
  int node_of(const std::string& where, const Json& object) const {
    const size_t count = source_.model.nodes.size();
    const Json* const node = object.is_object() && object.contains("node") ? &object["node"] : nullptr;
    if (node == nullptr || !node->is_number_unsigned() || node->get<uint64_t>() >= count)
      fail("a node below " + std::to_string(count) + " in " + in_quotes(where), node == nullptr ? "none" : "another");
    return node->get<int>();
  }

  const std::string path_;
  const GltfSource& source_;
  HumanoidNodes nodes_;
};

}  // namespace

std::optional<HumanoidNodes> read_humanoid_nodes(const std::string& path, const GltfSource& source) {
  return HumanoidReader(path, source).read();
}

std::vector<std::string> vrm_file_bones(const Character& character) {
  if (!character.gltf || !has_joints(character.joints, character.gltf->joints)) return {};
  const Json& document = character.gltf->document;
  std::map<int, std::string> bone_of;  // by node
  const auto add = [&](const std::string& name, const Json& bone) {
    const auto node = bone.find("node");
    if (node != bone.end() && node->is_number_integer()) bone_of.emplace(node->get<int>(), name);
  };
  const Json::json_pointer one("/extensions/VRMC_vrm/humanoid/humanBones"), zero("/extensions/VRM/humanoid/humanBones");
  if (document.contains(one) && document[one].is_object()) {
    for (const auto& [name, bone] : document[one].items())
      if (bone.is_object()) add(name, bone);
  } else if (document.contains(zero) && document[zero].is_array()) {
    for (const Json& bone : document[zero])
      if (const auto name = bone.find("bone"); bone.is_object() && name != bone.end() && name->is_string())
        add(*name, bone);
  }
  if (bone_of.empty()) return {};
  std::vector<std::string> out(character.joints.size());
  for (size_t j = 0; j < character.gltf->joint_nodes.size(); ++j)
    if (const auto found = bone_of.find(character.gltf->joint_nodes[j]); found != bone_of.end()) out[j] = found->second;
  return out;
}

// Humanoid and meta of VRMC_vrm (github.com/vrm-c/vrm-specification, VRMC_vrm-1.0), and which extension a document gets.

namespace {

// A member of meta and its words; none: a text.
struct LicenseWord {
  const char* key;
  std::vector<std::string> values;
};

const std::vector<LicenseWord>& license_words() {
  static const std::vector<std::string> kYesNo = {"true", "false"};
  static const std::vector<LicenseWord> kWords = {
      {"avatarPermission", {"onlyAuthor", "onlySeparatelyLicensedPerson", "everyone"}},
      {"commercialUsage", {"personalNonProfit", "personalProfit", "corporation"}},
      {"creditNotation", {"required", "unnecessary"}},
      {"modification", {"prohibited", "allowModification", "allowModificationRedistribution"}},
      {"allowRedistribution", kYesNo},
      {"allowExcessivelyViolentUsage", kYesNo},
      {"allowExcessivelySexualUsage", kYesNo},
      {"allowPoliticalOrReligiousUsage", kYesNo},
      {"allowAntisocialOrHateUsage", kYesNo},
      {"licenseName",
       {"Redistribution_Prohibited", "CC0", "CC_BY", "CC_BY_NC", "CC_BY_SA", "CC_BY_NC_SA", "CC_BY_ND", "CC_BY_NC_ND",
        "Other"}},
      {"copyrightInformation", {}},
      {"otherLicenseUrl", {}}};
  return kWords;
}

std::string joined(const std::vector<std::string>& list, const char* between) {
  std::string out;
  for (const std::string& one : list) out += (out.empty() ? "" : between) + one;
  return out;
}

// The file's own meta, but for what `vrm` says otherwise.
Json meta_of(const VrmData& vrm, Json meta) {
  if (!meta.is_object()) meta = Json::object();
  if (!vrm.title.empty() || !meta.contains("name")) meta["name"] = vrm.title.empty() ? vrm.file_name : vrm.title;
  if (!vrm.authors.empty()) meta["authors"] = vrm.authors;
  meta["licenseUrl"] = "https://vrm.dev/licenses/1.0/";
  for (const auto& [key, value] : vrm.license) {
    if (key == "licenseName")
      throw Error("license licenseName: a term of VRM 0.x; VRM 1.0 has no license names, give permissions");
    if (key.rfind("allow", 0) == 0)
      meta[key] = value == "true";
    else
      meta[key] = value;
  }
  return meta;
}

// `vrm` with what the meta of VRMC_vrm says and it does not.
VrmData with_meta(VrmData vrm, const Json& meta) {
  if (vrm.title.empty()) vrm.title = meta.value("name", std::string());
  if (vrm.authors.empty()) vrm.authors = meta.value("authors", std::vector<std::string>());
  for (const LicenseWord& word : license_words())
    if (meta.contains(word.key) && vrm.license.count(word.key) == 0)
      vrm.license[word.key] = meta[word.key].is_string() ? meta[word.key].get<std::string>() : meta[word.key].dump();
  return vrm;
}

}  // namespace

const std::vector<std::string>& vrm_required_bones(bool zero) {
  static const std::vector<std::string> kBones = {"hips",          "spine",         "head",          "leftUpperLeg",
                                                  "leftLowerLeg",  "leftFoot",      "rightUpperLeg", "rightLowerLeg",
                                                  "rightFoot",     "leftUpperArm",  "leftLowerArm",  "leftHand",
                                                  "rightUpperArm", "rightLowerArm", "rightHand"};
  static const std::vector<std::string> kZero = [] {
    std::vector<std::string> bones = kBones;
    bones.insert(bones.begin() + 2, {"chest", "neck"});
    return bones;
  }();
  return zero ? kZero : kBones;
}

std::map<std::string, int> humanoid_nodes(const std::string& path, const VrmData& vrm,
                                          const std::vector<int>& joint_nodes) {
  std::map<std::string, int> bones;
  for (size_t j = 0; j < vrm.bones.size() && j < joint_nodes.size(); ++j) {
    if (vrm.bones[j].empty()) continue;
    if (!bones.emplace(vrm.bones[j], joint_nodes[j]).second)
      throw Error(path + ": cannot write a VRM, two joints are its " + vrm.bones[j]);
  }
  std::vector<std::string> missing;
  for (const std::string& bone : vrm_required_bones(vrm.zero))
    if (bones.count(bone) == 0) missing.push_back(bone);
  if (!missing.empty()) throw Error(path + ": cannot write a VRM, the skeleton lacks " + joined(missing, ", "));
  return bones;
}

std::map<std::string, std::string> parse_vrm_license(const std::string& text) {
  std::map<std::string, std::string> out;
  if (text.rfind("http://", 0) == 0 || text.rfind("https://", 0) == 0) return {{"otherLicenseUrl", text}};
  for (size_t from = 0; from < text.size();) {
    const size_t end = std::min(text.find(',', from), text.size()), equals = text.find('=', from);
    const std::string key = text.substr(from, std::min(equals, end) - from),
                      value = equals < end ? text.substr(equals + 1, end - equals - 1) : "";
    std::vector<std::string> keys;
    const LicenseWord* word = nullptr;
    for (const LicenseWord& one : license_words()) {
      keys.emplace_back(one.key);
      if (key == one.key) word = &one;
    }
    if (word == nullptr)
      throw Error("license " + in_quotes(key) + ": expected a web address, or KEY=VALUE with one of " +
                  joined(keys, ", "));
    const bool known = word->values.empty()
                           ? !value.empty()
                           : std::find(word->values.begin(), word->values.end(), value) != word->values.end();
    if (!known)
      throw Error("license " + key + "=" + value + ": expected " +
                  (word->values.empty() ? "a text" : joined(word->values, ", ")));
    out[key] = value;
    from = end + 1;
  }
  return out;
}

namespace {

constexpr const char* kNobody = "unknown";
constexpr const char* kNoAuthor = "warning: the VRM has no author, so it names \"unknown\"; give --author";

void add_vrm_one(const std::string& path, const VrmData& vrm, const std::vector<int>& joint_nodes, Json* document,
                 std::vector<std::string>* notes) {
  drop_extension("VRM", document);
  Json& own = (*document)["extensions"]["VRMC_vrm"];
  if (!own.is_object()) own = Json::object();
  own["specVersion"] = "1.0";
  own["meta"] = meta_of(vrm, own.value("meta", Json::object()));
  if (own["meta"].value("authors", Json::array()).empty()) {
    own["meta"]["authors"] = {kNobody};
    notes->emplace_back(kNoAuthor);
  }
  Json bones = Json::object();
  for (const auto& [bone, node] : humanoid_nodes(path, vrm, joint_nodes)) bones[bone] = {{"node", node}};
  own["humanoid"] = {{"humanBones", std::move(bones)}};
}

void add_vrm_zero(const std::string& path, VrmData vrm, const std::vector<int>& joint_nodes, Json* document,
                  std::vector<std::string>* notes) {
  if (const Json::json_pointer newer("/extensions/VRMC_vrm/meta"); document->contains(newer))
    vrm = with_meta(std::move(vrm), (*document)[newer]);
  Json zero = vrm_zero(path, vrm, joint_nodes, *document);
  if (zero["meta"]["author"].get_ref<const std::string&>().empty()) {
    zero["meta"]["author"] = kNobody;
    notes->emplace_back(kNoAuthor);
  }
  if (document->contains(Json::json_pointer("/extensions/VRMC_springBone")))
    notes->emplace_back("springs of VRM 1.0 were left out: sinew does not write springs of VRM 0.x");
  for (const char* newer : {"VRMC_vrm", "VRMC_springBone"}) drop_extension(newer, document);
  (*document)["extensions"]["VRM"] = std::move(zero);
}

}  // namespace

std::vector<std::string> add_vrm(const std::string& path, const VrmData& vrm, const std::vector<int>& joint_nodes,
                                 GltfSource* source) {
  std::vector<std::string> notes;
  Json& document = source->document;
  if (vrm.zero)
    add_vrm_zero(path, vrm, joint_nodes, &document, &notes);
  else
    add_vrm_one(path, vrm, joint_nodes, &document, &notes);
  const char* const name = vrm.zero ? "VRM" : "VRMC_vrm";
  Json& used = document["extensionsUsed"];
  if (std::find(used.begin(), used.end(), name) == used.end()) used.push_back(name);
  return notes;
}

void drop_boneless_vrm(Json* document) {
  for (const char* name : {"VRM", "VRMC_vrm"})
    if (const Json::json_pointer at("/extensions/" + std::string(name));
        document->contains(at) && !(*document)[at].contains("humanoid"))
      drop_extension(name, document);
}

}  // namespace sinew
