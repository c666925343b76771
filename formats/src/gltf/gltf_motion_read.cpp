// SPDX-License-Identifier: MIT
// glTF animations to clips: node transforms sampled frame by frame, against the pose that the skin was bound in.
#include <algorithm>
#include <cmath>
#include <map>

#include "gltf/animation_track.hpp"
#include "gltf/gltf_source.hpp"
#include "gltf/node_parts.hpp"
#include "gltf/vrm.hpp"
#include "sinew_formats/base/affine.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/file_kinds.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_formats/morphs.hpp"
#include "sinew_formats/motion.hpp"
#include "sinew_formats/print.hpp"
#include "text/joint_names.hpp"
#include "text/text_lines.hpp"

namespace sinew {
namespace {

constexpr double kFewestFps = 24, kMostFps = 240, kPlainFps = 30;

// The channels of an animation for one node.
struct NodeTracks {
  const Track *translation = nullptr, *rotation = nullptr, *scale = nullptr;
};

class GltfMotionReader {
 public:
  GltfMotionReader(const std::string& path, double fps)
      : path_(path),
        fps_(fps),
        character_(read_gltf_character(path, false)),
        source_(*character_.gltf),
        nodes_(gltf_nodes(path, source_.model)),
        humanoid_(read_humanoid_nodes(path, source_)) {
    if (has_extension(path, ".vrma") && !humanoid_)
      throw Error(path + ": expected a VRM animation (extension VRMC_vrm_animation), found a glTF without it");
  }

  Motion read() {
    if (model().animations.empty())
      throw Error(path_ + ": expected an animation, found none; the file has " + std::to_string(model().nodes.size()) +
                  " nodes and " + std::to_string(character_.joints.size()) + " joints without motion");
    read_clips();
    if (motion_.clips.empty())
      throw Error(path_ + ": expected an animation that moves the skeleton, found none in " +
                  std::to_string(model().animations.size()));
    return std::move(motion_);
  }

  OwnMotion read_own() {
    read_clips();
    return {std::move(motion_), std::move(keys_)};
  }

 private:
  void read_clips() {
    motion_.name = stem_of(path_);
    if (humanoid_ && humanoid_->left_out) motion_.notes.emplace_back("expressions and eye directions were left out");
    for (size_t a = 0; a < model().animations.size(); ++a) read_tracks(a);
    choose_joints();
    for (size_t a = 0; a < model().animations.size(); ++a) read_clip(a);
  }

  const tinygltf::Model& model() const { return source_.model; }
  std::string name_of(size_t animation) const {
    const std::string& name = model().animations[animation].name;
    return name.empty() ? "animation_" + std::to_string(animation) : name;
  }

  void read_tracks(size_t number) {
    const tinygltf::Animation& animation = model().animations[number];
    const std::string where = path_ + ": animation " + std::to_string(number) + " " + in_quotes(animation.name);
    std::vector<Track>& tracks = tracks_.emplace_back(animation.samplers.size());
    std::vector<char> known(tracks.size(), 0);
    animated_.emplace_back();
    for (size_t c = 0; c < animation.channels.size(); ++c) {
      const tinygltf::AnimationChannel& channel = animation.channels[c];
      const std::string name = where + ", channel " + std::to_string(c);
      const bool turns = channel.target_path == "rotation";
      if (!turns && channel.target_path != "translation" && channel.target_path != "scale") continue;
      if (channel.target_node < 0) continue;  // an extension's
      if (humanoid_ && humanoid_->carries_no_joint(channel.target_node)) continue;
      if (static_cast<size_t>(channel.target_node) >= model().nodes.size())
        throw Error(name + ": expected a node below " + std::to_string(model().nodes.size()) + ", found " +
                    std::to_string(channel.target_node));
      if (channel.sampler < 0 || static_cast<size_t>(channel.sampler) >= tracks.size())
        throw Error(name + ": expected a sampler below " + std::to_string(tracks.size()) + ", found " +
                    std::to_string(channel.sampler));
      const size_t sampler = static_cast<size_t>(channel.sampler);
      Track& track = tracks[sampler];
      const size_t width = turns ? 4 : 3;
      if (known[sampler] == 0) track = read_track(name, model(), animation.samplers[sampler], width);
      known[sampler] = 1;
      if (track.width != width)
        throw Error(name + ": expected a sampler of " + std::to_string(width) + " numbers per key, found one of " +
                    std::to_string(track.width));
      NodeTracks& node = animated_.back()[static_cast<size_t>(channel.target_node)];
      (turns ? node.rotation : channel.target_path == "scale" ? node.scale : node.translation) = &track;
    }
  }

