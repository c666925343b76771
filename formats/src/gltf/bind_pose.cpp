// SPDX-License-Identifier: MIT
// Which pose the inverse bind matrices agree on.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "gltf/gltf_model.hpp"
#include "sinew_formats/base/box.hpp"

namespace sinew {
namespace {

// Points of the meshes that a skin holds, in the skin's own space: the corners of their boxes.
std::vector<Vec3> box_corners(const std::string& path, const tinygltf::Model& model, const GltfNodes& nodes, int skin) {
  std::vector<Vec3> points;
  for (size_t n = 0; n < model.nodes.size(); ++n) {
    const tinygltf::Node& node = model.nodes[n];
    if (nodes.in_scene[n] == 0 || node.skin != skin || node.mesh < 0) continue;
    for (const tinygltf::Primitive& primitive : model.meshes[static_cast<size_t>(node.mesh)].primitives) {
      const auto at = primitive.attributes.find("POSITION");
      if (at == primitive.attributes.end()) continue;
      const std::vector<float> values = accessor_floats(path + ", POSITION", model, at->second, 3);
      for (size_t i = 0; i + 2 < values.size(); i += 3) points.push_back({values[i], values[i + 1], values[i + 2]});
    }
  }
  if (points.empty()) return {};
  return box_of(points).corners();
}

std::array<double, 3> image(const Affine& m, const Vec3& p) {
  return transform_point(m, static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z));
}

double size_of(const Affine& frame, const std::vector<Vec3>& corners) {
  const std::array<double, 3> low = image(frame, corners.front()), high = image(frame, corners.back());
  return std::max(std::hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]), 1e-12);
}

// The rotations by 90 degrees that a transform is nearest to, its mean scale and its position: an upright character stays upright.
Affine without_sway(const Affine& m) {
  const double volume = determinant(m), scale = std::cbrt(std::fabs(volume));
  Affine best = kIdentity;
  double best_trace = -1e300;
  std::array<size_t, 3> axes = {0, 1, 2};
  do {
    for (int signs = 0; signs < 8; ++signs) {
      Affine rotation{};
      double trace = 0;
      for (size_t r = 0; r < 3; ++r) {
        rotation[r * 4 + axes[r]] = (signs >> r & 1) != 0 ? -1 : 1;
        trace += rotation[r * 4 + axes[r]] * m[r * 4 + axes[r]];
      }
      if (determinant(rotation) * volume > 0 && trace > best_trace) best_trace = trace, best = rotation;
    }
  } while (std::next_permutation(axes.begin(), axes.end()));
  for (size_t i = 0; i < 12; ++i) best[i] = i % 4 == 3 ? m[i] : best[i] * scale;
  return best;
}

class BindPoseFinder {
 public:
  BindPoseFinder(const std::string& path, const tinygltf::Model& model, const GltfNodes& nodes,
                 const SkinWeights& weights)
      : model_(model), nodes_(nodes), weights_(weights) {
    pose_.worlds = nodes.worlds;
    pose_.skin_frames.assign(model.skins.size(), kIdentity);
    for (size_t s = 0; s < model.skins.size(); ++s) {
      const std::string where = path + ": skin " + std::to_string(s);
      binds_.push_back(inverse_bind_matrices(where, model, model.skins[s]));
      palettes_.push_back(skin_palette(where, model, nodes, static_cast<int>(s)));
      corners_.push_back(box_corners(where, model, nodes, static_cast<int>(s)));
      std::vector<size_t> order(weights[s].size());
      std::iota(order.begin(), order.end(), size_t{0});
      std::stable_sort(order.begin(), order.end(), [&](size_t a, size_t b) { return weights[s][a] > weights[s][b]; });
      while (!order.empty() && weights[s][order.back()] <= 0) order.pop_back();
      heaviest_.push_back(std::move(order));
    }
  }

