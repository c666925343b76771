// SPDX-License-Identifier: MIT
#include "gltf/vrm_animation.hpp"

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
        fail("a node of its own for every bone", "one that is two, " + in_quotes(name));
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

}  // namespace sinew
