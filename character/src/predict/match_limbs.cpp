// SPDX-License-Identifier: MIT
// Chains of one kind and side are matched by nearness, their joints by class.
#include <algorithm>
#include <cmath>
#include <utility>

#include "predict/limbs.hpp"
#include "sinew/sinew.h"
#include "sinew_character/rig/joint_mirror.hpp"
#include "sinew_formats/base/joint_tree.hpp"

namespace sinew {
namespace {

constexpr double kFarOther = 0.25;  // of the size: chains of no known kind further apart do not match

double size_of(const std::vector<Joint>& joints) {
  double longest = 0;
  for (uint32_t axis = 0; axis < 3; ++axis) {
    double low = INFINITY, high = -INFINITY;
    for (const Joint& joint : joints) {
      low = std::min(low, static_cast<double>(component(joint.position, axis)));
      high = std::max(high, static_cast<double>(component(joint.position, axis)));
    }
    longest = std::max(longest, high - low);
  }
  return longest;
}

// All matches of two skeletons that stand alike.
class Matcher {
 public:
  Matcher(const LabeledSkeleton& mine, const LabeledSkeleton& other, uint32_t across)
      : mine_(mine),
        other_(other),
        a_(find_limbs(mine, across, static_cast<double>(mirror_plane(mine.joints, across)))),
        b_(find_limbs(other, across, static_cast<double>(mirror_plane(other.joints, across)))) {
    rough_ = rough_alignment();
    other_size_ = size_of(other.joints);
    for (size_t i = 0; i < a_.limbs.size(); ++i) match_kind(i);
    match_leftovers();
    for (MatchedLimb& limb : matched_) tie_knots(&limb);
  }

  std::vector<MatchedLimb> take() { return std::move(matched_); }
  int pelvis() const { return a_.pelvis; }

 private:
  // Middle and spread of the joints that are no details.
  static std::pair<Point3, double> middle_of(const LabeledSkeleton& s) {
    Point3 sum = {};
    double n = 0, spread = 0;
    for (const bool second : {false, true}) {
      for (size_t j = 0; j < s.joints.size(); ++j) {
        if (s.classes[j] == kClassDetail || s.ends[j] != 0) continue;
        const Point3 p = point(s.joints[j].position);
        if (second) {
          spread += dot(p - sum, p - sum);
        } else {
          sum = sum + p;
          n += 1;
        }
      }
      if (!second && n > 0) sum = (1 / n) * sum;
    }
    return {sum, std::sqrt(spread)};
  }
  Similar rough_alignment() const {
    const auto [from, from_spread] = middle_of(mine_);
    const auto [to, to_spread] = middle_of(other_);
    Similar rough;
    if (from_spread > 0 && to_spread > 0) {
      const auto count = [](const LabeledSkeleton& s) {
        double n = 0;
        for (size_t j = 0; j < s.joints.size(); ++j) n += s.classes[j] != kClassDetail && s.ends[j] == 0 ? 1 : 0;
        return std::sqrt(n);
      };
      rough.scale = to_spread / count(other_) / (from_spread / count(mine_));
    }
    rough.shift = to - rough.scale * from;
    return rough;
  }

  Point3 mine_at(int j) const { return point(mine_.joints[joint_index(j)].position); }
  Point3 other_at(int j) const { return point(other_.joints[joint_index(j)].position); }

  bool comparable(const Limb& a, const Limb& b) const {
    if (a.kind != b.kind || a.side != b.side) return false;
    if (a.kind != LimbKind::kArm && a.kind != LimbKind::kLeg) return true;
    for (const int j : a.joints)
      for (const int k : b.joints)
        if (mine_.classes[joint_index(j)] == other_.classes[joint_index(k)]) return true;
    return false;
  }
  double gap(const Limb& a, const Limb& b) const {
    const auto middle = [](size_t n) { return n / 2; };
    const auto one = [&](size_t i, size_t k) {
      return length(rough_.apply(mine_at(a.joints[i])) - other_at(b.joints[k]));
    };
    return one(0, 0) + one(a.joints.size() - 1, b.joints.size() - 1) +
           one(middle(a.joints.size()), middle(b.joints.size()));
  }