  GltfBindPose find() {
    bool present = true;
    for (size_t s = 0; s < palettes_.size(); ++s) present &= take_present(s) >= 1;
    if (present) return std::move(pose_);
    pose_.moved = true;
    known_.assign(model_.nodes.size(), 0);
    for (size_t s = 0; s < palettes_.size(); ++s) pose_.agrees = pose_.agrees && take_bound(s);
    if (!pose_.agrees) {
      pose_.moved = false;
      pose_.worlds = nodes_.worlds;
      return std::move(pose_);
    }
    carry_along();
    return std::move(pose_);
  }

 private:
  bool idle(size_t s) const { return corners_[s].empty() || heaviest_[s].empty(); }

  // The palette that joints with most of the weight share becomes the skin's frame. Returns their share.
  double take_present(size_t s) {
    if (!palettes_[s].empty()) pose_.skin_frames[s] = palettes_[s][heaviest_[s].empty() ? 0 : heaviest_[s].front()];
    if (idle(s)) return 1;
    double total = 0, best = -1;
    for (const size_t j : heaviest_[s]) total += weights_[s][j];
    constexpr size_t kMostTried = 32;
    for (size_t i = 0; i < std::min(heaviest_[s].size(), kMostTried) && best < total / 2; ++i) {
      const Affine& frame = palettes_[s][heaviest_[s][i]];
      const double size = size_of(frame, corners_[s]);
      double agreed = 0;
      size_t count = 0;
      for (const size_t j : heaviest_[s])
        if (same_pose(palettes_[s][j], frame, corners_[s], size)) agreed += weights_[s][j], ++count;
      if (count == heaviest_[s].size()) agreed = total;
      if (agreed > best) best = agreed, pose_.skin_frames[s] = frame;
    }
    return best / total;
  }

  // The skin's frame by a joint that another skin has placed already, by most of its own joints, or by the heaviest
  // one without the sway of its pose; then the joints by their inverse bind matrices.
  bool take_bound(size_t s) {
    if (idle(s)) return true;
    Affine frame = pose_.skin_frames[s];
    const std::vector<int>& joints = model_.skins[s].joints;
    const auto shared = std::find_if(heaviest_[s].begin(), heaviest_[s].end(),
                                     [&](size_t j) { return known_[static_cast<size_t>(joints[j])] != 0; });
    if (shared != heaviest_[s].end()) {
      frame = multiply(pose_.worlds[static_cast<size_t>(joints[*shared])], binds_[s][*shared]);
    } else if (take_present(s) < 0.5) {
      frame = without_sway(palettes_[s][top_joint(s)]);
    } else {
      frame = pose_.skin_frames[s];
    }
    pose_.skin_frames[s] = frame;
    const double size = size_of(frame, corners_[s]);
    size_t beside = 0;
    for (const size_t j : heaviest_[s]) {
      const std::optional<Affine> back = inverse(binds_[s][j]);
      if (!back) return false;
      const Affine world = multiply(frame, *back);
      const size_t node = static_cast<size_t>(joints[j]);
      if (known_[node] != 0) {
        if (!same_position(world, pose_.worlds[node], 0.01 * size)) return false;
      } else {
        pose_.worlds[node] = world;
        known_[node] = 1;
      }
      beside += is_beside(s, *back) ? 1 : 0;
    }
    return beside * 5 <= heaviest_[s].size();
  }

