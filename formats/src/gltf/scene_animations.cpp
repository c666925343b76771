// SPDX-License-Identifier: MIT
// Animations of a scene that Assimp read, as a glTF document's.
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <set>
#include <utility>
#include <vector>

#include "gltf/gltf_source.hpp"
#include "gltf/scene_nodes.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/file_kinds.hpp"
#include "text/text_lines.hpp"

namespace sinew {
namespace {

constexpr double kPlainTicks = 25;  // a second, where the file does not say: Assimp's own answer

std::array<float, 3> numbers_of(const aiVector3D& v) { return {v.x, v.y, v.z}; }
std::array<float, 4> numbers_of(aiQuaternion q) {
  q.Normalize();
  return {q.x, q.y, q.z, q.w};
}

// Printable UTF-8. Assimp 5.2 calls COLLADA animations that it puts together combinedAnim_ and '0' + number, a byte that is no text from 80 on.
bool is_text(const std::string& name) {
  if (name.empty()) return false;
  for (const char c : name)
    if (static_cast<unsigned char>(c) < 32 || c == 127) return false;
  try {
    return !Json(name).dump().empty();
  } catch (const Json::exception&) {
    return false;
  }
}

double ticks_of(const aiAnimation& from) { return from.mTicksPerSecond > 0 ? from.mTicksPerSecond : kPlainTicks; }

// Parts of equal ticks, at least one, that are one animation.
struct SceneAnimation {
  std::vector<const aiAnimation*> parts;
  std::string name;
};

// COLLADA has one time line, but for clips that are named. Assimp makes an animation of each element of it: those without a name of their
// own are all called animation_animation, and what it puts together combinedAnim_. They are one animation, called as the file is.
std::vector<SceneAnimation> animations_of(const std::string& path, const aiScene& scene) {
  std::vector<SceneAnimation> out;
  SceneAnimation nameless = {{}, std::filesystem::path(path).stem().string()};
  const bool collada = has_extension(path, ".dae");
  for (unsigned a = 0; a < scene.mNumAnimations; ++a) {
    const aiAnimation& own = *scene.mAnimations[a];
    const std::string name = own.mName.C_Str();
    const bool is_named = name != "animation_animation" && name.rfind("combinedAnim_", 0) != 0;
    if (!collada || is_named || ticks_of(own) != ticks_of(*scene.mAnimations[0]))
      out.push_back({{&own}, name});
    else
      nameless.parts.push_back(&own);
  }
  if (!nameless.parts.empty()) out.insert(out.begin(), std::move(nameless));
  return out;
}

// Keys of one node and path: times that rise, values beside them.
template <size_t N>
struct Keys {
  std::vector<float> times;
  std::vector<std::array<float, N>> values;

  // The first and the last of keys that are all alike: the clip stays as long.
  void thin_out() {
    const bool alike =
        std::all_of(values.begin(), values.end(), [&](const auto& value) { return value == values.front(); });
    if (!alike || times.size() < 3) return;
    times = {times.front(), times.back()};
    values = {values.front(), values.back()};
  }
};

class AnimationConverter {
 public:
  AnimationConverter(const std::string& path, const SceneAnimation& from, size_t number,
                     const std::map<std::string, size_t>& nodes, GltfSource* source)
      : parts_(from.parts), nodes_(nodes), source_(*source), name_(from.name) {
    const aiAnimation& first = *parts_.front();
    if (!is_text(name_)) {
      name_ = "animation_" + std::to_string(number);
      if (!from.name.empty())
        source_.notes.push_back("the name of an animation is not text; it was renamed to " + name_);
    }
    where_ = path + ": animation " + in_quotes(name_);
    ticks_ = ticks_of(first);
  }

  void convert() {
    animation_ = {{"name", name_}, {"channels", Json::array()}, {"samplers", Json::array()}};
    std::vector<const aiNodeAnim*> channels;
    bool shapes = false;
    for (const aiAnimation* part : parts_) {
      channels.insert(channels.end(), part->mChannels, part->mChannels + part->mNumChannels);
      shapes = shapes || part->mNumMeshChannels + part->mNumMorphMeshChannels > 0;
    }
    find_start(channels);
    // If several parts move the same node, the one with most keys wins.
    if (parts_.size() > 1)
      std::stable_sort(channels.begin(), channels.end(),
                       [](const aiNodeAnim* a, const aiNodeAnim* b) { return key_count(*a) > key_count(*b); });
    for (const aiNodeAnim* channel : channels) add_channel(*channel);
    if (moves_root_)
      source_.notes.push_back("animation " + in_quotes(name_) + ": motion of the scene root was left out");
    if (shapes) source_.notes.push_back("animation " + in_quotes(name_) + ": blend shape weights were left out");
    if (animation_["channels"].empty())
      source_.notes.push_back("animation " + in_quotes(name_) + " moves no node, so it was left out");
    else
      source_.document["animations"].push_back(std::move(animation_));
  }

