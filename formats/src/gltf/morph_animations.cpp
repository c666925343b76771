// SPDX-License-Identifier: MIT
// Adds channels of weights to animations, and extends those that move targets which a mesh had before.
#include "gltf/morph_animations.hpp"

#include <algorithm>

namespace sinew {
namespace {

std::vector<float> weights_at(const MorphClip& clip, const std::vector<size_t>& shapes, double seconds) {
  const double at =
      std::clamp((seconds - clip.start) / clip.frame_time, 0.0, static_cast<double>(clip.weights.size() - 1));
  const size_t below = static_cast<size_t>(at), above = std::min(below + 1, clip.weights.size() - 1);
  const float t = static_cast<float>(at - static_cast<double>(below));
  std::vector<float> out;
  for (const size_t s : shapes)
    out.push_back(clip.weights[below][s] + t * (clip.weights[above][s] - clip.weights[below][s]));
  return out;
}

}  // namespace

void MorphAnimations::write(size_t node, const std::vector<size_t>& shapes, size_t before) {
  const size_t count = document_.contains("animations") ? document_["animations"].size() : 0;
  for (size_t a = 0; a < count; ++a) {
    const MorphClip* clip = nullptr;
    for (const MorphClip& one : morphs_.clips)
      if ((one.is_new ? count - new_animations_ + one.animation : one.animation) == a) clip = &one;
    Json& animation = document_["animations"][a];
    Json* channel = nullptr;
    for (Json& one : animation["channels"])
      if (one["target"].value("node", SIZE_MAX) == node && one["target"].value("path", std::string()) == "weights")
        channel = &one;
    if (channel != nullptr)
      extend_channel(clip, shapes, before, a, &animation, channel);
    else if (clip != nullptr)
      add_channel(*clip, node, shapes, before, &animation);
  }
}

void MorphAnimations::add_channel(const MorphClip& clip, size_t node, const std::vector<size_t>& shapes, size_t before,
                                  Json* animation) {
  if (clip.weights.empty()) return;
  std::vector<float> times, values;
  for (size_t f = 0; f < clip.weights.size(); ++f) {
    const double seconds = clip.start + static_cast<double>(f) * clip.frame_time;
    times.push_back(static_cast<float>(seconds));
    values.insert(values.end(), before, 0.0f);
    const std::vector<float> own = weights_at(clip, shapes, seconds);
    values.insert(values.end(), own.begin(), own.end());
  }
  (*animation)["channels"].push_back(
      {{"sampler", (*animation)["samplers"].size()}, {"target", {{"node", node}, {"path", "weights"}}}});
  (*animation)["samplers"].push_back(
      {{"input", add_key_times(&source_, times)}, {"interpolation", "LINEAR"}, {"output", add_scalars(values)}});
}

// An animation that moves targets which the mesh had before: its keys get values for the new ones, and where they are joined
// by lines, keys at the clip's frames too.
void MorphAnimations::extend_channel(const MorphClip* clip, const std::vector<size_t>& shapes, size_t before,
                                     size_t number, Json* animation, Json* channel) {
  const std::string where = path_ + ": animation " + std::to_string(number);
  const Json sampler = (*animation)["samplers"].at((*channel)["sampler"].get<size_t>());
  std::vector<float> times = accessor_floats(where, model_, sampler.at("input").get<int>(), 1);
  const std::vector<float> old = accessor_floats(where, model_, sampler.at("output").get<int>(), 1);
  const std::string interpolation = sampler.value("interpolation", std::string("LINEAR"));
  const size_t values_a_key = interpolation == "CUBICSPLINE" ? 3 : 1;
  if (times.empty() || old.size() != times.size() * values_a_key * before) return;  // not what glTF says: it stays
  const std::vector<float> own_times = times;
  if (clip != nullptr && interpolation == "LINEAR") {
    for (size_t f = 0; f < clip->weights.size(); ++f)
      times.push_back(static_cast<float>(clip->start + static_cast<double>(f) * clip->frame_time));
    std::sort(times.begin(), times.end());
    times.erase(std::unique(times.begin(), times.end()), times.end());
  }
  std::vector<float> values;
  for (const float time : times) {
    const auto behind = std::upper_bound(own_times.begin(), own_times.end(), time);
    const size_t a = behind == own_times.begin() ? 0 : static_cast<size_t>(behind - own_times.begin()) - 1;
    const size_t b = behind == own_times.begin() ? 0 : std::min(a + 1, own_times.size() - 1);
    const float t = b == a ? 0 : (time - own_times[a]) / (own_times[b] - own_times[a]);
    const std::vector<float> ours = clip == nullptr || clip->weights.empty()
                                        ? std::vector<float>(shapes.size(), 0.0f)
                                        : weights_at(*clip, shapes, static_cast<double>(time));
    for (size_t part = 0; part < values_a_key; ++part) {  // of a cubic: tangent in, value, tangent out
      for (size_t i = 0; i < before; ++i) {
        const float from = old[(a * values_a_key + part) * before + i];
        values.push_back(times.size() == own_times.size() ? from : from + t * (old[b * before + i] - from));
      }
      for (const float weight : ours) values.push_back(values_a_key == 3 && part != 1 ? 0 : weight);
    }
  }
  Json extended = sampler;
  if (times.size() != own_times.size()) extended["input"] = add_key_times(&source_, times);
  extended["output"] = add_scalars(values);
  const Json shared = (*channel)["sampler"];
  size_t users = 0;
  for (const Json& one : (*animation)["channels"]) users += one.at("sampler") == shared ? 1 : 0;
  if (users == 1) {
    (*animation)["samplers"][shared.get<size_t>()] = std::move(extended);
  } else {
    (*channel)["sampler"] = (*animation)["samplers"].size();
    (*animation)["samplers"].push_back(std::move(extended));
  }
  orphans_.push_back(sampler.at("input").get<int>());
  orphans_.push_back(sampler.at("output").get<int>());
}

int MorphAnimations::add_scalars(const std::vector<float>& values) {
  return add_accessor(&source_, values.data(), values.size() * sizeof(float), "SCALAR", TINYGLTF_COMPONENT_TYPE_FLOAT,
                      values.size(), false, false);
}

}  // namespace sinew
