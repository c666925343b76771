// SPDX-License-Identifier: MIT
// Animations as curves. Rotations become angles, which programs blend on straight lines: between keys that are far apart there are more.
#include <algorithm>
#include <cmath>

#include "fbx/fbx_write.hpp"
#include "gltf/animation_track.hpp"
#include "sinew_formats/base/affine.hpp"
#include "text/text_lines.hpp"

namespace sinew {
namespace {

constexpr double kMostTurn = 5 * 3.14159265358979323846 / 180;  // between two keys of a rotation
constexpr double kCubicStep = 1.0 / 60;                         // seconds between keys of a cubic track

constexpr int32_t kConstantKeys = 0x2, kLinearKeys = 0x4;

struct Curves {
  std::vector<double> times;                // seconds
  std::vector<std::vector<double>> values;  // [components][times]
};

class Animations {
 public:
  Animations(const std::string& whose, const tinygltf::Model& model, const FbxModels& models, FbxScene* scene)
      : whose_(whose), model_(model), models_(models), scene_(*scene) {}

  void add(size_t number) {
    const tinygltf::Animation& animation = model_.animations[number];
    const std::string name = animation.name.empty() ? "animation_" + std::to_string(number) : animation.name;
    where_ = whose_ + ": animation " + in_quotes(name);
    last_ = 0;
    int64_t stack_id = 0;
    FbxNode stack = scene_.object("AnimationStack", name, "AnimStack", "", &stack_id);
    FbxNode layer = scene_.object("AnimationLayer", name, "AnimLayer", "", &layer_);
    for (const tinygltf::AnimationChannel& channel : animation.channels) {
      if (channel.target_node < 0 || static_cast<size_t>(channel.target_node) >= models_.nodes.size() ||
          channel.sampler < 0 || static_cast<size_t>(channel.sampler) >= animation.samplers.size())
        continue;
      const tinygltf::AnimationSampler& sampler = animation.samplers[static_cast<size_t>(channel.sampler)];
      if (channel.target_path == "weights")
        add_weights(static_cast<size_t>(channel.target_node), sampler);
      else
        add_channel(static_cast<size_t>(channel.target_node), channel.target_path, sampler);
    }
    FbxNode properties("Properties70");
    for (const char* start : {"LocalStart", "ReferenceStart"}) properties.property_time(start, 0);
    for (const char* stop : {"LocalStop", "ReferenceStop"}) properties.property_time(stop, ticks(last_));
    stack.add(std::move(properties));
    scene_.add("AnimationStack", std::move(stack));
    scene_.add("AnimationLayer", std::move(layer));
    scene_.connect(layer_, stack_id);
  }

 private:
  static int64_t ticks(double seconds) { return static_cast<int64_t>(std::llround(seconds * kFbxTicks)); }

  void add_channel(size_t node, const std::string& path, const tinygltf::AnimationSampler& sampler) {
    if (models_.nodes[node] == 0) return;  // a skin holds it: its transform has no effect
    const bool turns = path == "rotation", moves = path == "translation";
    if (!turns && !moves && path != "scale") return;
    const Track track = read_track(where_, model_, sampler, turns ? 4 : 3);
    Curves curves;
    curves.times = times_of(track);
    curves.values.resize(3);
    std::array<double, 3> angles{};
    for (const double time : curves.times) {
      const std::array<double, 4> value = track.sample(time);
      if (turns) angles = curves.values[0].empty() ? fbx_euler(value) : fbx_euler(value, angles);
      for (size_t i = 0; i < 3; ++i)
        curves.values[i].push_back(turns ? angles[i] : moves ? kFbxUnits * value[i] : value[i]);
    }
    const char* property = turns ? "Lcl Rotation" : moves ? "Lcl Translation" : "Lcl Scaling";
    add_curves(models_.nodes[node], property,
               turns   ? "R"
               : moves ? "T"
                       : "S",
               {"d|X", "d|Y", "d|Z"}, curves, track.blend == Blend::kStep);
  }

