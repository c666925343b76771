// SPDX-License-Identifier: MIT
// Fits a labeled skeleton to another: rotates the whole, matches and positions chains, moves the rest with their
// bones.
#include "sinew_character/predict/fit_skeleton.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "predict/limbs.hpp"
#include "predict/turn.hpp"
#include "sinew/sinew.h"
#include "sinew_character/rig/joint_mirror.hpp"
#include "sinew_formats/base/joint_tree.hpp"
#include "sinew_formats/error.hpp"

namespace sinew {
namespace {

// A predicted joint is at the mean position of all makers; `mine` has its own maker's habits. Shares of it, chosen on
// 57 pairs of MakeHuman rigs with predictions (mean distance 2.7 % of the side without them, 1.9 % with them).
constexpr double kOwnShape = 0.7;   // between two matches: 0 = on the other's chain, 1 = shaped as in `mine`
constexpr double kOwnHabit = 0.95;  // pelvis, neck and clavicles where a similar copy of the torso has them
constexpr double kOwnLimbRoot = 0.3, kOwnHead = 0.4;      // shoulders and thighs; the head
constexpr double kOwnReach = 0.8, kOwnForearm = 0.6;      // lengths of the bones to hands and toes; to the elbow
constexpr double kHabitWeight = 0.05, kHeadWeight = 0.5;  // in the similar copy; shoulders and thighs have 1
// Where bodies differ, `mine` has less of a say: half at these.
constexpr double kUnlikeTrunk = 0.3;   // share of the torso's extent that the similar copy leaves
constexpr double kUnlikeLength = 0.5;  // natural logarithm of two lengths' ratio

constexpr double kUntouched = 0.7;    // a rotation of the whole must fit that much better than none
constexpr double kFloorShare = 0.04;  // of the height: a root at most that high above the lowest joint is on the floor

// Rest pose with the whole skeleton rotated.
LabeledSkeleton turned_skeleton(LabeledSkeleton s, const Rotation& rotation) {
  for (Joint& joint : s.joints) joint.position = to_vec3(turned(rotation, point(joint.position)));
  return s;
}

// `mine` already stands as `other` does.
class Fitter {
 public:
  Fitter(const LabeledSkeleton& mine, const LabeledSkeleton& other, const FitOptions& options, uint32_t across)
      : mine_(mine),
        other_(other),
        options_(options),
        up_(axis_index(options.up_axis)),
        matches_(mine, other, across),
        positions_(mine.joints.size()),
        how_(mine.joints.size(), FitHow::kCarried),
        known_(mine.joints.size(), false),
        rotations_(mine.joints.size(), kNoRotation),
        scales_(mine.joints.size(), 1),
        links_(mine.joints.size()) {
    (void)matches_.misfit(&whole_);
    order_ = JointTree(mine_.joints).parents_first;
  }

  FittedSkeleton fit() {
    place_matches();
    blend_trunk();
    blend_lengths();
    place_between();
    link_bones();
    carry();
    place_roots();
    if (options_.keep_lengths) keep_lengths();
    FittedSkeleton out;
    out.joints = mine_.joints;
    for (size_t j = 0; j < count(); ++j) out.joints[j].position = to_vec3(positions_[j]);
    out.how = how_;
    out.matched = static_cast<size_t>(std::count(how_.begin(), how_.end(), FitHow::kMatched));
    for (size_t j = 0; j < count(); ++j)
      out.matchable += mine_.classes[j] != kClassDetail && mine_.ends[j] == 0 ? 1 : 0;
    out.scale = whole_.scale;
    return out;
  }

 private:
  size_t count() const { return mine_.joints.size(); }
  Point3 old(size_t j) const { return point(mine_.joints[j].position); }
  int parent(size_t j) const { return mine_.joints[j].parent; }
  void place(size_t j, const Point3& p, FitHow how) {
    positions_[j] = p;
    how_[j] = how;
    known_[j] = true;
  }

  void place_matches() {
    for (const MatchedLimb& limb : matches_.limbs())
      for (const Knot& knot : limb.knots)
        if (knot.mine < limb.mine.joints.size())
          place(joint_index(limb.mine.joints[knot.mine]), limb.other_points[knot.other], FitHow::kMatched);
  }

