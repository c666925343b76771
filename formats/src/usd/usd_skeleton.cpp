// SPDX-License-Identifier: MIT
// Skeletons and animations of a character as USD's text.
#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "gltf/control_points.hpp"
#include "gltf/node_parts.hpp"
#include "text/text_lines.hpp"
#include "usd/usd_text.hpp"
#include "usd/usd_write.hpp"

namespace sinew {
namespace {

constexpr double kCubicStep = 1.0 / 60;  // seconds between keys of a cubic track
constexpr double kStepGap = 1e-4;        // seconds in which a track of steps goes from one value to the next

std::string time_code(double seconds) { return print("%.8g", seconds * kUsdTimeCodes); }

// A value at each time as an attribute: one where it stands still.
class Samples {
 public:
  Samples(const char* type, size_t width) : type_(type), width_(width) {}
  void add(std::vector<double> values) { rows_.push_back(std::move(values)); }

  std::string text(const std::string& name, const std::vector<double>& times) const {
    const std::string in = "            ", head = in + type_ + " " + name;
    const auto value = [&](const std::vector<double>& row) {
      return width_ == 1 ? usd_list(row) : usd_tuples(row, width_);
    };
    if (std::all_of(rows_.begin(), rows_.end(), [&](const auto& row) { return row == rows_.front(); }))
      return head + " = " + value(rows_.front()) + "\n";
    std::string out = head + ".timeSamples = {\n";
    for (size_t t = 0; t < times.size(); ++t) out += in + "    " + time_code(times[t]) + ": " + value(rows_[t]) + ",\n";
    return out + in + "}\n";
  }