  static std::vector<double> times_of(const Track& track) {
    std::vector<double> times;
    for (size_t k = 0; k < track.times.size(); ++k) {
      const double time = static_cast<double>(track.times[k]);
      if (!times.empty() && !(time > times.back())) continue;
      size_t parts = 1;
      if (!times.empty() && track.blend == Blend::kCubic) {
        parts = static_cast<size_t>(std::ceil((time - times.back()) / kCubicStep));
      } else if (!times.empty() && track.blend == Blend::kLinear && track.width == 4) {
        const double cosine = std::min(1.0, std::abs(dot(normalized(track.key(k - 1)), normalized(track.key(k)))));
        parts = static_cast<size_t>(std::ceil(2 * std::acos(cosine) / kMostTurn));
      }
      parts = std::clamp<size_t>(parts, 1, 10000);
      const double from = times.empty() ? time : times.back();
      for (size_t p = 1; p <= parts; ++p)
        times.push_back(p == parts ? time : from + (time - from) * static_cast<double>(p) / static_cast<double>(parts));
    }
    return times;
  }

  void add_weights(size_t node, const tinygltf::AnimationSampler& sampler) {
    const std::vector<int64_t>& channels = models_.channels[node];
    if (channels.empty()) return;
    const std::vector<float> times = accessor_floats(where_, model_, sampler.input, 1),
                             values = accessor_floats(where_, model_, sampler.output, 1);
    const size_t parts = sampler.interpolation == "CUBICSPLINE" ? 3 : 1, width = channels.size();
    if (values.size() != times.size() * parts * width) return;
    for (size_t t = 0; t < width; ++t) {
      Curves curves;
      curves.values.resize(1);
      for (size_t k = 0; k < times.size(); ++k) {
        if (!curves.times.empty() && !(static_cast<double>(times[k]) > curves.times.back())) continue;
        curves.times.push_back(static_cast<double>(times[k]));
        curves.values[0].push_back(100 * static_cast<double>(values[(k * parts + parts / 2) * width + t]));
      }
      add_curves(channels[t], "DeformPercent", "DeformPercent", {"d|DeformPercent"}, curves,
                 sampler.interpolation == "STEP");
    }
  }

  void add_curves(int64_t target, const char* property, const char* name, const std::vector<const char*>& components,
                  const Curves& curves, bool constant) {
    if (curves.times.empty()) return;
    last_ = std::max(last_, curves.times.back());
    int64_t id = 0;
    FbxNode node = scene_.object("AnimationCurveNode", name, "AnimCurveNode", "", &id);
    FbxNode properties("Properties70");
    for (size_t i = 0; i < components.size(); ++i)
      properties.property(components[i], "Number", "", "A").number(curves.values[i].front());
    node.add(std::move(properties));
    scene_.add("AnimationCurveNode", std::move(node));
    scene_.connect(id, layer_);
    scene_.connect(id, target, property);
    std::vector<int64_t> key_times;
    for (const double time : curves.times) key_times.push_back(ticks(time));
    for (size_t i = 0; i < components.size(); ++i) {
      int64_t curve_id = 0;
      FbxNode curve = scene_.object("AnimationCurve", "", "AnimCurve", "", &curve_id);
      std::vector<float> key_values;
      for (const double value : curves.values[i]) key_values.push_back(static_cast<float>(value));
      curve.add("Default").number(curves.values[i].front());
      curve.add("KeyVer").integer(4008);
      curve.add("KeyTime").longs(key_times);
      curve.add("KeyValueFloat").floats(key_values);
      curve.add("KeyAttrFlags").integers({constant ? kConstantKeys : kLinearKeys});
      curve.add("KeyAttrDataFloat").floats({0, 0, 0, 0});
      curve.add("KeyAttrRefCount").integers({static_cast<int32_t>(key_times.size())});
      scene_.add("AnimationCurve", std::move(curve));
      scene_.connect(curve_id, id, components[i]);
    }
  }

  const std::string& whose_;
  const tinygltf::Model& model_;
  const FbxModels& models_;
  FbxScene& scene_;
  std::string where_;
  int64_t layer_ = 0;
  double last_ = 0;  // seconds
};

}  // namespace

void add_fbx_animations(const std::string& whose, const tinygltf::Model& model, const FbxModels& models,
                        FbxScene* scene) {
  Animations animations(whose, model, models, scene);
  for (size_t a = 0; a < model.animations.size(); ++a) animations.add(a);
}

}  // namespace sinew
