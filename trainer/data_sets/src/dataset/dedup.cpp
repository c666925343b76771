// SPDX-License-Identifier: MIT
// Same and near-same characters: normalized positions matched through a grid, then joints by position, then weights.
#include "sinew_data_sets/dedup.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <unordered_map>

namespace sinew {
namespace {

using FloatPoint = std::array<float, 3>;

constexpr double kSamePosition = 1e-4;  // of the longest side: decimals of text files
constexpr double kNearPosition = 0.01;
constexpr double kSameWeights = 5e-3;
constexpr double kNearWeights = 0.05;
constexpr double kSameJoint = 0.01;

double squared(const FloatPoint& a, const FloatPoint& b) {
  double sum = 0;
  for (size_t i = 0; i < 3; ++i) sum += static_cast<double>(a[i] - b[i]) * static_cast<double>(a[i] - b[i]);
  return sum;
}

// Points in cells of a given size; finds the nearest that is not taken within one size.
class Grid {
 public:
  Grid(const std::vector<FloatPoint>& points, float size) : points_(points), size_(size), taken_(points.size(), 0) {
    for (size_t i = 0; i < points.size(); ++i) cells_[key(cell(points[i]))].push_back(static_cast<uint32_t>(i));
  }
  // UINT32_MAX when there is none. `fits` refuses points that must not be taken.
  template <class Fits>
  uint32_t take(const FloatPoint& p, const Fits& fits) {
    const auto middle = cell(p);
    uint32_t best = UINT32_MAX;
    double best_squared = static_cast<double>(size_) * static_cast<double>(size_);
    for (int64_t dx = -1; dx <= 1; ++dx)
      for (int64_t dy = -1; dy <= 1; ++dy)
        for (int64_t dz = -1; dz <= 1; ++dz) {
          const auto found = cells_.find(key({middle[0] + dx, middle[1] + dy, middle[2] + dz}));
          if (found == cells_.end()) continue;
          for (const uint32_t i : found->second) {
            if (taken_[i] || !fits(i) || squared(points_[i], p) >= best_squared) continue;
            best = i;
            best_squared = squared(points_[i], p);
          }
        }
    if (best != UINT32_MAX) taken_[best] = 1;
    return best;
  }

 private:
  std::array<int64_t, 3> cell(const FloatPoint& p) const {
    return {static_cast<int64_t>(std::floor(p[0] / size_)), static_cast<int64_t>(std::floor(p[1] / size_)),
            static_cast<int64_t>(std::floor(p[2] / size_))};
  }
  static uint64_t key(const std::array<int64_t, 3>& c) {
    return static_cast<uint64_t>(c[0] & 0x1FFFFF) << 42 | static_cast<uint64_t>(c[1] & 0x1FFFFF) << 21 |
           static_cast<uint64_t>(c[2] & 0x1FFFFF);
  }
  const std::vector<FloatPoint>& points_;
  float size_;
  std::vector<uint8_t> taken_;
  std::unordered_map<uint64_t, std::vector<uint32_t>> cells_;
};

}  // namespace

// A digest of a character, small enough to keep a whole data set in memory.
struct DuplicateFinder::Shape {
  std::vector<FloatPoint> positions, joints;
  std::vector<uint32_t> valence;  // corners at each vertex
  size_t faces = 0;
  std::vector<uint32_t> row_offsets;
  std::vector<Influence> influences;
  std::vector<uint8_t> joint_used;
};

struct DuplicateFinder::Match {
  Likeness likeness = Likeness::kDifferent;
  double position = 0, weights = 0;
};

const char* likeness_text(Likeness likeness) {
  switch (likeness) {
    case Likeness::kSame:
      return "same";
    case Likeness::kNear:
      return "nearly the same";
    case Likeness::kOtherWeights:
      return "same mesh and skeleton, other weights";
    case Likeness::kOtherSkeleton:
      return "same mesh, other skeleton";
    case Likeness::kDifferent:
      break;
  }
  return "different";
}

DuplicateFinder::DuplicateFinder() = default;
DuplicateFinder::~DuplicateFinder() = default;

void DuplicateFinder::add(const Character& c) {
  auto shape = std::make_unique<Shape>();
  std::array<double, 3> low{}, high{};
  for (size_t v = 0; v < c.vertices.size(); ++v) {
    const std::array<double, 3> p = {static_cast<double>(c.vertices[v].x), static_cast<double>(c.vertices[v].y),
                                     static_cast<double>(c.vertices[v].z)};
    for (size_t i = 0; i < 3; ++i) {
      low[i] = v == 0 ? p[i] : std::min(low[i], p[i]);
      high[i] = v == 0 ? p[i] : std::max(high[i], p[i]);
    }
  }
  const double side = std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2]});
  const double scale = side > 0 ? 1 / side : 1;
  const auto normal = [&](const Vec3& p) {
    return FloatPoint{static_cast<float>((static_cast<double>(p.x) - (low[0] + high[0]) / 2) * scale),
                      static_cast<float>((static_cast<double>(p.y) - (low[1] + high[1]) / 2) * scale),
                      static_cast<float>((static_cast<double>(p.z) - (low[2] + high[2]) / 2) * scale)};
  };
  for (const Vec3& p : c.vertices) shape->positions.push_back(normal(p));
  for (const Joint& j : c.joints) shape->joints.push_back(normal(j.position));
  shape->valence.assign(c.vertices.size(), 0);
  for (const uint32_t v : c.face_vertices)
    if (v < c.vertices.size()) ++shape->valence[v];
  shape->faces = c.face_count();
  shape->joint_used.assign(c.joints.size(), 0);
  shape->row_offsets.push_back(0);
  for (size_t v = 0; v < c.vertices.size(); ++v) {
    if (v < c.influences.size()) {
      float sum = 0;
      for (const Influence& i : c.influences[v]) sum += i.joint < c.joints.size() ? std::max(i.weight, 0.0f) : 0;
      for (const Influence& i : c.influences[v]) {
        if (i.joint >= c.joints.size() || !(i.weight > 0)) continue;
        shape->influences.push_back({i.joint, i.weight / sum});
        shape->joint_used[i.joint] = 1;
      }
    }
    shape->row_offsets.push_back(static_cast<uint32_t>(shape->influences.size()));
  }
  shapes_.push_back(std::move(shape));
}

