// SPDX-License-Identifier: MIT
// The classes of joints that each limb and each kind of body has.
#include "votes/body_kind.hpp"

namespace sinew::rigging {

static_assert(kClassHip - kClassClavicle == kClassFoot - kClassHand &&
                  kClassThigh - kClassUpperArm == kClassFoot - kClassHand,
              "an arm's joints and a leg's follow each other alike");

LimbClass limb_of(uint32_t joint_class) {
  if (joint_class >= kClassClavicle && joint_class <= kClassHand) return LimbClass::kArm;
  if (joint_class >= kClassHip && joint_class <= kClassToe) return LimbClass::kLeg;
  if (joint_class == kClassTail) return LimbClass::kTail;
  if (joint_class == kClassEar) return LimbClass::kEar;
  return joint_class == kClassHair ? LimbClass::kHair : LimbClass::kNone;
}

uint8_t class_in_limb(LimbClass limb, uint8_t c) {
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

uint8_t class_in_body(BodyKind kind, uint8_t joint_class) {
  const LimbClass limb = limb_of(joint_class);
  const bool arm = limb == LimbClass::kArm, leg = limb == LimbClass::kLeg;
  switch (kind) {
    case BodyKind::kBird:
      return arm ? static_cast<uint8_t>(kClassWing) : joint_class;
    case BodyKind::kFish:
      return arm || leg ? static_cast<uint8_t>(kClassWing) : joint_class;
    case BodyKind::kSnake:
      return arm || leg || joint_class == kClassWing ? static_cast<uint8_t>(kClassSpine) : joint_class;
    case BodyKind::kManyLegged:
      return arm ? class_in_limb(LimbClass::kLeg, joint_class) : joint_class;
    default:
      return joint_class;
  }
}

void steer_classes(BodyKind kind, uint16_t* chances) {
  for (uint8_t c = 0; c < kJointClasses; ++c) {
    const uint8_t other = class_in_body(kind, c);
    if (other == c) continue;
    chances[other] = static_cast<uint16_t>(chances[other] + chances[c]);  // their sum is at most 2^15
    chances[c] = 0;
  }
}

}  // namespace sinew::rigging
