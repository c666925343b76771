// SPDX-License-Identifier: MIT
// Suspicious weights: each rule asks for several independent signs at once, because artists do unusual things on
// purpose and a list full of false alarms is not read.
#include "sinew_character/check/label_check.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <numeric>
#include <tuple>

#include "sinew_character/rig/joint_verdicts.hpp"
#include "sinew_character/rig/mesh_surface.hpp"
#include "sinew_formats/median.hpp"
#include "sinew_formats/print.hpp"

namespace sinew {
namespace {

// Lengths are shares of the longest side of the mesh. Settled on the characters of the training data by looking at the
// pictures of everything that was flagged.
constexpr double kFar = 0.12;              // nearer than this nothing is "across the body"
constexpr double kMuchNearer = 0.3;        // the better joint's distance is below this share of the joint's
constexpr double kUsualReach = 3;          // times the joint's median distance that are still usual
constexpr float kNoticeable = 0.2f;        // smaller weights are blur, not labels
constexpr size_t kOtherBranch = 3;         // steps along the skeleton that count as another branch
constexpr double kAgree = 0.6;             // L1 up to which neighbors agree with their mean
constexpr double kDisagree = 1.7;          // L1 from which a vertex has nothing in common with them
constexpr size_t kTwinVertices = 8;        // vertices of the twin that make an idle joint suspicious
constexpr double kClearlyOtherSide = 0.3;  // of the distance between two twins
constexpr double kSamePosition = 1e-3;     // joints nearer to each other are indistinguishable
constexpr double kSharedVertices = 0.4;    // of the vertices on such joints: the rig, not a detail
constexpr double kMoreThanTwin = 0.3;      // weight beyond the twin's; less is a skirt that follows both legs

using Row = std::map<uint32_t, double>;

double difference(const Row& a, const Row& b) {
  double sum = 0;
  for (const auto& [joint, weight] : a) {
    const auto other = b.find(joint);
    sum += std::abs(weight - (other == b.end() ? 0.0 : other->second));
  }
  for (const auto& [joint, weight] : b)
    if (a.count(joint) == 0) sum += weight;
  return sum;
}

class Labels {
 public:
  explicit Labels(const Character& c) : c_(c), distance_(c), twins_(mirror_twins(c)) {
    const size_t vertex_count = c.vertices.size(), joint_count = c.joints.size();
    rows_.resize(vertex_count);
    dominant_.assign(vertex_count, UINT32_MAX);
    strong_vertices_.assign(joint_count, 0);
    has_weight_.assign(joint_count, 0);
    for (size_t v = 0; v < vertex_count; ++v) {
      double sum = 0;
      for (const Influence& i : c.influences[v]) sum += std::max(0.0, static_cast<double>(i.weight));
      if (sum <= 0) continue;
      for (const Influence& i : c.influences[v])
        if (i.weight > 0) rows_[v][i.joint] += static_cast<double>(i.weight) / sum;
      dominant_[v] = std::max_element(rows_[v].begin(), rows_[v].end(), [](const auto& a, const auto& b) {
                       return a.second < b.second;
                     })->first;
      for (const auto& [joint, weight] : rows_[v]) {
        if (weight > 1e-4) has_weight_[joint] = 1;
        if (weight > 0.5) ++strong_vertices_[joint];
      }
    }
    welded_ = first_at_position(c_);
    neighbors_ = welded_rings(c_, welded_);
    give_leaves_length();
    find_usual_distances();
  }

  std::vector<LabelFinding> run() {
    left_right();
    islands();
    far_weights();
    odd_vertices();
    idle_twins();
    shared_positions();
    std::vector<LabelFinding> findings;
    for (auto& [key, vertices] : found_) {
      LabelFinding f;
      f.code = std::get<0>(key);
      f.joint = std::get<1>(key);
      f.better = std::get<2>(key);
      f.vertices.assign(vertices.begin(), vertices.end());
      std::sort(f.vertices.begin(), f.vertices.end());
      f.text = describe(f);
      findings.push_back(std::move(f));
    }
    std::stable_sort(findings.begin(), findings.end(), [](const LabelFinding& a, const LabelFinding& b) {
      return a.vertices.size() > b.vertices.size();
    });
    return findings;
  }