  // The pairs of all chains comparable to one, nearest first.
  void match_kind(size_t first) {
    if (done_.empty()) done_.assign(a_.limbs.size(), false);
    if (done_[first]) return;
    struct Pair {
      double gap;
      size_t a, b;
    };
    std::vector<Pair> pairs;
    for (size_t i = first; i < a_.limbs.size(); ++i) {
      if (a_.limbs[i].kind != a_.limbs[first].kind || a_.limbs[i].side != a_.limbs[first].side) continue;
      done_[i] = true;
      for (size_t k = 0; k < b_.limbs.size(); ++k)
        if (comparable(a_.limbs[i], b_.limbs[k])) pairs.push_back({gap(a_.limbs[i], b_.limbs[k]), i, k});
    }
    std::sort(pairs.begin(), pairs.end(), [](const Pair& x, const Pair& y) {
      return x.gap != y.gap ? x.gap < y.gap : x.a != y.a ? x.a < y.a : x.b < y.b;
    });
    std::vector<bool> used_a(a_.limbs.size(), false), used_b(b_.limbs.size(), false);
    for (const Pair& pair : pairs) {
      if (used_a[pair.a] || used_b[pair.b]) continue;
      if (a_.limbs[pair.a].kind == LimbKind::kOther && pair.gap > 3 * kFarOther * other_size_) continue;
      used_a[pair.a] = used_b[pair.b] = true;
      MatchedLimb limb;
      limb.mine = a_.limbs[pair.a];
      limb.other = b_.limbs[pair.b];
      matched_.push_back(std::move(limb));
    }
  }

  // Limbs without a class: legs of a spider that another maker calls bones.
  void match_leftovers() {
    const auto is_left = [](const Limb& limb, const std::vector<int>& taken) {
      return limb.kind != LimbKind::kTrunk && std::find(taken.begin(), taken.end(), limb.joints[0]) == taken.end();
    };
    while (true) {
      std::vector<int> taken_a, taken_b;
      for (const MatchedLimb& limb : matched_) {
        taken_a.push_back(limb.mine.joints[0]);
        taken_b.push_back(limb.other.joints[0]);
      }
      MatchedLimb best;
      double least = 3 * kFarOther * other_size_;
      for (const Limb& a : a_.limbs) {
        for (const Limb& b : b_.limbs) {
          const bool unknown = a.kind == LimbKind::kOther || b.kind == LimbKind::kOther;
          if (!unknown || a.side != b.side || !is_left(a, taken_a) || !is_left(b, taken_b)) continue;
          if (gap(a, b) >= least) continue;
          least = gap(a, b);
          best.mine = a;
          best.other = b;
        }
      }
      if (best.mine.joints.empty()) return;
      matched_.push_back(std::move(best));
    }
  }

  static bool is_end(const LabeledSkeleton& s, int j) { return s.ends[joint_index(j)] != 0; }

  // The first joint of a class, or the chain's length.
  static size_t first_of(const LabeledSkeleton& s, const Limb& limb, uint8_t wanted) {
    for (size_t i = 0; i < limb.joints.size(); ++i)
      if (s.classes[joint_index(limb.joints[i])] == wanted && !is_end(s, limb.joints[i])) return i;
    return limb.joints.size();
  }