DuplicateFinder::Match DuplicateFinder::compare(const Shape& a, const Shape& b) {
  Match match;
  const size_t count = a.positions.size();
  if (count == 0 || count != b.positions.size() || a.faces != b.faces) return match;
  // The same order is the usual case and needs no grid.
  std::vector<uint32_t> other(count);
  std::iota(other.begin(), other.end(), 0u);
  const double limit = kNearPosition * kNearPosition;
  double sum = 0;
  for (size_t v = 0; v < count; ++v) sum += squared(a.positions[v], b.positions[v]);
  if (!(sum < limit * static_cast<double>(count)) || a.valence != b.valence) {
    sum = 0;
    Grid grid(b.positions, static_cast<float>(3 * kNearPosition));
    for (size_t v = 0; v < count; ++v) {
      other[v] = grid.take(a.positions[v], [&](uint32_t i) { return b.valence[i] == a.valence[v]; });
      if (other[v] == UINT32_MAX) return match;
      sum += squared(a.positions[v], b.positions[other[v]]);
    }
    if (!(sum < limit * static_cast<double>(count))) return match;
  }
  match.position = std::sqrt(sum / static_cast<double>(count));
  match.likeness = Likeness::kOtherSkeleton;

  // Every joint that holds weight needs a joint at the same position, one for one; better one that holds weight as well.
  std::vector<uint32_t> joint_of(a.joints.size(), UINT32_MAX);
  std::vector<uint8_t> taken(b.joints.size(), 0);
  const auto pair_up = [&](bool used_in_a, bool used_in_b) {
    for (size_t j = 0; j < a.joints.size(); ++j) {
      if (joint_of[j] != UINT32_MAX || (a.joint_used[j] != 0) != used_in_a) continue;
      double best = kSameJoint * kSameJoint;
      for (size_t k = 0; k < b.joints.size(); ++k) {
        if (taken[k] || (b.joint_used[k] != 0) != used_in_b || squared(a.joints[j], b.joints[k]) >= best) continue;
        best = squared(a.joints[j], b.joints[k]);
        joint_of[j] = static_cast<uint32_t>(k);
      }
      if (joint_of[j] != UINT32_MAX) taken[joint_of[j]] = 1;
    }
  };
  pair_up(true, true);
  pair_up(true, false);
  pair_up(false, true);
  for (size_t j = 0; j < a.joints.size(); ++j)
    if (a.joint_used[j] && joint_of[j] == UINT32_MAX) return match;
  for (size_t k = 0; k < b.joints.size(); ++k)
    if (b.joint_used[k] && !taken[k]) return match;

  double total = 0;
  for (size_t v = 0; v < count; ++v) {
    std::map<uint32_t, double> row;
    for (uint32_t i = a.row_offsets[v]; i < a.row_offsets[v + 1]; ++i)
      row[joint_of[a.influences[i].joint]] += static_cast<double>(a.influences[i].weight);
    for (uint32_t i = b.row_offsets[other[v]]; i < b.row_offsets[other[v] + 1]; ++i)
      row[b.influences[i].joint] -= static_cast<double>(b.influences[i].weight);
    for (const auto& [joint, weight] : row) total += std::abs(weight);
  }
  match.weights = total / static_cast<double>(count);
  if (match.position < kSamePosition && match.weights < kSameWeights)
    match.likeness = Likeness::kSame;
  else
    match.likeness = match.weights < kNearWeights ? Likeness::kNear : Likeness::kOtherWeights;
  return match;
}

std::vector<DuplicateGroup> DuplicateFinder::groups() const {
  std::map<std::pair<size_t, size_t>, std::vector<DuplicateGroup>> by_size;
  for (size_t i = 0; i < shapes_.size(); ++i) {
    auto& groups = by_size[{shapes_[i]->positions.size(), shapes_[i]->faces}];
    bool placed = false;
    for (DuplicateGroup& group : groups) {
      const Match first = compare(*shapes_[group.members[0].index], *shapes_[i]);
      if (first.likeness == Likeness::kDifferent) continue;
      DuplicateGroup::Member member{i, first.likeness, i, first.position, first.weights};
      // A copy of any of the group's own kinds is a copy.
      for (const DuplicateGroup::Member& kept : group.members) {
        if (kept.like != kept.index) continue;
        const Match match = kept.index == group.members[0].index ? first : compare(*shapes_[kept.index], *shapes_[i]);
        if (match.likeness != Likeness::kSame && match.likeness != Likeness::kNear) continue;
        member = {i, match.likeness, kept.index, match.position, match.weights};
        break;
      }
      group.members.push_back(member);
      placed = true;
      break;
    }
    if (!placed) groups.push_back({{{i, Likeness::kSame, i, 0, 0}}});
  }
  std::vector<DuplicateGroup> out;
  for (auto& [size, groups] : by_size)
    for (DuplicateGroup& group : groups)
      if (group.members.size() > 1) out.push_back(std::move(group));
  std::sort(out.begin(), out.end(),
            [](const DuplicateGroup& a, const DuplicateGroup& b) { return a.members[0].index < b.members[0].index; });
  return out;
}

}  // namespace sinew
