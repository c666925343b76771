// SPDX-License-Identifier: MIT
// Finds legs by names; else as groups of joints near the floor that end limbs, without tails.
#include "motion/body_kind.hpp"

#include <algorithm>
#include <cmath>

#include "sinew/rig.h"
#include "sinew_formats/base/joint_tree.hpp"
#include "sinew_formats/base/point.hpp"

namespace sinew {
namespace {

constexpr double kTrunkStands = 0.7, kTrunkLies = 0.5;  // sine of the torso's direction over the horizon
constexpr double kFootHeight = 0.2;                     // of the body's height: what is lower stands on the floor
constexpr double kFootOfFlat = 0.4;
constexpr double kSameFoot = 0.06;  // of the body's extent
constexpr double kFlatShare = 0.8;  // of a flat body's narrower side: its height
constexpr double kSkew = 0.25;      // of what two feet are apart, beside their axis
constexpr size_t kFewestJoints = 6, kManyLegs = 6;

size_t named_legs(const BodyParts& parts) {
  const bool lies = parts.lean() && *parts.lean() < kTrunkLies;
  return static_cast<size_t>(std::count_if(parts.all().begin(), parts.all().end(), [&](const BodyPart& part) {
    const bool long_one = std::any_of(part.joints.begin(), part.joints.end(), [&](int j) {
      const uint8_t own = parts.class_of(j);
      return own == SINEW_CLASS_THIGH || own == SINEW_CLASS_CALF || own == SINEW_CLASS_UPPER_ARM ||
             own == SINEW_CLASS_FOREARM;
    });
    return long_one && (part.kind == PartKind::kLeg || (lies && part.kind == PartKind::kArm));
  }));
}

// The body's box, and its joints near the floor.
class StandingLimbs {
 public:
  StandingLimbs(const MapRig& rig, size_t axis) : rig_(rig), axis_(axis), low_(at(0)), high_(at(0)) {
    for (size_t j = 0; j < rig.joints.size(); ++j)
      for (size_t i = 0; i < 3; ++i) {
        low_[i] = std::min(low_[i], at(j)[i]);
        high_[i] = std::max(high_[i], at(j)[i]);
      }
  }

  // Wider and longer than high, as spiders and crabs are.
  bool is_flat() const {
    const Point3 extent = high_ - low_;
    double narrow = length(extent);
    for (size_t i = 0; i < 3; ++i)
      if (i != axis_) narrow = std::min(narrow, extent[i]);
    return extent[axis_] < kFlatShare * narrow;
  }

  // Pairs of joints at which limbs come down to the floor, two joints each. A leg has its like on the other side: what is alone is a tail.
  size_t count() const {
    const std::vector<Point3> feet = this->feet();
    size_t count = 0;
    std::vector<char> taken(feet.size(), 0);
    for (size_t a = 0; a < feet.size(); ++a)
      for (size_t b = a + 1; b < feet.size() && taken[a] == 0; ++b) {
        if (taken[b] != 0 || !are_sides(feet[a] - feet[b])) continue;
        taken[a] = taken[b] = 1;
        count += 2;
      }
    return count;
  }

 private:
  Point3 at(size_t j) const { return point(rig_.joints[j].position); }

  std::vector<Point3> feet() const {
    const double tall = high_[axis_] - low_[axis_], extent = length(high_ - low_);
    const double floor = low_[axis_] + (is_flat() ? kFootOfFlat : kFootHeight) * tall;
    std::vector<Point3> feet;
    for (const size_t j : JointTree(rig_.joints).parents_first) {
      const int parent = rig_.joints[j].parent;
      if (parent < 0 || at(j)[axis_] >= floor || at(static_cast<size_t>(parent))[axis_] < floor) continue;
      const auto same = [&](const Point3& foot) { return length(foot - at(j)) < kSameFoot * extent; };
      if (std::none_of(feet.begin(), feet.end(), same)) feet.push_back(at(j));
    }
    return feet;
  }
  // Apart along one horizontal axis.
  bool are_sides(const Point3& apart) const {
    double most = 0, all = 0;
    for (size_t i = 0; i < 3; ++i) {
      all += std::abs(apart[i]);
      if (i != axis_) most = std::max(most, std::abs(apart[i]));
    }
    return all - most <= kSkew * most;
  }

  const MapRig& rig_;
  const size_t axis_;
  Point3 low_, high_;
};

}  // namespace

BodyKind body_kind(const MapRig& rig, const BodyParts& parts) {
  BodyKind kind;
  if (rig.joints.size() < kFewestJoints) return kind;
  const StandingLimbs limbs(rig, axis_index(parts.up()));
  const size_t standing = limbs.count(), named = parts.named() ? named_legs(parts) : 0;
  const bool wings = parts.has(PartKind::kWing), flat = limbs.is_flat() && !wings;
  if (flat)
    kind.upright = false;
  else if (!wings && parts.named() && parts.lean() && (*parts.lean() > kTrunkStands || *parts.lean() < kTrunkLies))
    kind.upright = *parts.lean() > kTrunkStands;
  // Names are those of people and horses as often as not, so many legs that stand say more; on an upright body they are the chains of
  // a skirt.
  const bool many = standing >= kManyLegs && standing > named && !kind.upright.value_or(false);
  const size_t legs = named == 0 || many ? standing : named;
  const bool doubtful =
      legs % 2 != 0 || (flat && legs < 4) || (kind.upright.value_or(false) && legs > std::max<size_t>(2, standing));
  if (legs > 0 && !doubtful) kind.legs = legs;
  return kind;
}

size_t difference(const BodyKind& a, const BodyKind& b) {
  size_t sum = a.upright && b.upright && *a.upright != *b.upright ? 1 : 0;
  if (a.legs && b.legs) sum += std::max(*a.legs, *b.legs) - std::min(*a.legs, *b.legs);
  return sum;
}

std::string text_of(const BodyKind& kind) {
  const bool upright = kind.upright.value_or(false);
  const std::string body = upright ? "an upright body" : "a body";
  if (kind.legs) return body + " on " + std::to_string(*kind.legs) + " legs";
  return upright || !kind.upright ? body : body + " that is not upright";
}

}  // namespace sinew