 private:
  // Seconds begin at the first key of all.
  void find_start(const std::vector<const aiNodeAnim*>& channels) {
    bool any = false;
    const auto take = [&](const auto* keys, unsigned count) {
      if (count == 0) return;
      start_ = any ? std::min(start_, keys[0].mTime) : keys[0].mTime;
      any = true;
    };
    for (const aiNodeAnim* channel : channels) {
      take(channel->mPositionKeys, channel->mNumPositionKeys);
      take(channel->mRotationKeys, channel->mNumRotationKeys);
      take(channel->mScalingKeys, channel->mNumScalingKeys);
    }
  }
  static uint64_t key_count(const aiNodeAnim& channel) {
    return uint64_t{channel.mNumPositionKeys} + channel.mNumRotationKeys + channel.mNumScalingKeys;
  }

  void add_channel(const aiNodeAnim& channel) {
    const auto at = nodes_.find(channel.mNodeName.C_Str());
    if (at == nodes_.end()) return;
    if (at->second == 0) {
      moves_root_ = true;
      return;
    }
    const size_t before = animation_["channels"].size();
    add_track<3>(channel, at->second, "translation", "VEC3", channel.mPositionKeys, channel.mNumPositionKeys);
    add_track<4>(channel, at->second, "rotation", "VEC4", channel.mRotationKeys, channel.mNumRotationKeys);
    add_track<3>(channel, at->second, "scale", "VEC3", channel.mScalingKeys, channel.mNumScalingKeys);
    // glTF lets no animation touch a node that has a matrix; the tracks say its parts.
    if (animation_["channels"].size() > before) source_.document["nodes"][at->second].erase("matrix");
  }

  template <size_t N, class Key>
  void add_track(const aiNodeAnim& channel, size_t node, const char* what, const char* type, const Key* from,
                 unsigned count) {
    Keys<N> keys = read_keys<N>(channel, what, from, count);
    if (keys.times.empty() || !moved_.emplace(node, what).second) return;
    keys.thin_out();
    const size_t left = keys.times.size();
    const int input = add_key_times(&source_, keys.times);
    const int output = add_accessor(&source_, keys.values.data(), left * N * sizeof(float), type,
                                    TINYGLTF_COMPONENT_TYPE_FLOAT, left, false, false);
    animation_["channels"].push_back(
        {{"sampler", animation_["samplers"].size()}, {"target", {{"node", node}, {"path", what}}}});
    animation_["samplers"].push_back({{"input", input}, {"interpolation", "LINEAR"}, {"output", output}});
  }

  // Keys that do not rise in time are left out.
  template <size_t N, class Key>
  Keys<N> read_keys(const aiNodeAnim& channel, const char* what, const Key* from, unsigned count) const {
    Keys<N> keys;
    for (unsigned k = 0; k < count; ++k) {
      const float time = static_cast<float>((from[k].mTime - start_) / ticks_);
      const std::array<float, N> value = numbers_of(from[k].mValue);
      if (!std::isfinite(time) || !std::all_of(value.begin(), value.end(), [](float x) { return std::isfinite(x); }))
        throw Error(where_ + ", node " + in_quotes(channel.mNodeName.C_Str()) +
                    ": expected finite keys, found another " + what + " at key " + std::to_string(k));
      if (time < 0 || (!keys.times.empty() && !(time > keys.times.back()))) continue;
      keys.times.push_back(time);
      keys.values.push_back(value);
    }
    return keys;
  }

  const std::vector<const aiAnimation*>& parts_;
  const std::map<std::string, size_t>& nodes_;
  GltfSource& source_;
  std::string name_, where_;
  double ticks_ = kPlainTicks, start_ = 0;
  bool moves_root_ = false;
  std::set<std::pair<size_t, std::string>> moved_;  // nodes and paths
  Json animation_;
};

}  // namespace

void add_scene_animations(const std::string& path, const aiScene& scene, const std::map<std::string, size_t>& nodes,
                          GltfSource* source) {
  const std::vector<SceneAnimation> animations = animations_of(path, scene);
  for (size_t a = 0; a < animations.size(); ++a) AnimationConverter(path, animations[a], a, nodes, source).convert();
}

}  // namespace sinew