  // A predicted joint is the mean of makers' habits: a similar copy of the torso has the habits of this one.
  void blend_trunk() {
    std::vector<size_t> trunk;
    std::vector<double> weights;
    for (size_t j = 0; j < count(); ++j) {
      const uint8_t c = mine_.classes[j];
      if (how_[j] != FitHow::kMatched || mine_.ends[j] != 0) continue;
      if (c == SINEW_CLASS_UPPER_ARM || c == SINEW_CLASS_THIGH)
        weights.push_back(1);
      else if (c == SINEW_CLASS_HEAD)
        weights.push_back(kHeadWeight);
      else if (c == SINEW_CLASS_PELVIS || c == SINEW_CLASS_NECK || c == SINEW_CLASS_CLAVICLE || c == SINEW_CLASS_HIP)
        weights.push_back(kHabitWeight);
      else
        continue;
      trunk.push_back(j);
    }
    if (trunk.size() < 4) return;
    Point3 from = {}, to = {};
    const double n = std::accumulate(weights.begin(), weights.end(), 0.0);
    for (size_t i = 0; i < trunk.size(); ++i) {
      from = from + (weights[i] / n) * old(trunk[i]);
      to = to + (weights[i] / n) * positions_[trunk[i]];
    }
    std::vector<RotationPair> pairs;
    double above = 0, below = 0;
    for (size_t i = 0; i < trunk.size(); ++i)
      pairs.push_back({old(trunk[i]) - from, positions_[trunk[i]] - to, weights[i]});
    const Rotation rotation = best_rotation(pairs, kNoRotation);
    for (const RotationPair& pair : pairs) {
      above += pair.weight * dot(turned(rotation, pair.from), pair.to);
      below += pair.weight * dot(pair.from, pair.from);
    }
    if (!(below > 0)) return;
    double left = 0, spread = 0;
    for (const RotationPair& pair : pairs) {
      const Point3 gap = pair.to - (above / below) * turned(rotation, pair.from);
      left += pair.weight * dot(gap, gap);
      spread += pair.weight * dot(pair.to, pair.to);
    }
    const double unlike = std::sqrt(left / std::max(spread, 1e-30));
    const double trust = 1 / (1 + unlike * unlike / (kUnlikeTrunk * kUnlikeTrunk));
    for (size_t i = 0; i < trunk.size(); ++i) {
      const Point3 copy = to + (above / below) * turned(rotation, pairs[i].from);
      const double own = trust * own_share(mine_.classes[trunk[i]]);
      positions_[trunk[i]] = (1 - own) * positions_[trunk[i]] + own * copy;
    }
  }

  static double own_share(uint8_t joint_class) {
    if (joint_class == SINEW_CLASS_UPPER_ARM || joint_class == SINEW_CLASS_THIGH) return kOwnLimbRoot;
    return joint_class == SINEW_CLASS_HEAD ? kOwnHead : kOwnHabit;
  }

  static double own_length(uint8_t joint_class) {
    if (joint_class == SINEW_CLASS_HAND || joint_class == SINEW_CLASS_TOE) return kOwnReach;
    return joint_class == SINEW_CLASS_FOREARM ? kOwnForearm : 0;
  }

  // f(a, b): joints of mine at both ends of a bone of an arm or a leg, from the body outwards.
  template <typename F>
  void each_limb_bone(const F& f) const {
    for (const MatchedLimb& limb : matches_.limbs()) {
      if (limb.mine.kind != LimbKind::kArm && limb.mine.kind != LimbKind::kLeg) continue;
      for (size_t k = 0; k + 1 < limb.knots.size() && limb.knots[k + 1].mine < limb.mine.joints.size(); ++k)
        f(joint_index(limb.mine.joints[limb.knots[k].mine]), joint_index(limb.mine.joints[limb.knots[k + 1].mine]));
    }
  }

  // Bones of arms and legs point where the other's do, and are partly as long as in `mine`.
  void blend_lengths() {
    double above = 0, below = 0;
    each_limb_bone([&](size_t a, size_t b) {
      const double before = length(old(b) - old(a));
      above += before * length(positions_[b] - positions_[a]);
      below += before * before;
    });
    if (!(above > 0) || !(below > 0)) return;
    each_limb_bone([&](size_t a, size_t b) {
      const double own = mine_.ends[b] != 0 ? 0 : own_length(mine_.classes[b]);
      const Point3 bone = positions_[b] - positions_[a];
      const double now = length(bone), wanted = above / below * length(old(b) - old(a));
      if (own == 0 || !(now > 0) || !(wanted > 0)) return;
      const double unlike = std::log(wanted / now) / kUnlikeLength;
      positions_[b] = positions_[b] + (own / (1 + unlike * unlike) * (wanted - now) / now) * bone;
    });
  }