 private:
  // A leaf's bone ends where its vertices do: as far behind their middle as the joint is before it.
  void give_leaves_length() {
    std::vector<std::array<double, 3>> sums(c_.joints.size(), {0, 0, 0});
    std::vector<size_t> counts(c_.joints.size(), 0);
    for (size_t v = 0; v < c_.vertices.size(); ++v) {
      if (dominant_[v] == UINT32_MAX) continue;
      const Vec3& p = c_.vertices[v];
      sums[dominant_[v]][0] += static_cast<double>(p.x);
      sums[dominant_[v]][1] += static_cast<double>(p.y);
      sums[dominant_[v]][2] += static_cast<double>(p.z);
      ++counts[dominant_[v]];
    }
    for (size_t j = 0; j < counts.size(); ++j) {
      if (counts[j] == 0) continue;
      const Vec3& p = c_.joints[j].position;
      const double n = static_cast<double>(counts[j]);
      distance_.set_leaf_end(
          j, {2 * sums[j][0] / n - static_cast<double>(p.x), 2 * sums[j][1] / n - static_cast<double>(p.y),
              2 * sums[j][2] / n - static_cast<double>(p.z)});
    }
  }

  void find_usual_distances() {
    std::vector<std::vector<double>> own(c_.joints.size());
    for (size_t v = 0; v < c_.vertices.size(); ++v)
      if (dominant_[v] != UINT32_MAX && has_weight_[dominant_[v]])
        own[dominant_[v]].push_back(distance_(c_.vertices[v], dominant_[v]));
    usual_.assign(c_.joints.size(), 0);
    for (size_t j = 0; j < own.size(); ++j) {
      if (!own[j].empty()) usual_[j] = median(&own[j]);
    }
  }

  struct NearestJoint {
    uint32_t joint = 0;
    double distance = INFINITY;
  };
  // The nearest joint with weight; called for few vertices.
  NearestJoint nearest(uint32_t vertex) const {
    NearestJoint best;
    for (uint32_t j = 0; j < c_.joints.size(); ++j) {
      if (!has_weight_[j]) continue;
      const double d = distance_(c_.vertices[vertex], j);
      if (d < best.distance) best = {j, d};
    }
    return best;
  }

  size_t steps_between(uint32_t a, uint32_t b) const {
    const auto chain = [&](uint32_t j) {
      std::vector<uint32_t> up = {j};
      while (c_.joints[up.back()].parent >= 0 && up.size() <= c_.joints.size())
        up.push_back(static_cast<uint32_t>(c_.joints[up.back()].parent));
      return up;
    };
    const std::vector<uint32_t> from = chain(a), to = chain(b);
    for (size_t i = 0; i < from.size(); ++i) {
      const auto meet = std::find(to.begin(), to.end(), from[i]);
      if (meet != to.end()) return i + static_cast<size_t>(meet - to.begin());
    }
    return from.size() + to.size();
  }

  void add(const char* code, uint32_t joint, uint32_t better, const std::vector<uint32_t>& vertices) {
    auto& list = found_[{code, joint, better}];
    for (const uint32_t v : vertices) {
      if (flagged_.size() != c_.vertices.size()) flagged_.assign(c_.vertices.size(), 0);
      if (flagged_[v]) continue;  // the first, more exact rule keeps it
      flagged_[v] = 1;
      list.push_back(v);
    }
    if (list.empty() && !vertices.empty()) found_.erase({code, joint, better});
  }

  // Bound to a joint while its mirror twin is where the vertex lies.
  void left_right() {
    for (uint32_t v = 0; v < c_.vertices.size(); ++v) {
      for (const auto& [joint, weight] : rows_[v]) {
        const uint32_t twin = twins_[joint];
        if (weight < static_cast<double>(kNoticeable) || twin == joint) continue;
        const auto twins_own = rows_[v].find(twin);
        if (weight < kMoreThanTwin + (twins_own == rows_[v].end() ? 0.0 : twins_own->second)) continue;
        const Vec3 &a = c_.joints[joint].position, &b = c_.joints[twin].position, &p = c_.vertices[v];
        const double dx = static_cast<double>(b.x - a.x), dy = static_cast<double>(b.y - a.y),
                     dz = static_cast<double>(b.z - a.z);
        const double length2 = dx * dx + dy * dy + dz * dz;
        if (!(length2 > 0)) continue;
        const double along = (static_cast<double>(p.x) - static_cast<double>(a.x + b.x) / 2) * dx +
                             (static_cast<double>(p.y) - static_cast<double>(a.y + b.y) / 2) * dy +
                             (static_cast<double>(p.z) - static_cast<double>(a.z + b.z) / 2) * dz;
        const double own = distance_(p, joint), other = distance_(p, twin);
        if (along > kClearlyOtherSide * length2 && other < 0.5 * own && own > 0.5 * kFar &&
            own > kUsualReach * usual_[twin])
          add("left-right", joint, twin, {v});
      }
    }
  }

