// SPDX-License-Identifier: MIT
// The classes of joints that each kind of body has.
#include "rig/body_kind.hpp"

#include "rig/limbs.hpp"

namespace sinew::rigging {

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
