// SPDX-License-Identifier: MIT
// Damages of weights.
#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include "score/rig_damage.hpp"
#include "sinew_character/check/label_check.hpp"
#include "sinew_character/rig/mesh_surface.hpp"

namespace sinew {
namespace {

using Rows = std::vector<std::vector<Influence>>;

class WeightDamage {
 public:
  WeightDamage(Draws* draws, Character* character)
      : draws_(*draws),
        c_(*character),
        rings_(neighbors_of(c_)),
        of_(vertices_by_joint(c_)),
        verdicts_(joint_verdicts(c_.joints)) {
    for (size_t j = 0; j < of_.size(); ++j)
      if (of_[j].size() >= 8) strong_.push_back(j);
    side_ = static_cast<double>(longest_side(c_));
  }

  bool run(const std::string& kind) {
    if (strong_.size() < 3 || c_.influences.size() != c_.vertices.size()) return false;
    if (kind == "unweighted-patch") return patch([](std::vector<Influence>* row) { row->clear(); });
    if (kind == "scaled-sums")
      return patch([](std::vector<Influence>* row) {
        for (Influence& i : *row) i.weight *= 0.7F;
      });
    if (kind == "long-rows") return long_rows();
    if (kind == "speck") return far_patch(1, 0);
    if (kind == "far-patch") return far_patch(0, 0);
    if (kind == "noise") return far_patch(0, 1);
    if (kind == "other-side") return other_side();
    if (kind == "gap") return gap();
    if (kind == "crack") return crack();
    if (kind == "shuffled-rows") {
      std::rotate(c_.influences.begin(), c_.influences.begin() + static_cast<std::ptrdiff_t>(c_.influences.size() / 3),
                  c_.influences.end());
      return true;
    }
    return kind == "collapsed" && collapsed();
  }

 private:
  // About 1 % of the vertices, at least 4, around one with a ring.
  std::vector<uint32_t> some_patch(size_t count) {
    for (int attempt = 0; attempt < 50; ++attempt) {
      const std::vector<uint32_t>& own = of_[draws_.of(strong_)];
      std::vector<uint32_t> patch = {draws_.of(own)};
      if (rings_[patch[0]].size() < 3) continue;
      std::vector<char> seen(c_.vertices.size(), 0);
      seen[patch[0]] = 1;
      for (size_t k = 0; k < patch.size() && patch.size() < count; ++k)
        for (const uint32_t n : rings_[patch[k]])
          if (seen[n] == 0 && patch.size() < count) seen[n] = 1, patch.push_back(n);
      if (patch.size() >= count) return patch;
    }
    return {};
  }
  size_t patch_size() const { return std::max<size_t>(4, c_.vertices.size() / 100); }

  bool patch(const std::function<void(std::vector<Influence>*)>& change) {
    const std::vector<uint32_t> vertices = some_patch(patch_size());
    for (const uint32_t v : vertices) change(&c_.influences[v]);
    return !vertices.empty();
  }

  bool long_rows() {
    if (strong_.size() < 8) return false;
    const std::vector<uint32_t> vertices = some_patch(patch_size());
    for (const uint32_t v : vertices) {
      c_.influences[v].clear();
      const size_t first = draws_.below(strong_.size());
      for (size_t k = 0; k < 8; ++k)
        c_.influences[v].push_back({static_cast<uint32_t>(strong_[(first + k) % strong_.size()]), 0.125F});
    }
    return !vertices.empty();
  }

  // A joint that is at least 30 % of the size away; -1 for none.
  int far_joint(uint32_t v, const BoneDistance& distance) {
    std::vector<size_t> far;
    for (const size_t j : strong_)
      if (distance(c_.vertices[v], j) > 0.3) far.push_back(j);
    return far.empty() ? -1 : static_cast<int>(draws_.of(far));
  }

  bool far_patch(size_t count, int each) {
    const BoneDistance distance(c_);
    const std::vector<uint32_t> vertices = some_patch(count == 0 ? patch_size() : count);
    if (vertices.empty()) return false;
    int joint = far_joint(vertices[0], distance);
    if (joint < 0) return false;
    for (const uint32_t v : vertices) {
      if (each != 0) joint = static_cast<int>(draws_.of(strong_));
      for (const uint32_t twin : at_position_of(v)) c_.influences[twin] = {{static_cast<uint32_t>(joint), 1.0F}};
    }
    return true;
  }

  std::vector<uint32_t> at_position_of(uint32_t v) const {
    std::vector<uint32_t> all = {v};
    for (const uint32_t n : rings_[v]) {
      const Vec3 &a = c_.vertices[v], &b = c_.vertices[n];
      if (n != v && a.x == b.x && a.y == b.y && a.z == b.z) all.push_back(n);
    }
    return all;
  }

  bool other_side() {
    std::vector<size_t> limbs;
    for (const size_t j : limb_joints(c_, verdicts_))
      if (verdicts_.partners[j] >= 0) limbs.push_back(j);
    if (limbs.empty()) return false;
    const size_t joint = draws_.of(limbs);
    for (const uint32_t v : of_[joint]) c_.influences[v] = {{static_cast<uint32_t>(verdicts_.partners[joint]), 1.0F}};
    return true;
  }

