// SPDX-License-Identifier: MIT
// Puts clips into a glTF document as animations of its joint nodes. Everything else of the document stays.
#include <algorithm>
#include <cmath>
#include <set>

#include "gltf/gltf_container.hpp"
#include "gltf/gltf_source.hpp"
#include "gltf/node_parts.hpp"
#include "sinew_formats/error.hpp"
#include "text/text_lines.hpp"

namespace sinew {
namespace {

// Values of one node over a clip's frames.
struct NodeTrack {
  std::vector<std::array<float, 4>> rotations;
  std::vector<std::array<float, 3>> translations, scales;
};

template <size_t N>
bool is_constant(const std::vector<std::array<float, N>>& values, float tolerance) {
  return std::all_of(values.begin(), values.end(), [&](const auto& value) {
    for (size_t i = 0; i < N; ++i)
      if (!(std::abs(value[i] - values.front()[i]) <= tolerance)) return false;
    return true;
  });
}

class MotionWriter {
 public:
  MotionWriter(const std::string& path, const Motion& motion, const GltfJoints& joints, GltfSource* source)
      : path_(path), motion_(motion), joints_(joints), source_(*source), document_(source->document) {}

  void write() {
    // Joints may be new in the document.
    const GltfSource whole = load_gltf(path_, pack_glb(path_, &document_, source_.bytes));
    model_ = whole.model;
    nodes_ = gltf_nodes(path_, model_);
    joint_of_node_.assign(model_.nodes.size(), -1);
    for (size_t j = 0; j < joints_.nodes.size(); ++j)
      joint_of_node_.at(static_cast<size_t>(joints_.nodes[j])) = static_cast<int>(j);
    for (size_t n = 0; n < model_.nodes.size(); ++n) {
      parts_.push_back(parts_of(model_.nodes[n]));
      const int parent = nodes_.parents[n];
      const std::optional<Affine> back = parent < 0 ? kIdentity : inverse(nodes_.worlds[static_cast<size_t>(parent)]);
      locals_.push_back(back ? multiply(*back, nodes_.worlds[n]) : kIdentity);
      if (parent < 0) order_.push_back(n);
    }
    for (size_t next = 0; next < order_.size(); ++next)
      for (const int child : model_.nodes[order_[next]].children) order_.push_back(static_cast<size_t>(child));
    for (const Clip& clip : motion_.clips) write_clip(clip);
  }

 private:
  void write_clip(const Clip& clip) {
    std::vector<NodeTrack> tracks(joints_.nodes.size());
    for (const MotionFrame& frame : clip.frames) add_frame(frame, &tracks);
    std::vector<float> times;
    for (size_t f = 0; f < clip.frames.size(); ++f)
      times.push_back(static_cast<float>(static_cast<double>(f) * clip.frame_time));
    animation_ = {{"name", free_name(clip.name)}, {"channels", Json::array()}, {"samplers", Json::array()}};
    all_times_ = end_times_ = -1;
    float size = 0;
    for (const NodeTrack& track : tracks)
      for (const auto& t : track.translations)
        for (const float x : t) size = std::max(size, std::abs(x));
    for (size_t j = 0; j < tracks.size(); ++j) {
      const size_t node = static_cast<size_t>(joints_.nodes[j]);
      const NodeParts& rest = parts_[node];
      const NodeTrack& track = tracks[j];
      std::array<float, 4> rotation{};
      std::array<float, 3> position{}, scale{};
      for (size_t i = 0; i < 4; ++i) rotation[i] = static_cast<float>(rest.rotation[i]);
      for (size_t i = 0; i < 3; ++i) {
        position[i] = static_cast<float>(rest.translation[i]);
        scale[i] = static_cast<float>(rest.scale[i]);
      }
      if (rotation[3] < 0)
        for (float& x : rotation) x = -x;
      const bool turned = add_track(node, "rotation", "VEC4", track.rotations, rotation, 2e-7f, times);
      const bool moved = add_track(node, "translation", "VEC3", track.translations, position, 2e-6f * size, times);
      const float largest = std::max({std::abs(scale[0]), std::abs(scale[1]), std::abs(scale[2])});
      const bool scaled = add_track(node, "scale", "VEC3", track.scales, scale, 1e-3f * largest, times);
      if (turned || moved || scaled) make_parts(node);
    }
    if (animation_["channels"].empty())  // nothing moves: a clip all the same
      add_track(static_cast<size_t>(joints_.nodes.at(0)), "rotation", "VEC4", tracks[0].rotations, {9, 9, 9, 9}, 1,
                times);
    document_["animations"].push_back(std::move(animation_));
  }

