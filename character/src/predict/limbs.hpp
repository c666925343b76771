// SPDX-License-Identifier: MIT
// The chains of a labeled skeleton (trunk, arms, legs, tails and so on, each from the body outwards), and which of two skeletons' match.
#ifndef SINEW_CHARACTER_PREDICT_LIMBS_HPP
#define SINEW_CHARACTER_PREDICT_LIMBS_HPP

#include <algorithm>
#include <cstdint>
#include <vector>

#include "predict/turn.hpp"
#include "sinew_character/predict/fit_skeleton.hpp"
#include "sinew_formats/character.hpp"

namespace sinew {

enum class LimbKind : uint8_t { kTrunk, kArm, kLeg, kTail, kWing, kEar, kHair, kOther };

struct Limb {
  LimbKind kind = LimbKind::kOther;
  int side = 0;             // 1, -1 or 0 for the middle, in the order of positions across the plane: 1 has the greater
  std::vector<int> joints;  // from the body outwards; the last may be a bone end
};

struct Limbs {
  std::vector<Limb> limbs;  // the torso first, from the pelvis to the head, if there is one
  int pelvis = -1;          // joint, -1 without one
};

// `across` is the component that tells sides apart, counted from `plane`.
Limbs find_limbs(const LabeledSkeleton& skeleton, uint32_t across, double plane);

// Which chains, and which of their joints, are the same in two skeletons.
struct Similar {
  double scale = 1;
  Point3 shift = {};
  Point3 apply(const Point3& p) const { return scale * p + shift; }
};

// Points of a chain that match, as indices into its points.
struct Knot {
  size_t mine, other;
};

struct MatchedLimb {
  Limb mine, other;
  std::vector<Point3> mine_points, other_points;  // joints, and a made up end behind them where both chains want one
  std::vector<Knot> knots;                        // both ascending
};

// All matches of two skeletons that stand alike.
class LimbMatches {
 public:
  LimbMatches(const LabeledSkeleton& mine, const LabeledSkeleton& other, uint32_t across);

  const std::vector<MatchedLimb>& limbs() const { return limbs_; }
  int pelvis() const { return pelvis_; }  // of mine, -1 without one
  // Root of the mean square left by the best scale and shift, share of the other's size; infinite for too few matches.
  double misfit(Similar* best) const;

 private:
  std::vector<MatchedLimb> limbs_;
  int pelvis_ = -1;
  double other_size_ = 0;
};

// [last - first + 1] from point `first` along the chain, 0 at first.
inline std::vector<double> lengths_along(const std::vector<Point3>& points, size_t first, size_t last) {
  std::vector<double> along = {0};
  for (size_t i = first; i < last; ++i) along.push_back(along.back() + length(points[i + 1] - points[i]));
  return along;
}

// The point at a share of the distance from point `first` to point `last`, 0 to 1.
inline Point3 point_along(const std::vector<Point3>& points, size_t first, size_t last, double share) {
  const std::vector<double> along = lengths_along(points, first, last);
  const double wanted = share * along.back();
  for (size_t i = 0; i + 1 < along.size(); ++i) {
    if (wanted > along[i + 1] && i + 2 < along.size()) continue;
    const double step = along[i + 1] - along[i];
    const double t = step > 0 ? std::clamp((wanted - along[i]) / step, 0.0, 1.0) : 0;
    return (1 - t) * points[first + i] + t * points[first + i + 1];
  }
  return points[first];
}

}  // namespace sinew
#endif