  // Joints without weight: by their matrices too, unless those were never set.
  void carry_along() {
    for (size_t s = 0; s < binds_.size(); ++s) {
      if (idle(s)) continue;
      for (size_t j = 0; j < binds_[s].size(); ++j) {
        const size_t node = static_cast<size_t>(model_.skins[s].joints[j]);
        const std::optional<Affine> back = inverse(binds_[s][j]);
        if (known_[node] != 0 || !back || binds_[s][j] == kIdentity || is_beside(s, *back)) continue;
        pose_.worlds[node] = multiply(pose_.skin_frames[s], *back);
        known_[node] = 1;
      }
    }
    std::vector<size_t> order;
    for (size_t n = 0; n < model_.nodes.size(); ++n)
      if (nodes_.parents[n] < 0) order.push_back(n);
    for (size_t next = 0; next < order.size(); ++next)
      for (const int child : model_.nodes[order[next]].children) order.push_back(static_cast<size_t>(child));
    std::vector<char> follows(model_.nodes.size(), 0);
    for (const size_t n : order) {
      if (known_[n] != 0) {
        follows[n] = 1;
        continue;
      }
      const int parent = nodes_.parents[n];
      if (parent < 0 || follows[static_cast<size_t>(parent)] == 0) continue;
      const std::optional<Affine> back = inverse(nodes_.worlds[static_cast<size_t>(parent)]);
      if (!back) continue;
      pose_.worlds[n] = multiply(pose_.worlds[static_cast<size_t>(parent)], multiply(*back, nodes_.worlds[n]));
      follows[n] = 1;
    }
  }

  // The joint with weight that has the fewest nodes above it.
  size_t top_joint(size_t s) const {
    size_t best = heaviest_[s].front(), fewest = SIZE_MAX;
    for (const size_t j : heaviest_[s]) {
      size_t above = 0;
      for (int n = model_.skins[s].joints[j]; n >= 0; n = nodes_.parents[static_cast<size_t>(n)]) ++above;
      if (above < fewest) fewest = above, best = j;
    }
    return best;
  }

  // Whether a bind transform in the skin's own space lies far outside of its meshes.
  bool is_beside(size_t s, const Affine& bind) const {
    const Vec3 &low = corners_[s].front(), &high = corners_[s].back();
    const std::array<double, 3> from = {low.x, low.y, low.z}, to = {high.x, high.y, high.z};
    const double room = 0.5 * std::hypot(to[0] - from[0], to[1] - from[1], to[2] - from[2]);
    for (size_t a = 0; a < 3; ++a)
      if (!(bind[a * 4 + 3] >= from[a] - room && bind[a * 4 + 3] <= to[a] + room)) return true;
    return false;
  }

  static bool same_position(const Affine& a, const Affine& b, double distance) {
    return std::hypot(a[3] - b[3], a[7] - b[7], a[11] - b[11]) <= distance;
  }

  const tinygltf::Model& model_;
  const GltfNodes& nodes_;
  const SkinWeights& weights_;
  GltfBindPose pose_;
  std::vector<std::vector<Affine>> binds_, palettes_;  // [skins][joints of the skin]
  std::vector<std::vector<Vec3>> corners_;             // [skins] of the box around its meshes, or empty
  std::vector<std::vector<size_t>> heaviest_;          // [skins] its joints with weight, by descending weight
  std::vector<char> known_;                            // [nodes] placed by an inverse bind matrix
};

}  // namespace

bool same_pose(const Affine& a, const Affine& b, const std::vector<Vec3>& box_corners, double size) {
  return std::all_of(box_corners.begin(), box_corners.end(), [&](const Vec3& corner) {
    const std::array<double, 3> p = image(a, corner), q = image(b, corner);
    return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]) <= kSamePose * size;
  });
}

std::vector<Affine> skin_palette(const std::string& where, const tinygltf::Model& model, const GltfNodes& nodes,
                                 int skin) {
  const tinygltf::Skin& from = model.skins[static_cast<size_t>(skin)];
  std::vector<Affine> palette = inverse_bind_matrices(where, model, from);
  for (size_t j = 0; j < palette.size(); ++j)
    palette[j] = multiply(nodes.worlds[static_cast<size_t>(from.joints[j])], palette[j]);
  return palette;
}

GltfBindPose find_bind_pose(const std::string& path, const tinygltf::Model& model, const GltfNodes& nodes,
                            const SkinWeights& weights) {
  return BindPoseFinder(path, model, nodes, weights).find();
}

}  // namespace sinew
