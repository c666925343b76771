// SPDX-License-Identifier: MIT
// Limbs by their joints' classes, and what kind of body a mesh has, by its user's word: which limbs it can have, and
// which of them are arms.
#ifndef SINEW_VOTES_BODY_KIND_HPP
#define SINEW_VOTES_BODY_KIND_HPP

#include "core/fixed.hpp"
#include "votes/joint_class.hpp"

namespace sinew::rigging {

// Numbers are those of SINEW_CATEGORY_* in sinew/rig.h, which says what they mean.
enum class BodyKind : uint8_t { kAny, kBiped, kQuadruped, kBird, kFish, kSnake, kManyLegged };
constexpr uint32_t kBodyKinds = 7;

// The limbs of a torso. Toes belong to a leg.
enum class LimbClass : uint8_t { kArm, kLeg, kTail, kEar, kHair, kNone };
constexpr uint32_t kLimbs = 5;
LimbClass limb_of(uint32_t joint_class);
// The same joint of another limb: the foot of an arm is a hand. Classes of no limb stay.
uint8_t class_in_limb(LimbClass limb, uint8_t joint_class);

// The class of a joint in such a body: arms of birds and all limbs of fish are wings, snakes' limbs are spine, all
// limbs of the many-legged are legs. Other classes stay.
uint8_t class_in_body(BodyKind kind, uint8_t joint_class);

// Gives the chances of classes that such a body does not have to those that represent them.
//   chances  in, out: one point's, [classes], kJointClasses or more
void steer_classes(BodyKind kind, uint16_t* chances);

}  // namespace sinew::rigging
#endif