  // The skin's joints first; then animated nodes above or below them. Without a skin all animated nodes and their
  // descendants without a mesh.
  void choose_joints() {
    joint_of_node_.assign(model().nodes.size(), -1);
    std::vector<std::string> names;
    const auto take = [&](size_t node, const std::string& name) {
      joint_of_node_[node] = static_cast<int>(joint_nodes_.size());
      joint_nodes_.push_back(node);
      names.push_back(name);
    };
    for (size_t j = 0; j < character_.joints.size(); ++j)
      take(static_cast<size_t>(source_.joint_nodes[j]), character_.joints[j].name);
    const bool has_skin = !joint_nodes_.empty();
    std::vector<char> above_joint(model().nodes.size(), 0), moves(model().nodes.size(), 0);
    for (const size_t node : joint_nodes_)
      for (int n = nodes_.parents[node]; n >= 0 && above_joint[static_cast<size_t>(n)] == 0;
           n = nodes_.parents[static_cast<size_t>(n)])
        above_joint[static_cast<size_t>(n)] = 1;
    for (const auto& animation : animated_)
      for (const auto& [node, tracks] : animation) moves[node] = 1;
    for (const size_t node : order()) {
      if (joint_of_node_[node] >= 0 || nodes_.in_scene[node] == 0) continue;
      const int up = joint_at_or_above(nodes_.parents[node]);
      const bool bare = model().nodes[node].mesh < 0 && model().nodes[node].camera < 0;
      const std::string* const bone = humanoid_ ? humanoid_->bone(node) : nullptr;
      if (bone != nullptr)
        take(node, *bone);
      else if (has_skin ? moves[node] != 0 && (above_joint[node] != 0 || (up >= 0 && bare))
                        : moves[node] != 0 || (up >= 0 && bare))
        take(node, model().nodes[node].name);
    }
    make_names_unique(&names);
    for (size_t j = 0; j < joint_nodes_.size(); ++j) {
      MotionJoint joint;
      joint.name = names[j];
      joint.parent = joint_at_or_above(nodes_.parents[joint_nodes_[j]]);
      const Affine& rest = source_.bind_pose.worlds[joint_nodes_[j]];
      for (size_t i = 0; i < 3; ++i) joint.offset[i] = rest[4 * i + 3];
      if (joint.parent >= 0) {
        const Affine& from = source_.bind_pose.worlds[joint_nodes_[static_cast<size_t>(joint.parent)]];
        for (size_t i = 0; i < 3; ++i) joint.offset[i] -= from[4 * i + 3];
      }
      backs_.push_back(inverse(rest).value_or(kIdentity));
      motion_.joints.push_back(std::move(joint));
    }
    for (size_t n = 0; n < model().nodes.size(); ++n) {  // of nodes that stand still in their parents
      const int parent = nodes_.parents[n];
      const std::optional<Affine> back = parent < 0 ? kIdentity : inverse(nodes_.worlds[static_cast<size_t>(parent)]);
      locals_.push_back(back ? multiply(*back, nodes_.worlds[n]) : kIdentity);
    }
  }

  int joint_at_or_above(int node) const {
    while (node >= 0 && joint_of_node_[static_cast<size_t>(node)] < 0) node = nodes_.parents[static_cast<size_t>(node)];
    return node < 0 ? -1 : joint_of_node_[static_cast<size_t>(node)];
  }

  // All nodes, parents before children.
  std::vector<size_t> order() const {
    std::vector<size_t> out;
    for (size_t n = 0; n < model().nodes.size(); ++n)
      if (nodes_.parents[n] < 0) out.push_back(n);
    for (size_t next = 0; next < out.size(); ++next)
      for (const int child : model().nodes[out[next]].children) out.push_back(static_cast<size_t>(child));
    return out;
  }

  // The rate of the track whose keys stand closest, in the mean where they are even; of slow ones a multiple that smooth
  // motion needs.
  static double rate_of(const std::map<size_t, NodeTracks>& animated) {
    double least = 0, fps = kPlainFps;
    for (const auto& [node, tracks] : animated)
      for (const Track* track : {tracks.translation, tracks.rotation, tracks.scale}) {
        if (track == nullptr || !(track->times.back() > track->times.front())) continue;
        if (track->times.size() == 2 && track->key(0) == track->key(1)) continue;  // stands still: the ends of the clip
        double shortest = 1e30, longest = 0;
        for (size_t k = 1; k < track->times.size(); ++k) {
          const double gap = static_cast<double>(track->times[k]) - static_cast<double>(track->times[k - 1]);
          if (!(gap > 0)) continue;  // two keys at one time: a jump
          shortest = std::min(shortest, gap);
          longest = std::max(longest, gap);
        }
        const double span = static_cast<double>(track->times.back()) - static_cast<double>(track->times.front());
        if (longest < 1.01 * shortest) shortest = span / static_cast<double>(track->times.size() - 1);
        if (least != 0 && shortest >= least) continue;
        least = shortest;
        fps = 1 / shortest;
        const double whole = std::round(fps);
        if (std::abs(fps - whole) * span < 1e-3) fps = whole;  // times are floats
      }
    if (fps > kMostFps) return kPlainFps;
    return fps < kFewestFps ? fps * std::ceil(kFewestFps / fps - 1e-6) : fps;
  }

