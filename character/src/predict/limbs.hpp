// SPDX-License-Identifier: MIT
// The chains of a labelled skeleton: trunk, arms, legs, tails and so on, each from the body outwards.
#ifndef SINEW_CHARACTER_PREDICT_LIMBS_HPP
#define SINEW_CHARACTER_PREDICT_LIMBS_HPP

#include <cstdint>
#include <vector>

#include "sinew_character/predict/fit_skeleton.hpp"

namespace sinew {

enum class LimbKind : uint8_t { kTrunk, kArm, kLeg, kTail, kWing, kEar, kHair, kOther };

struct Limb {
  LimbKind kind = LimbKind::kOther;
  int side = 0;             // 1, -1 or 0 for the middle, in the order of positions across the plane: 1 has the greater
  std::vector<int> joints;  // from the body outwards; the last may be a bone end
};

struct Limbs {
  std::vector<Limb> limbs;  // the trunk first, from the pelvis to the head, if there is one
  int pelvis = -1;          // joint, -1 without one
};

// `across` is the component that tells sides apart, counted from `plane`.
Limbs find_limbs(const LabelledSkeleton& skeleton, uint32_t across, double plane);

}  // namespace sinew
#endif