  bool across(uint32_t v, uint32_t joint) const {
    const double own = distance_(c_.vertices[v], joint);
    if (!(own > kFar)) return false;
    const NearestJoint near = nearest(v);
    return near.distance < kMuchNearer * own && steps_between(joint, near.joint) >= kOtherBranch;
  }

  // Patches of one strongest joint that lie across the body while most of that joint's vertices do not.
  void islands() {
    std::vector<std::vector<uint32_t>> patches;
    std::vector<uint8_t> seen(c_.vertices.size(), 0);
    for (uint32_t start = 0; start < c_.vertices.size(); ++start) {
      if (welded_[start] != start || seen[start] || dominant_[start] == UINT32_MAX) continue;
      std::vector<uint32_t> patch = {start};
      seen[start] = 1;
      for (size_t k = 0; k < patch.size(); ++k)
        for (const uint32_t n : neighbors_[patch[k]])
          if (!seen[n] && dominant_[n] == dominant_[start]) {
            seen[n] = 1;
            patch.push_back(n);
          }
      patches.push_back(std::move(patch));
    }
    std::vector<size_t> total(c_.joints.size(), 0);
    for (const auto& patch : patches) total[dominant_[patch[0]]] += patch.size();
    for (const auto& patch : patches) {
      const uint32_t joint = dominant_[patch[0]];
      if (2 * patch.size() > total[joint]) continue;  // the joint's own position
      const auto over = static_cast<size_t>(std::count_if(patch.begin(), patch.end(), [&](uint32_t v) {
        return across(v, joint) && distance_(c_.vertices[v], joint) > kUsualReach * usual_[joint];
      }));
      if (10 * over < 9 * patch.size()) continue;
      add("island", joint, nearest(patch[0]).joint, patch);
    }
  }

  void far_weights() {
    for (uint32_t v = 0; v < c_.vertices.size(); ++v)
      for (const auto& [joint, weight] : rows_[v])
        if (weight >= static_cast<double>(kNoticeable) && across(v, joint) &&
            distance_(c_.vertices[v], joint) > kUsualReach * usual_[joint])
          add("far-weight", joint, nearest(v).joint, {v});
  }

  void odd_vertices() {
    for (uint32_t v = 0; v < c_.vertices.size(); ++v) {
      if (dominant_[v] == UINT32_MAX) continue;
      const std::vector<uint32_t>& ring = neighbors_[welded_[v]];
      if (ring.size() < 3) continue;
      Row mean;
      for (const uint32_t n : ring)
        for (const auto& [joint, weight] : rows_[n]) mean[joint] += weight / static_cast<double>(ring.size());
      if (mean.empty() || difference(rows_[v], mean) < kDisagree) continue;
      if (!std::all_of(ring.begin(), ring.end(),
                       [&](uint32_t n) { return !rows_[n].empty() && difference(rows_[n], mean) < kAgree; }))
        continue;
      const uint32_t theirs = std::max_element(mean.begin(), mean.end(), [](const auto& a, const auto& b) {
                                return a.second < b.second;
                              })->first;
      // A tip with a joint of its own is no mistake.
      if (distance_(c_.vertices[v], dominant_[v]) <= distance_(c_.vertices[v], theirs)) continue;
      add("odd-vertex", dominant_[v], theirs, {v});
    }
  }

  void idle_twins() {
    for (uint32_t j = 0; j < c_.joints.size(); ++j)
      if (!has_weight_[j] && twins_[j] != j && strong_vertices_[twins_[j]] >= kTwinVertices)
        add("idle-twin", j, twins_[j], {});
  }

  // Joints with vertices at the position of a sibling with vertices: position and hierarchy do not decide which of
  // them holds what, so a character with many of them is useless for training.
  void shared_positions() {
    double low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY}, side = 0;
    for (const Vec3& p : c_.vertices) {
      const float at[3] = {p.x, p.y, p.z};
      for (int i = 0; i < 3; ++i) {
        low[i] = std::min(low[i], static_cast<double>(at[i]));
        high[i] = std::max(high[i], static_cast<double>(at[i]));
        side = std::max(side, high[i] - low[i]);
      }
    }
    size_t shared = 0, all = 0;
    std::pair<uint32_t, uint32_t> most{0, 0};
    for (uint32_t j = 0; j < c_.joints.size(); ++j) {
      all += strong_vertices_[j];
      if (strong_vertices_[j] == 0) continue;
      for (uint32_t other = 0; other < c_.joints.size(); ++other) {
        if (other == j || strong_vertices_[other] == 0 || c_.joints[j].parent != c_.joints[other].parent) continue;
        const Vec3 &a = c_.joints[j].position, &b = c_.joints[other].position;
        if (std::hypot(static_cast<double>(a.x - b.x), static_cast<double>(a.y - b.y), static_cast<double>(a.z - b.z)) >
            kSamePosition * side)
          continue;
        shared += strong_vertices_[j];
        if (most.first == most.second || strong_vertices_[j] > strong_vertices_[most.first]) most = {j, other};
        break;
      }
    }
    if (all == 0 || static_cast<double>(shared) < kSharedVertices * static_cast<double>(all)) return;
    shared_ = static_cast<double>(shared) / static_cast<double>(all);
    add("shared-position", most.first, most.second, {});
  }