  void read_clip(size_t number) {
    const std::map<size_t, NodeTracks>& animated = animated_[number];
    const bool moves = std::any_of(animated.begin(), animated.end(), [&](const auto& one) {
      return joint_of_node_[one.first] >= 0 || nodes_.in_scene[one.first] != 0;
    });
    if (!moves) {
      motion_.notes.push_back("animation " + in_quotes(name_of(number)) + " moves no joint, so it was left out");
      return;
    }
    double first = 0, last = 0;
    bool any = false;
    for (const auto& [node, tracks] : animated)
      for (const Track* track : {tracks.translation, tracks.rotation, tracks.scale}) {
        if (track == nullptr) continue;
        first = any ? std::min(first, static_cast<double>(track->times.front()))
                    : static_cast<double>(track->times.front());
        last = std::max(last, static_cast<double>(track->times.back()));
        any = true;
      }
    Clip clip;
    clip.name = name_of(number);
    const double fps = fps_ > 0 ? fps_ : rate_of(animated);
    clip.frame_time = 1 / fps;
    const double count = std::floor((last - first) * fps + 1e-2) + 1;
    if (!(count * static_cast<double>(motion_.joints.size()) <= static_cast<double>(kMostRotations)))
      throw Error(path_ + ": animation " + in_quotes(clip.name) + ": expected at most " +
                  std::to_string(kMostRotations) + " frames times joints, found " +
                  print("%g seconds at %g frames per second", last - first, fps));
    const std::vector<size_t> nodes = order();
    for (size_t f = 0; f < static_cast<size_t>(count); ++f)
      clip.frames.push_back(frame_of(animated, nodes, first + static_cast<double>(f) / fps));
    MorphClip keys;
    keys.animation = number;
    keys.start = first;
    keys.frame_time = clip.frame_time;
    keys_.push_back(std::move(keys));
    motion_.clips.push_back(std::move(clip));
  }

  MotionFrame frame_of(const std::map<size_t, NodeTracks>& animated, const std::vector<size_t>& nodes,
                       double seconds) const {
    std::vector<Affine> worlds(nodes.size());
    for (const size_t n : nodes) {
      const auto tracks = animated.find(n);
      const int parent = nodes_.parents[n];
      if (tracks == animated.end()) {
        worlds[n] = parent < 0 ? locals_[n] : multiply(worlds[static_cast<size_t>(parent)], locals_[n]);
        continue;
      }
      NodeParts parts = parts_of(model().nodes[n]);
      const NodeTracks& moved = tracks->second;
      if (moved.rotation != nullptr) parts.rotation = normalized(moved.rotation->sample(seconds));
      for (size_t i = 0; i < 3; ++i) {
        if (moved.translation != nullptr) parts.translation[i] = moved.translation->sample(seconds)[i];
        if (moved.scale != nullptr) parts.scale[i] = moved.scale->sample(seconds)[i];
      }
      const Affine local = parts.affine();
      worlds[n] = parent < 0 ? local : multiply(worlds[static_cast<size_t>(parent)], local);
    }
    const size_t count = joint_nodes_.size();
    std::vector<Quaternion> turns(count);
    MotionFrame frame;
    for (size_t j = 0; j < count; ++j)
      turns[j] = quaternion_of(rotation_part(multiply(worlds[joint_nodes_[j]], backs_[j])));
    for (size_t j = 0; j < count; ++j) {
      const Affine& own = worlds[joint_nodes_[j]];
      Point3 shift = {own[3], own[7], own[11]};
      Quaternion turn = turns[j];
      if (const int parent = motion_.joints[j].parent; parent >= 0) {
        const size_t p = static_cast<size_t>(parent);
        const Affine& from = worlds[joint_nodes_[p]];
        for (size_t i = 0; i < 3; ++i) shift[i] -= from[4 * i + 3];
        shift = rotate(conjugate(turns[p]), shift);
        turn = normalized(multiply(conjugate(turns[p]), turn));
      }
      frame.rotations.push_back(turn);
      frame.translations.push_back(shift);
    }
    for (const Point3& p : frame.translations)
      for (const double x : p)
        if (!(std::abs(x) < 1e30))
          throw Error(path_ + ": expected joints within the range of floats, found one beyond it at " +
                      std::to_string(seconds) + " seconds");
    return frame;
  }

  const std::string path_;
  const double fps_;
  const Character character_;
  const GltfSource& source_;
  const GltfNodes nodes_;
  const std::optional<HumanoidNodes> humanoid_;  // of a VRM animation
  Motion motion_;
  std::vector<MorphClip> keys_;                         // [clips]
  std::vector<std::vector<Track>> tracks_;              // [animations][samplers]
  std::vector<std::map<size_t, NodeTracks>> animated_;  // [animations] by node
  std::vector<size_t> joint_nodes_;                     // [J]
  std::vector<int> joint_of_node_;                      // [N], -1 = no joint
  std::vector<Affine> backs_;                           // [J] inverse rest transforms
  std::vector<Affine> locals_;                          // [N] transforms as the file has them
};

}  // namespace

Motion read_gltf_motion(const std::string& path, double fps) { return GltfMotionReader(path, fps).read(); }

OwnMotion read_own_motion(const std::string& path) { return GltfMotionReader(path, 0).read_own(); }

}  // namespace sinew