  void tie_knots(MatchedLimb* limb) const {
    for (const int j : limb->mine.joints) limb->mine_points.push_back(mine_at(j));
    for (const int j : limb->other.joints) limb->other_points.push_back(other_at(j));
    const size_t a_count = limb->mine.joints.size(), b_count = limb->other.joints.size();
    const bool a_end = is_end(mine_, limb->mine.joints.back()), b_end = is_end(other_, limb->other.joints.back());
    const size_t a_last = a_count - (a_end ? 2 : 1), b_last = b_count - (b_end ? 2 : 1);
    std::vector<Knot>& knots = limb->knots;
    const bool by_class =
        limb->mine.kind == limb->other.kind &&
        (limb->mine.kind == LimbKind::kTrunk || limb->mine.kind == LimbKind::kArm || limb->mine.kind == LimbKind::kLeg);
    if (by_class) {
      for (uint8_t c = 0; c <= SINEW_CLASS_TOE; ++c) {
        if (c == SINEW_CLASS_SPINE) continue;
        const Knot knot = {first_of(mine_, limb->mine, c), first_of(other_, limb->other, c)};
        if (knot.mine < a_count && knot.other < b_count) knots.push_back(knot);
      }
      std::sort(knots.begin(), knots.end(), [](const Knot& x, const Knot& y) { return x.mine < y.mine; });
      for (size_t i = 1; i < knots.size();) {
        if (knots[i].mine > knots[i - 1].mine && knots[i].other > knots[i - 1].other)
          ++i;
        else
          knots.erase(knots.begin() + static_cast<ptrdiff_t>(i));
      }
    }
    if (knots.empty()) knots.push_back({0, 0});
    if (knots.back().mine >= a_last && knots.back().other >= b_last) {
      if (a_end && b_end) knots.push_back({a_count - 1, b_count - 1});
    } else if (a_end && b_end) {
      knots.push_back({a_count - 1, b_count - 1});
    } else if (knots.back().mine < a_last && knots.back().other < b_last &&
               (!by_class || limb->mine.kind == LimbKind::kTrunk)) {
      const bool alike = a_last - knots.back().mine == b_last - knots.back().other;
      if (alike) {
        knots.push_back({a_last, b_last});
      } else {
        make_end(a_end, &limb->mine_points);
        make_end(b_end, &limb->other_points);
        knots.push_back({limb->mine_points.size() - 1, limb->other_points.size() - 1});
      }
    }
  }

  // As long as the bone before it.
  static void make_end(bool has_one, std::vector<Point3>* points) {
    if (has_one || points->size() < 2) return;
    const Point3 last = points->back(), before = (*points)[points->size() - 2];
    points->push_back(last + (last - before));
  }

  const LabeledSkeleton &mine_, &other_;
  Limbs a_, b_;
  Similar rough_;
  double other_size_ = 0;
  std::vector<bool> done_;
  std::vector<MatchedLimb> matched_;
};

}  // namespace

LimbMatches::LimbMatches(const LabeledSkeleton& mine, const LabeledSkeleton& other, uint32_t across)
    : other_size_(size_of(other.joints)) {
  Matcher matcher(mine, other, across);
  pelvis_ = matcher.pelvis();
  limbs_ = matcher.take();
}

double LimbMatches::misfit(Similar* best) const {
  std::vector<std::pair<Point3, Point3>> pairs;
  for (const MatchedLimb& limb : limbs_)
    for (const Knot& knot : limb.knots) pairs.emplace_back(limb.mine_points[knot.mine], limb.other_points[knot.other]);
  if (pairs.size() < 2) return INFINITY;
  const double n = static_cast<double>(pairs.size());
  Point3 from = {}, to = {};
  for (const auto& [a, b] : pairs) {
    from = from + (1 / n) * a;
    to = to + (1 / n) * b;
  }
  double above = 0, below = 0, sum = 0;
  for (const auto& [a, b] : pairs) {
    above += dot(a - from, b - to);
    below += dot(a - from, a - from);
  }
  if (!(below > 0)) return INFINITY;
  best->scale = above / below;
  if (!(best->scale > 0)) return INFINITY;
  best->shift = to - best->scale * from;
  for (const auto& [a, b] : pairs) {
    const Point3 gap = best->apply(a) - b;
    sum += dot(gap, gap);
  }
  return std::sqrt(sum / n) / std::max(other_size_, 1e-30);
}

}  // namespace sinew