  void place_between() {
    for (MatchedLimb limb : matches_.limbs()) {
      for (const Knot& knot : limb.knots)  // where blending has put them
        if (knot.mine < limb.mine.joints.size())
          limb.other_points[knot.other] = positions_[joint_index(limb.mine.joints[knot.mine])];
      for (size_t k = 0; k + 1 < limb.knots.size(); ++k) {
        const Knot a = limb.knots[k], b = limb.knots[k + 1];
        const std::vector<double> along = lengths_along(limb.mine_points, a.mine, b.mine);
        const Point3 from = limb.mine_points[b.mine] - limb.mine_points[a.mine];
        const Point3 to = limb.other_points[b.other] - limb.other_points[a.other];
        const Rotation rotation = best_rotation({{from, to, 1}}, kNoRotation);
        const double scale = length(from) > 0 ? length(to) / length(from) : whole_.scale;
        for (size_t i = a.mine + 1; i < b.mine && i < limb.mine.joints.size(); ++i) {
          const double share = along.back() > 0 ? along[i - a.mine] / along.back() : 0;
          const Point3 on_chain = point_along(limb.other_points, a.other, b.other, share);
          const Point3 shaped =
              limb.other_points[a.other] + scale * turned(rotation, limb.mine_points[i] - limb.mine_points[a.mine]);
          place(joint_index(limb.mine.joints[i]), (1 - kOwnShape) * on_chain + kOwnShape * shaped, FitHow::kBetween);
        }
      }
    }
  }

  int known_above(size_t j) const {
    int above = parent(j);
    while (above >= 0 && !known_[joint_index(above)]) above = parent(joint_index(above));
    return above;
  }

  // Bones that determine a joint's rotation: to the next of its chain, and to the chains that begin at it.
  void link_bones() {
    for (const MatchedLimb& limb : matches_.limbs()) {
      const std::vector<int>& joints = limb.mine.joints;
      for (size_t i = 0; i + 1 < joints.size(); ++i)
        if (known_[joint_index(joints[i])] && known_[joint_index(joints[i + 1])])
          links_[joint_index(joints[i])].push_back(
              {old(joint_index(joints[i + 1])) - old(joint_index(joints[i])),
               positions_[joint_index(joints[i + 1])] - positions_[joint_index(joints[i])], 1});
      link_open_end(limb);
    }
    for (size_t j = 0; j < count(); ++j) {
      if (!known_[j]) continue;
      const int above = known_above(j);
      if (above < 0) continue;
      bool same_chain = false;
      for (const MatchedLimb& limb : matches_.limbs()) {
        const auto found = std::find(limb.mine.joints.begin(), limb.mine.joints.end(), static_cast<int>(j));
        same_chain = same_chain || (found != limb.mine.joints.end() && found != limb.mine.joints.begin());
      }
      if (!same_chain)
        links_[joint_index(above)].push_back(
            {old(j) - old(joint_index(above)), positions_[j] - positions_[joint_index(above)], 1});
    }
  }

  // The other's hand ends in a bone end, mine in fingers: it points to the center of their ends.
  void link_open_end(const MatchedLimb& limb) {
    const Knot last = limb.knots.back();
    if (last.mine >= limb.mine.joints.size() || last.other + 1 >= limb.other_points.size()) return;
    const size_t joint = joint_index(limb.mine.joints[last.mine]);
    if (last.mine + 1 < limb.mine.joints.size() || other_.ends[joint_index(limb.other.joints.back())] == 0) return;
    Point3 sum = {};
    double n = 0;
    std::vector<bool> leaf(count(), true);
    for (size_t j = 0; j < count(); ++j)
      if (parent(j) >= 0) leaf[joint_index(parent(j))] = false;
    for (size_t j = 0; j < count(); ++j) {
      int above = leaf[j] && j != joint ? static_cast<int>(j) : -1;
      while (above >= 0 && above != static_cast<int>(joint)) above = parent(joint_index(above));
      if (above < 0) continue;
      sum = sum + old(j);
      n += 1;
    }
    if (n == 0 || mine_.classes[joint] != SINEW_CLASS_HAND) return;
    const Point3 from = (1 / n) * sum - old(joint), to = limb.other_points.back() - positions_[joint];
    if (!(length(from) > 0)) return;
    // For the direction alone.
    open_ends_.push_back(
        {joint, {from, (length(from) * scale_into(limb, last.mine) / std::max(length(to), 1e-30)) * to, 1}});
  }

  // Scale of the chain's bone that ends at a point.
  double scale_into(const MatchedLimb& limb, size_t i) const {
    if (i == 0) return whole_.scale;
    const size_t a = joint_index(limb.mine.joints[i - 1]), b = joint_index(limb.mine.joints[i]);
    const double before = length(old(b) - old(a));
    return known_[a] && known_[b] && before > 0 ? length(positions_[b] - positions_[a]) / before : whole_.scale;
  }