  // Vertices of one limb near to a vertex of another one that is not its parent or child.
  bool gap() {
    const std::vector<size_t> limbs = limb_joints(c_, verdicts_);
    const BoneDistance distance(c_);
    for (int attempt = 0; attempt < 30 && limbs.size() > 1; ++attempt) {
      const size_t from = draws_.of(limbs), to = draws_.of(limbs);
      if (related(from, to) || verdicts_.sides[from] == verdicts_.sides[to]) continue;
      std::vector<std::pair<double, uint32_t>> near;
      for (const uint32_t v : of_[from]) near.emplace_back(distance(c_.vertices[v], to), v);
      std::sort(near.begin(), near.end());
      if (near.empty() || near[0].first > 0.25) continue;
      // Through the air: not where the surface itself goes from one limb to the other.
      near.erase(std::remove_if(near.begin(), near.end(), [&](const auto& one) { return touches(one.second, to); }),
                 near.end());
      const size_t count = std::max<size_t>(3, near.size() / 5);
      if (near.size() < count) continue;
      for (size_t k = 0; k < count; ++k) {
        auto& row = c_.influences[near[k].second];
        for (Influence& i : row) i.weight *= 0.5F;
        row.push_back({static_cast<uint32_t>(to), 0.5F});
      }
      return true;
    }
    return false;
  }

  bool touches(uint32_t v, size_t joint) const {
    for (const uint32_t n : rings_[v])
      for (const Influence& i : c_.influences[n])
        if (i.joint == joint && i.weight > 0.01F) return true;
    return std::any_of(c_.influences[v].begin(), c_.influences[v].end(),
                       [&](const Influence& i) { return i.joint == joint; });
  }

  bool related(size_t a, size_t b) const {
    int up = static_cast<int>(a);
    for (size_t steps = 0; up >= 0 && steps < c_.joints.size(); ++steps, up = c_.joints[static_cast<size_t>(up)].parent)
      if (static_cast<size_t>(up) == b) return true;
    up = static_cast<int>(b);
    for (size_t steps = 0; up >= 0 && steps < c_.joints.size(); ++steps, up = c_.joints[static_cast<size_t>(up)].parent)
      if (static_cast<size_t>(up) == a) return true;
    return false;
  }

  bool crack() {
    const std::vector<size_t> limbs = limb_joints(c_, verdicts_);
    if (limbs.empty()) return false;
    const size_t joint = draws_.of(limbs);
    std::vector<char> own(c_.vertices.size(), 0);
    for (const uint32_t v : of_[joint]) own[v] = 1;
    // Faces with all corners the joint's keep their vertices, the others get copies where they share some.
    std::map<uint32_t, uint32_t> copies;
    for (size_t f = 0; f < c_.face_count(); ++f) {
      bool all = true, any = false;
      for (uint32_t k = c_.face_offsets[f]; k < c_.face_offsets[f + 1]; ++k) {
        all = all && own[c_.face_vertices[k]] != 0;
        any = any || own[c_.face_vertices[k]] != 0;
      }
      if (all || !any) continue;
      for (uint32_t k = c_.face_offsets[f]; k < c_.face_offsets[f + 1]; ++k) {
        const uint32_t v = c_.face_vertices[k];
        if (own[v] == 0) continue;
        const auto [copy, is_new] = copies.emplace(v, static_cast<uint32_t>(c_.vertices.size()));
        if (is_new) {
          c_.vertices.push_back(c_.vertices[v]);
          c_.influences.push_back({{static_cast<uint32_t>(std::max(0, c_.joints[joint].parent)), 1.0F}});
          if (!c_.vertex_meshes.empty()) c_.vertex_meshes.push_back(c_.vertex_meshes[v]);
        }
        c_.face_vertices[k] = copy->second;
      }
    }
    return copies.size() >= 4;
  }

  bool collapsed() {
    const std::vector<size_t> limbs = limb_joints(c_, verdicts_);
    if (limbs.empty()) return false;
    const size_t joint = draws_.of(limbs);
    std::vector<uint32_t> region = of_[joint];
    const auto& parents = of_[static_cast<size_t>(c_.joints[joint].parent)];
    region.insert(region.end(), parents.begin(), parents.end());
    for (int round = 0; round < 100; ++round) {
      Rows next = c_.influences;
      for (const uint32_t v : region) {
        std::map<uint32_t, float> mean;
        for (const uint32_t n : rings_[v])
          for (const Influence& i : c_.influences[n]) mean[i.joint] += i.weight / static_cast<float>(rings_[v].size());
        next[v].clear();
        for (const auto& [j, w] : mean) next[v].push_back({j, w});
      }
      c_.influences = std::move(next);
    }
    return true;
  }

  Draws& draws_;
  Character& c_;
  std::vector<std::vector<uint32_t>> rings_, of_;
  JointVerdicts verdicts_;
  std::vector<size_t> strong_;
  double side_ = 1;
};

}  // namespace

bool damage_weights(const std::string& kind, Draws* draws, Character* character) {
  return WeightDamage(draws, character).run(kind);
}

}  // namespace sinew
