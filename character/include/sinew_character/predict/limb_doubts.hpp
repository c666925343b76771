// SPDX-License-Identifier: MIT
// Which limbs of a predicted skeleton may be wrong, by what its votes say of themselves.
#ifndef SINEW_CHARACTER_LIMB_DOUBTS_HPP
#define SINEW_CHARACTER_LIMB_DOUBTS_HPP

#include <string>
#include <vector>

#include "sinew_character/predict/predict_skeleton.hpp"

namespace sinew {

struct LimbDoubt {
  std::vector<int> joints;  // from the body outwards, bone ends too
  int joint = 0;            // that it is called by
  std::string name;         // of that: LeftArm, RightUpLeg, Tail
  float doubt = 0;          // how likely it is wrong, 0..1
};

// Limbs of a skeleton that was predicted by votes: what hangs on its trunk, in the order of kinds. A limb is wrong whose
// joints are 5 % of the longest side off in the mean, or one of them 10 %: logistic, of how sure the votes are of its joints'
// positions and of the spread of all, fitted on families that the votes were not trained on (trainer/configs/RESULTS.md).
std::vector<LimbDoubt> limb_doubts(const PredictedSkeleton& skeleton);

// From here on the user is told.
constexpr float kDoubtfulLimb = 0.4f;
// The limbs above that, most doubtful first.
std::vector<LimbDoubt> doubtful_limbs(const PredictedSkeleton& skeleton);
// One line, a warning; empty without any.
std::string doubts_text(const std::vector<LimbDoubt>& limbs);

}  // namespace sinew
#endif