  // Transforms of the joints' nodes in a frame, relative to their parents.
  void add_frame(const MotionFrame& frame, std::vector<NodeTrack>* tracks) const {
    const std::vector<Affine> palette = motion_palette(motion_, frame, joints_.nodes.size());
    std::vector<Affine> worlds(order_.size());
    for (const size_t n : order_) {
      const int parent = nodes_.parents[n], joint = joint_of_node_[n];
      const Affine above = parent < 0 ? kIdentity : worlds[static_cast<size_t>(parent)];
      if (joint < 0) {
        worlds[n] = multiply(above, locals_[n]);
        continue;
      }
      const size_t j = static_cast<size_t>(joint);
      worlds[n] = multiply(palette[j], joints_.worlds[j]);
      const std::optional<Affine> back = inverse(above);
      if (!back)
        throw Error(path_ + ": cannot write an animation, a node above joint " + in_quotes(motion_.joints[j].name) +
                    " has scale 0");
      add_parts(parts_of(multiply(*back, worlds[n]), parts_[n]), &(*tracks)[j]);
    }
  }

  static void add_parts(const NodeParts& parts, NodeTrack* track) {
    std::array<float, 3> position{}, scale{};
    for (size_t c = 0; c < 3; ++c) {
      position[c] = static_cast<float>(parts.translation[c]);
      scale[c] = static_cast<float>(parts.scale[c]);
    }
    const Quaternion& q = parts.rotation;
    std::array<float, 4> rotation{};
    // Of the two quaternions of one rotation, the one near the frame before; at first the one with w above 0.
    double side = q[3];
    if (!track->rotations.empty()) {
      side = 0;
      for (size_t i = 0; i < 4; ++i) side += q[i] * static_cast<double>(track->rotations.back()[i]);
    }
    for (size_t i = 0; i < 4; ++i) rotation[i] = static_cast<float>(side < 0 ? -q[i] : q[i]);
    track->rotations.push_back(rotation);
    track->translations.push_back(position);
    track->scales.push_back(scale);
  }

  // Adds a channel unless the node has this transform at rest; only the first and the last key if nothing changes, so
  // that the clip keeps its length. Returns whether a channel was added.
  template <size_t N>
  bool add_track(size_t node, const char* what, const char* type, const std::vector<std::array<float, N>>& values,
                 const std::array<float, N>& rest, float tolerance, const std::vector<float>& times) {
    const bool constant = is_constant(values, tolerance);
    if (constant && is_constant<N>({values.front(), rest}, tolerance)) return false;
    const size_t count = constant ? std::min<size_t>(2, values.size()) : values.size();
    int& input = constant ? end_times_ : all_times_;
    if (input < 0) {
      std::vector<float> own = times;
      if (constant && count == 2) own = {times.front(), times.back()};
      input = add_key_times(&source_, own);
    }
    const std::vector<std::array<float, N>> kept(count, values.front());
    const int output = add_accessor(&source_, constant ? kept.data() : values.data(), count * N * sizeof(float), type,
                                    TINYGLTF_COMPONENT_TYPE_FLOAT, count, false, false);
    animation_["channels"].push_back(
        {{"sampler", animation_["samplers"].size()}, {"target", {{"node", node}, {"path", what}}}});
    animation_["samplers"].push_back({{"input", input}, {"interpolation", "LINEAR"}, {"output", output}});
    return true;
  }

  // glTF lets no animation touch a node that has a matrix.
  void make_parts(size_t node) {
    Json& json = document_["nodes"][node];
    if (!json.contains("matrix")) return;
    json.erase("matrix");
    json["translation"] = parts_[node].translation;
    json["rotation"] = parts_[node].rotation;
    json["scale"] = parts_[node].scale;
  }

  std::string free_name(const std::string& wanted) const {
    std::set<std::string> taken;
    if (document_.contains("animations"))
      for (const Json& animation : document_["animations"]) taken.insert(animation.value("name", std::string()));
    std::string name = wanted;
    for (size_t number = 2; taken.count(name) != 0; ++number) name = wanted + "_" + std::to_string(number);
    return name;
  }

  const std::string& path_;
  const Motion& motion_;
  const GltfJoints& joints_;
  GltfSource& source_;
  Json& document_;
  tinygltf::Model model_;
  GltfNodes nodes_;
  std::vector<int> joint_of_node_;  // [N], -1 = no joint
  std::vector<NodeParts> parts_;    // [N]
  std::vector<Affine> locals_;      // [N]
  std::vector<size_t> order_;       // [N] parents before children
  Json animation_;
  int all_times_ = -1, end_times_ = -1;  // accessors
};

}  // namespace

void write_gltf_motion(const std::string& path, const Motion& motion, const GltfJoints& joints, GltfSource* source) {
  try {
    MotionWriter(path, motion, joints, source).write();
  } catch (const nlohmann::json::exception& error) {
    throw Error(path + ": cannot write, the input document has an unexpected form: " + one_line(error.what()));
  }
}

}  // namespace sinew
