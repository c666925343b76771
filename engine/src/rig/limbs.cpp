// SPDX-License-Identifier: MIT
// Votes of a limb's joints, counted together.
#include "rig/limbs.hpp"

namespace sinew::rigging {
namespace {

constexpr int32_t kClearSide = side_share(250);

// The same joint of another limb.
uint8_t class_in(LimbClass limb, uint8_t c) {
  const LimbClass now = limb_of(c);
  if (now == LimbClass::kNone || now == limb) return c;
  switch (limb) {
    case LimbClass::kTail:
      return kClassTail;
    case LimbClass::kEar:
      return kClassEar;
    case LimbClass::kHair:
      return kClassHair;
    case LimbClass::kLeg:
      return now == LimbClass::kArm ? static_cast<uint8_t>(c + (kClassHip - kClassClavicle)) : c;
    default:
      return now == LimbClass::kLeg && c != kClassToe ? static_cast<uint8_t>(c - (kClassHip - kClassClavicle)) : c;
  }
}
static_assert(kClassHip - kClassClavicle == kClassFoot - kClassHand &&
                  kClassThigh - kClassUpperArm == kClassFoot - kClassHand,
              "an arm's joints and a leg's follow each other alike");

}  // namespace

LimbClass limb_of(uint32_t joint_class) {
  if (joint_class >= kClassClavicle && joint_class <= kClassHand) return LimbClass::kArm;
  if (joint_class >= kClassHip && joint_class <= kClassToe) return LimbClass::kLeg;
  if (joint_class == kClassTail) return LimbClass::kTail;
  if (joint_class == kClassEar) return LimbClass::kEar;
  return joint_class == kClassHair ? LimbClass::kHair : LimbClass::kNone;
}

bool continues_limb(uint32_t from, uint32_t to) {
  const bool arm = from >= kClassClavicle && from <= kClassForearm && to >= kClassUpperArm && to <= kClassHand;
  return arm || (from >= kClassHip && from <= kClassCalf && to >= kClassThigh && to <= kClassFoot);
}

bool leaves_limb(uint32_t from, uint32_t to) {
  const LimbClass limb = limb_of(to);
  return (limb == LimbClass::kArm || limb == LimbClass::kLeg) && limb_of(from) >= LimbClass::kTail &&
         limb_of(from) != LimbClass::kNone;
}

bool lies_across(const FoldedNode& a, const FoldedNode& b) {
  if (!is_paired_class(a.joint_class) || !is_paired_class(b.joint_class)) return false;
  return (a.at.x > kClearSide && b.at.x < -kClearSide) || (a.at.x < -kClearSide && b.at.x > kClearSide);
}

SINEW_RARE void settle_limbs(LimbVotes& votes, FoldedTree* tree) {
  uint32_t order[kMaxFoldedJoints], first[kMaxFoldedJoints], count = 0;
  int64_t across[kMaxFoldedJoints] = {};
  order[count++] = tree->root;
  for (uint32_t i = 0; i < count; ++i) {
    const uint32_t j = order[i];
    const FoldedNode& node = tree->nodes[j];
    const bool goes_on = node.parent >= 0 && limb_of(node.joint_class) != LimbClass::kNone &&
                         limb_of(tree->nodes[node.parent].joint_class) != LimbClass::kNone;
    first[j] = goes_on ? first[node.parent] : j;
    across[first[j]] += node.at.x;
    for (uint32_t k = 0; k < kLimbs && goes_on; ++k) votes[first[j]][k] += votes[j][k];
    for (uint32_t k = 0; k < tree->count; ++k)
      if (tree->nodes[k].parent == static_cast<int16_t>(j)) order[count++] = k;
  }
  for (uint32_t i = 0; i < count; ++i) {
    FoldedNode& node = tree->nodes[order[i]];
    const uint32_t limb = first[order[i]];
    uint32_t best = 0;
    for (uint32_t k = 1; k < kLimbs; ++k) best = votes[limb][k] > votes[limb][best] ? k : best;
    if (votes[limb][best] > 0) node.joint_class = class_in(static_cast<LimbClass>(best), node.joint_class);
    if (!tree->mirrored && is_paired_class(node.joint_class)) node.side = across[limb] >= 0 ? 1 : -1;
  }
}

}  // namespace sinew::rigging