  std::string describe(const LabelFinding& f) const {
    const std::string joint = "'" + c_.joints[f.joint].name + "'", better = "'" + c_.joints[f.better].name + "'";
    if (f.code == "idle-twin")
      return "joint " + joint + " has no weight, but its mirror twin " + better + " holds " +
             std::to_string(strong_vertices_[f.better]) + " vertices";
    if (f.code == "shared-position")
      return print("%.0f %% of the vertices are bound to joints at the position of a sibling, such as ",
                   100 * shared_) +
             joint + " and " + better + ": it is ambiguous which holds what";
    const std::string count =
        std::to_string(f.vertices.size()) + (f.vertices.size() == 1 ? " vertex" : " vertices") + " bound to " + joint;
    std::string text;
    if (f.code == "left-right") {
      text = count + " at the position of its mirror twin " + better;
    } else if (f.code == "odd-vertex") {
      text = count + " among vertices of " + better;
    } else {
      double own = 0, near = 0;
      for (const uint32_t v : f.vertices) {
        own += distance_(c_.vertices[v], f.joint) / static_cast<double>(f.vertices.size());
        near += nearest(v).distance / static_cast<double>(f.vertices.size());
      }
      text = count + print(" %.2f of the mesh's size away, ", own) + better + print(" at %.2f", near);
    }
    for (size_t i = 0; i < f.vertices.size() && i < 5; ++i)
      text += (i == 0 ? ": " : ", ") + std::to_string(f.vertices[i]);
    return text + (f.vertices.size() > 5 ? ", ..." : "");
  }

  const Character& c_;
  BoneDistance distance_;
  std::vector<uint32_t> twins_, dominant_, welded_;
  std::vector<Row> rows_;
  std::vector<double> usual_;
  double shared_ = 0;  // of the vertices, on joints that share their position
  std::vector<std::vector<uint32_t>> neighbors_;
  std::vector<size_t> strong_vertices_;
  std::vector<uint8_t> has_weight_, flagged_;
  std::map<std::tuple<std::string, uint32_t, uint32_t>, std::vector<uint32_t>> found_;
};

bool sound(const Character& c) {
  if (c.joints.empty() || c.influences.size() != c.vertices.size()) return false;
  for (size_t j = 0; j < c.joints.size(); ++j) {
    size_t steps = 0;
    for (int at = static_cast<int>(j); at >= 0; at = c.joints[static_cast<size_t>(at)].parent)
      if (++steps > c.joints.size() || at >= static_cast<int>(c.joints.size())) return false;
  }
  for (const Vec3& p : c.vertices)
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) return false;
  for (const Joint& j : c.joints)
    if (!std::isfinite(j.position.x) || !std::isfinite(j.position.y) || !std::isfinite(j.position.z)) return false;
  for (const uint32_t v : c.face_vertices)
    if (v >= c.vertices.size()) return false;
  for (const auto& row : c.influences)
    for (const Influence& i : row)
      if (i.joint >= c.joints.size() || !std::isfinite(i.weight)) return false;
  return true;
}

}  // namespace

std::vector<uint32_t> mirror_twins(const Character& character) {
  const size_t count = character.joints.size();
  std::vector<uint32_t> twins(count);
  std::iota(twins.begin(), twins.end(), 0u);
  const JointVerdicts verdicts = joint_verdicts(character.joints);
  bool any = false;
  for (const std::vector<int32_t>* const others : {&verdicts.partners, &verdicts.images}) {
    for (uint32_t j = 0; j < count && !any; ++j) {
      const int32_t other = (*others)[j];
      if (other >= 0 && (*others)[static_cast<size_t>(other)] == static_cast<int32_t>(j))  // both must agree
        twins[j] = static_cast<uint32_t>(other);
    }
    for (uint32_t j = 0; j < count; ++j) any = any || twins[j] != j;
  }
  return twins;
}

std::vector<LabelFinding> check_labels(const Character& character) {
  if (!sound(character)) return {};
  return Labels(character).run();
}

}  // namespace sinew