  // Parents first: frames of bones, and of their children without a match.
  void carry() {
    for (const size_t j : order_) {
      const int above = parent(j);
      const bool has_frame = above >= 0 && framed(joint_index(above));
      if (!known_[j]) {
        if (!has_frame) continue;  // a root, or below one
        place(j,
              positions_[joint_index(above)] + scales_[joint_index(above)] * turned(rotations_[joint_index(above)],
                                                                                    old(j) - old(joint_index(above))),
              FitHow::kCarried);
        rotations_[j] = rotations_[joint_index(above)];
        scales_[j] = scales_[joint_index(above)];
        continue;
      }
      const Rotation usual = has_frame ? rotations_[joint_index(above)] : kNoRotation;
      std::vector<RotationPair> pairs = links_[j];
      double before = 0, after = 0;
      for (const RotationPair& pair : pairs) {
        before += length(pair.from);
        after += length(pair.to);
      }
      for (const auto& [joint, pair] : open_ends_)
        if (joint == j) pairs.push_back(pair);
      rotations_[j] = best_rotation(pairs, usual);
      scales_[j] = before > 0 && after > 0 ? after / before
                   : has_frame             ? std::sqrt(scales_[joint_index(above)] * whole_.scale)
                                           : whole_.scale;
    }
  }

  bool framed(size_t j) const { return known_[j]; }

  // Joints without a matched ancestor: roots, controls below them, second skeletons.
  void place_roots() {
    double low_old = INFINITY, low_new = INFINITY, high_old = -INFINITY;
    std::vector<size_t> sure;
    for (size_t j = 0; j < count(); ++j) {
      if (!known_[j]) continue;
      low_old = std::min(low_old, old(j)[up_]);
      high_old = std::max(high_old, old(j)[up_]);
      low_new = std::min(low_new, positions_[j][up_]);
      if (how_[j] != FitHow::kCarried) sure.push_back(j);
    }
    const int pelvis = matches_.pelvis();
    for (const size_t j : order_) {
      if (known_[j]) continue;
      bool above_pelvis = false;
      for (int k = pelvis; k >= 0; k = parent(joint_index(k))) above_pelvis = above_pelvis || joint_index(k) == j;
      size_t base = sure.front();
      for (const size_t k : sure)
        if (length(old(k) - old(j)) < length(old(base) - old(j))) base = k;
      if (above_pelvis && known_[joint_index(pelvis)]) base = joint_index(pelvis);
      Point3 p = positions_[base] + scales_[base] * turned(rotations_[base], old(j) - old(base));
      const bool on_floor = old(j)[up_] <= low_old + kFloorShare * (high_old - low_old);
      if (above_pelvis && on_floor) {
        p = positions_[base] + whole_.scale * (old(j) - old(base));
        p[up_] =
            options_.floor ? static_cast<double>(*options_.floor) : low_new + whole_.scale * (old(j)[up_] - low_old);
      }
      place(j, p, FitHow::kCarried);
    }
  }

  // Every bone with its fitted rotation and its original length times one scale, from the pelvis outwards.
  void keep_lengths() {
    double above = 0, below = 0;
    for (size_t j = 0; j < count(); ++j) {
      if (parent(j) < 0 || how_[j] == FitHow::kCarried || how_[joint_index(parent(j))] == FitHow::kCarried) continue;
      const double before = length(old(j) - old(joint_index(parent(j))));
      above += before * length(positions_[j] - positions_[joint_index(parent(j))]);
      below += before * before;
    }
    const double scale = below > 0 && above > 0 ? above / below : whole_.scale;
    const std::vector<Point3> fitted = positions_;
    const auto bone = [&](size_t from, size_t to) {
      const double before = length(old(to) - old(from)), after = length(fitted[to] - fitted[from]);
      if (!(before > 0)) return Point3{};
      if (!(after > 0)) return scale * turned(rotations_[from], old(to) - old(from));
      return (scale * before / after) * (fitted[to] - fitted[from]);
    };
    const int pelvis = matches_.pelvis();
    std::vector<bool> done(count(), false);
    for (int j = pelvis; j >= 0; j = parent(joint_index(j))) {
      done[joint_index(j)] = true;
      if (parent(joint_index(j)) >= 0)
        positions_[joint_index(parent(joint_index(j)))] =
            positions_[joint_index(j)] - bone(joint_index(parent(joint_index(j))), joint_index(j));
    }
    for (const size_t j : order_) {
      if (!done[j] && parent(j) >= 0)
        positions_[j] = positions_[joint_index(parent(j))] + bone(joint_index(parent(j)), j);
      done[j] = true;
    }
    whole_.scale = scale;
  }