 private:
  const std::string type_;
  const size_t width_;
  std::vector<std::vector<double>> rows_;
};

void add_times(const std::vector<float>& keys, Blend blend, std::set<double>* times) {
  for (size_t k = 0; k < keys.size(); ++k) {
    const double time = static_cast<double>(keys[k]), before = k == 0 ? time : static_cast<double>(keys[k - 1]);
    times->insert(time);
    if (!(time > before)) continue;
    if (blend == Blend::kStep && time - before > 2 * kStepGap) times->insert(time - kStepGap);
    if (blend != Blend::kCubic) continue;
    const size_t parts = std::clamp<size_t>(static_cast<size_t>(std::ceil((time - before) / kCubicStep)), 1, 10000);
    for (size_t p = 1; p < parts; ++p)
      times->insert(before + (time - before) * static_cast<double>(p) / static_cast<double>(parts));
  }
}

}  // namespace

UsdSkeleton::UsdSkeleton(const std::string& path, const tinygltf::Model& model, const GltfNodes& nodes)
    : path_(path), model_(model), nodes_(nodes) {
  find_joints();
  find_binds();
  find_clips();
}

// Joints parents first, with their paths.
void UsdSkeleton::find_joints() {
  const std::vector<char> is_joint = scene_joints(model_, nodes_);
  for (size_t n = 0; n < model_.nodes.size(); ++n)
    if (nodes_.parents[n] < 0 && nodes_.in_scene[n] != 0) order_.push_back(n);
  for (size_t next = 0; next < order_.size(); ++next)
    for (const int child : model_.nodes[order_[next]].children) order_.push_back(static_cast<size_t>(child));
  joint_of_node_.assign(model_.nodes.size(), -1);
  std::map<int, std::set<std::string>> taken;  // names below a joint
  for (const size_t n : order_) {
    if (is_joint[n] == 0) continue;
    const int parent = nodes_.parents[n] < 0 ? -1 : joint_above(static_cast<size_t>(nodes_.parents[n]));
    joint_of_node_[n] = static_cast<int>(joints_.size());
    const std::string name = usd_free_name(model_.nodes[n].name, &taken[parent]);
    paths_.push_back(parent < 0 ? name : paths_[static_cast<size_t>(parent)] + "/" + name);
    names_.push_back(model_.nodes[n].name);
    parents_.push_back(parent);
    joints_.push_back(n);
  }
}

int UsdSkeleton::joint_above(size_t node) const {
  for (int up = static_cast<int>(node); up >= 0; up = nodes_.parents[static_cast<size_t>(up)])
    if (joint_of_node_[static_cast<size_t>(up)] >= 0) return joint_of_node_[static_cast<size_t>(up)];
  return -1;
}

void UsdSkeleton::find_binds() {
  for (const size_t node : joints_) binds_.push_back(nodes_.worlds[node]);
  for (size_t s = 0; s < model_.skins.size(); ++s) {
    frames_.push_back(skin_frame(path_, model_, nodes_, s));
    const std::vector<Affine> inverses = inverse_bind_matrices(path_, model_, model_.skins[s]);
    for (size_t k = 0; k < inverses.size(); ++k) {
      const int joint = joint_of(model_.skins[s].joints[k]);
      const std::optional<Affine> back = inverse(inverses[k]);
      if (joint >= 0 && back) binds_[static_cast<size_t>(joint)] = multiply(frames_[s], *back);
    }
  }
}

void UsdSkeleton::find_clips() {
  std::set<std::string> taken;
  for (const tinygltf::Animation& from : model_.animations) {
    Clip clip;
    clip.name = from.name.empty() ? "animation" : from.name;
    clip.where = path_ + ": animation " + in_quotes(clip.name);
    std::set<double> times;
    for (const tinygltf::AnimationChannel& channel : from.channels) {
      if (channel.target_node < 0 || channel.sampler < 0) continue;
      const size_t node = static_cast<size_t>(channel.target_node);
      const tinygltf::AnimationSampler& sampler = from.samplers.at(static_cast<size_t>(channel.sampler));
      if (channel.target_path == "weights") {
        clip.weights[node] = &sampler;
        add_times(accessor_floats(clip.where, model_, sampler.input, 1), Blend::kLinear, &times);
        continue;
      }
      const Track track = read_track(clip.where, model_, sampler, channel.target_path == "rotation" ? 4 : 3);
      add_times(track.times, track.blend, &times);
      clip.tracks[node][channel.target_path] = track;
    }
    if (times.empty()) continue;
    clip.times.assign(times.begin(), times.end());
    last_time_ = std::max(last_time_, clip.times.back() * kUsdTimeCodes);
    clips_.push_back(std::move(clip));
  }
}

std::vector<Affine> UsdSkeleton::locals(const std::vector<Affine>& worlds) const {
  std::vector<Affine> out;
  for (size_t j = 0; j < joints_.size(); ++j) {
    const int parent = parents_[j];
    const std::optional<Affine> back = parent < 0 ? kIdentity : inverse(worlds[joints_[static_cast<size_t>(parent)]]);
    out.push_back(multiply(back.value_or(kIdentity), worlds[joints_[j]]));
  }
  return out;
}

// Where nodes stand at a time.
std::vector<Affine> UsdSkeleton::worlds_at(const Clip& clip, double seconds) const {
  std::vector<Affine> worlds(model_.nodes.size(), kIdentity);
  for (const size_t n : order_) {
    const tinygltf::Node& node = model_.nodes[n];
    Affine local = parts_of(node).affine();
    if (const auto at = clip.tracks.find(n); at != clip.tracks.end()) {
      NodeParts parts = parts_of(node);
      for (const auto& [what, track] : at->second) {
        const std::array<double, 4> value = track.sample(seconds);
        if (what == "rotation") parts.rotation = normalized(value);
        for (size_t i = 0; i < 3 && what != "rotation"; ++i)
          (what == "scale" ? parts.scale : parts.translation)[i] = value[i];
      }
      local = parts.affine();
    } else if (node.matrix.size() == 16) {
      for (size_t r = 0; r < 3; ++r)
        for (size_t c = 0; c < 4; ++c) local[4 * r + c] = node.matrix[4 * c + r];
    }
    const int parent = nodes_.parents[n];
    worlds[n] = parent < 0 ? local : multiply(worlds[static_cast<size_t>(parent)], local);
  }
  return worlds;
}

std::vector<double> UsdSkeleton::shape_curve(size_t node, size_t shape, size_t shape_count, double rest) const {
  std::vector<double> curve;
  for (const Clip& clip : clips_) {
    const auto at = clip.weights.find(node);
    std::vector<float> times, values;
    size_t parts = 1;
    if (at != clip.weights.end()) {
      times = accessor_floats(clip.where, model_, at->second->input, 1);
      values = accessor_floats(clip.where, model_, at->second->output, 1);
      parts = at->second->interpolation == "CUBICSPLINE" ? 3 : 1;
    }
    const bool known = !times.empty() && values.size() == times.size() * parts * shape_count;
    const auto key = [&](size_t k) {
      return static_cast<double>(values[(k * parts + parts / 2) * shape_count + shape]);
    };
    for (const double seconds : clip.times) {
      if (!known) {
        curve.push_back(rest);
        continue;
      }
      const size_t above = static_cast<size_t>(
          std::upper_bound(times.begin(), times.end(), static_cast<float>(seconds)) - times.begin());
      if (above == 0 || above == times.size()) {
        curve.push_back(key(above == 0 ? 0 : above - 1));
        continue;
      }
      const double from = static_cast<double>(times[above - 1]), to = static_cast<double>(times[above]);
      const double t = at->second->interpolation == "STEP" ? 0 : (seconds - from) / (to - from);
      curve.push_back(key(above - 1) * (1 - t) + key(above) * t);
    }
  }
  return curve;
}

std::string UsdSkeleton::text(const std::vector<UsdShape>& shapes) const {
  if (joints_.empty() && (shapes.empty() || clips_.empty())) return "";
  std::string animations, first;
  std::set<std::string> taken;
  size_t time = 0;
  for (const Clip& clip : clips_) {
    const std::string prim = usd_free_name(clip.name, &taken);
    if (first.empty()) first = prim;
    animations += animation(clip, prim, shapes, time);
    time += clip.times.size();
  }
  std::string out =
      "    def Skeleton \"Skeleton\" (\n        prepend apiSchemas = [\"SkelBindingAPI\"]\n    )\n    {\n";
  out += "        uniform token[] joints = " + usd_tokens(paths_) + "\n";
  out += "        uniform token[] jointNames = " + usd_tokens(names_) + "\n";
  out += "        uniform matrix4d[] bindTransforms = " + usd_matrices(binds_) + "\n";
  out += "        uniform matrix4d[] restTransforms = " + usd_matrices(locals(nodes_.worlds)) + "\n";
  if (!first.empty()) out += "        rel skel:animationSource = </Character/Skeleton/" + first + ">\n";
  return out + animations + "    }\n\n";
}

std::string UsdSkeleton::animation(const Clip& clip, const std::string& prim, const std::vector<UsdShape>& shapes,
                                   size_t first_time) const {
  Samples rotations("quatf[]", 4), scales("half3[]", 3), translations("float3[]", 3), weights("float[]", 1);
  std::vector<NodeParts> rest;
  for (const Affine& local : locals(nodes_.worlds)) rest.push_back(parts_of(local, NodeParts()));
  for (size_t j = 0; j < joints_.size(); ++j)  // which alone know whether they mirror
    for (size_t i = 0; i < 3; ++i)
      rest[j].scale[i] = std::copysign(rest[j].scale[i], parts_of(model_.nodes[joints_[j]]).scale[i]);
  for (size_t t = 0; t < clip.times.size(); ++t) {
    const std::vector<Affine> here = locals(worlds_at(clip, clip.times[t]));
    std::vector<double> q, p, s, w;
    for (size_t j = 0; j < here.size(); ++j) {
      const NodeParts parts = parts_of(here[j], rest[j]);
      q.insert(q.end(), {parts.rotation[3], parts.rotation[0], parts.rotation[1], parts.rotation[2]});
      p.insert(p.end(), parts.translation.begin(), parts.translation.end());
      for (const double scale : parts.scale) s.push_back(std::round(scale * 1e6) / 1e6);  // half floats hold less
    }
    for (const UsdShape& shape : shapes) w.push_back(shape.curve[first_time + t]);
    rotations.add(std::move(q));
    translations.add(std::move(p));
    scales.add(std::move(s));
    weights.add(std::move(w));
  }
  const std::string name = usd_name_line("            ", prim, clip.name);
  std::string out = "\n        def SkelAnimation \"" + prim + "\"" + (name.empty() ? "" : " (\n" + name + "        )") +
                    "\n        {\n";
  if (!shapes.empty()) {
    std::vector<std::string> tokens;
    for (const UsdShape& shape : shapes) tokens.push_back(shape.token);
    out += "            uniform token[] blendShapes = " + usd_tokens(tokens) + "\n" +
           weights.text("blendShapeWeights", clip.times);
  }
  if (!joints_.empty())
    out += "            uniform token[] joints = " + usd_tokens(paths_) + "\n" +
           rotations.text("rotations", clip.times) + scales.text("scales", clip.times) +
           translations.text("translations", clip.times);
  return out + "        }\n";
}

}  // namespace sinew
