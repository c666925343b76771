// SPDX-License-Identifier: MIT
// Confidences of limbs' joints to a probability.
#include "sinew_character/predict/limb_doubts.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "predict/limbs.hpp"
#include "predict/mirror_plane.hpp"

namespace sinew {
namespace {

constexpr double kConstant = -3.97, kUnsure = 2.88, kPerDoubling = 1.88;

bool is_class(const PredictedSkeleton& skeleton, int joint, uint8_t wanted) {
  return skeleton.classes[static_cast<size_t>(joint)] == wanted && skeleton.ends[static_cast<size_t>(joint)] == 0;
}

float doubt_of(const PredictedSkeleton& skeleton, const Limb& limb) {
  double joints = 0, unsure = 0;
  for (const int j : limb.joints) {
    const auto i = static_cast<size_t>(j);
    if (skeleton.ends[i] != 0) continue;
    ++joints;
    unsure += 1 - static_cast<double>(skeleton.confidence[i]);
  }
  const double score = kConstant + kUnsure * unsure / std::max(joints, 1.0) +
                       kPerDoubling * std::log2(std::max(static_cast<double>(skeleton.spread), 1e-4) / 0.05);
  return static_cast<float>(1 / (1 + std::exp(-score)));
}

// Arms and legs are called by the bone that begins them, not by the clavicle or hip before it.
int called_by(const PredictedSkeleton& skeleton, const Limb& limb) {
  for (const int j : limb.joints)
    if (is_class(skeleton, j, SINEW_CLASS_UPPER_ARM) || is_class(skeleton, j, SINEW_CLASS_THIGH)) return j;
  return limb.joints.front();
}

}  // namespace

std::vector<LimbDoubt> limb_doubts(const PredictedSkeleton& skeleton) {
  // Sides are told by where joints lie across the mirror plane.
  const MirrorPlane plane(skeleton);
  LabelledSkeleton labelled = {skeleton.joints, skeleton.classes, skeleton.ends};
  for (Joint& joint : labelled.joints) joint.position.x = plane.distance(joint.position);
  const Limbs limbs = find_limbs(labelled, 0, 0);
  std::vector<LimbDoubt> doubts;
  for (const Limb& limb : limbs.limbs) {
    if (limb.kind == LimbKind::kTrunk || limb.joints.empty()) continue;
    LimbDoubt one;
    one.joints = limb.joints;
    one.joint = called_by(skeleton, limb);
    one.name = skeleton.joints[static_cast<size_t>(one.joint)].name;
    one.doubt = doubt_of(skeleton, limb);
    doubts.push_back(std::move(one));
  }
  return doubts;
}

std::vector<LimbDoubt> doubtful_limbs(const PredictedSkeleton& skeleton) {
  std::vector<LimbDoubt> doubts = limb_doubts(skeleton);
  std::erase_if(doubts, [](const LimbDoubt& one) { return one.doubt < kDoubtfulLimb; });
  std::stable_sort(doubts.begin(), doubts.end(),
                   [](const LimbDoubt& a, const LimbDoubt& b) { return a.doubt > b.doubt; });
  return doubts;
}

std::string doubts_text(const std::vector<LimbDoubt>& limbs) {
  std::string text;
  for (const LimbDoubt& one : limbs) text += (text.empty() ? "warning: doubtful: " : ", ") + one.name;
  return text;
}

}  // namespace sinew