  const LabeledSkeleton &mine_, &other_;
  const FitOptions& options_;
  uint32_t up_;
  LimbMatches matches_;
  Similar whole_;
  std::vector<size_t> order_;  // parents first
  std::vector<Point3> positions_;
  std::vector<FitHow> how_;
  std::vector<bool> known_;
  std::vector<Rotation> rotations_;  // [J] of the bones that begin at a joint
  std::vector<double> scales_;
  std::vector<std::vector<RotationPair>> links_;
  std::vector<std::pair<size_t, RotationPair>> open_ends_;
};

// First no rotation, then quarters about the up axis, then the same with other up axes.
std::vector<Rotation> rotations_of_the_whole(Axis up) {
  const Rotation tip = up == Axis::kZ ? Rotation{1, 0, 0, 0, 0, -1, 0, 1, 0} : Rotation{1, 0, 0, 0, 0, 1, 0, -1, 0};
  const Rotation quarter = up == Axis::kZ ? Rotation{0, -1, 0, 1, 0, 0, 0, 0, 1} : Rotation{0, 0, 1, 0, 1, 0, -1, 0, 0};
  std::vector<Rotation> rotations;
  for (const Rotation& start : {kNoRotation, tip}) {
    rotations.push_back(start);
    for (int i = 0; i < 3; ++i) rotations.push_back(multiply(quarter, rotations.back()));
  }
  return rotations;
}

// But for details, which may be on one side alone.
bool is_symmetric(const LabeledSkeleton& s, const JointMirror& mirror) {
  for (size_t j = 0; j < s.joints.size(); ++j)
    if (mirror.partners[j] < 0 && s.classes[j] != kClassDetail) return false;
  return true;
}

// Makes the result its own mirror image to the bit, where both skeletons were.
void make_symmetric(const LabeledSkeleton& mine, const LabeledSkeleton& other, const JointMirror& plane,
                    FittedSkeleton* fitted) {
  const JointMirror own = find_joint_mirror(mine.joints);
  if (own.axis != plane.axis || !is_symmetric(mine, own) || !is_symmetric(other, plane)) return;
  for (size_t j = 0; j < fitted->joints.size(); ++j) {
    if (own.partners[j] < 0) continue;
    const size_t partner = static_cast<size_t>(own.partners[j]);
    Vec3& p = fitted->joints[j].position;
    if (partner == j) {
      component(&p, plane.axis) = plane.plane;
    } else if (partner > j) {
      Vec3& q = fitted->joints[partner].position;
      const Point3 middle = 0.5 * (point(p) + point(mirrored(q, plane.axis, plane.plane)));
      p = to_vec3(middle);
      q = mirrored(p, plane.axis, plane.plane);
    }
  }
  fitted->symmetric = true;
}

void check_tree(const std::vector<Joint>& joints, const char* what) {
  for (size_t j = 0; j < joints.size(); ++j) {
    size_t steps = 0;
    for (int above = joints[j].parent; above >= 0; above = joints[joint_index(above)].parent)
      if (joint_index(above) >= joints.size() || ++steps > joints.size())
        throw Error(std::string(what) + ": the joints form a cycle, expected a tree");
  }
}

}  // namespace

FittedSkeleton fit_skeleton(const LabeledSkeleton& mine, const LabeledSkeleton& other, const FitOptions& options) {
  if (mine.joints.empty()) throw Error("the skeleton to fit has no joints");
  if (other.joints.empty()) throw Error("no joint to fit the skeleton to");
  check_tree(mine.joints, "the skeleton to fit");
  check_tree(other.joints, "the skeleton to fit to");
  const JointMirror other_mirror = find_joint_mirror(other.joints);
  const uint32_t across = other_mirror.axis;
  LabeledSkeleton best;
  double least = INFINITY;
  for (const Rotation& rotation : rotations_of_the_whole(options.up_axis)) {
    const bool none = rotation == kNoRotation;
    LabeledSkeleton candidate = none ? mine : turned_skeleton(mine, rotation);
    Similar ignored;
    double misfit = LimbMatches(candidate, other, across).misfit(&ignored);
    if (none) misfit *= kUntouched;
    if (misfit >= least && std::isfinite(least)) continue;
    least = misfit;
    best = std::move(candidate);
  }
  if (!std::isfinite(least))
    throw Error("fewer than two joints of the skeleton match those of the mesh; rename its joints by anatomy");
  FittedSkeleton fitted = Fitter(best, other, options, across).fit();
  make_symmetric(best, other, other_mirror, &fitted);
  return fitted;
}

}  // namespace sinew
