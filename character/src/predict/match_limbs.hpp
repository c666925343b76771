// SPDX-License-Identifier: MIT
// Which chains, and which of their joints, are the same in two skeletons.
#ifndef SINEW_CHARACTER_PREDICT_MATCH_LIMBS_HPP
#define SINEW_CHARACTER_PREDICT_MATCH_LIMBS_HPP

#include <cstdint>
#include <vector>

#include "predict/limbs.hpp"
#include "predict/turn.hpp"
#include "sinew_formats/base/joint_tree.hpp"

namespace sinew {

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
  LimbMatches(const LabelledSkeleton& mine, const LabelledSkeleton& other, uint32_t across);

  const std::vector<MatchedLimb>& limbs() const { return limbs_; }
  int pelvis() const { return pelvis_; }  // of mine, -1 without one
  // Root of the mean square left by the best scale and shift, share of the other's size; infinite for too few matches.
  double misfit(Similar* best) const;

 private:
  std::vector<MatchedLimb> limbs_;
  int pelvis_ = -1;
  double other_size_ = 0;
};

}  // namespace sinew
#endif
