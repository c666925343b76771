// SPDX-License-Identifier: MIT
// What kind of body a mesh has, by its user's word: which limbs it can have, and which of them are arms.
#ifndef SINEW_RIG_BODY_KIND_HPP
#define SINEW_RIG_BODY_KIND_HPP

#include "core/fixed.hpp"
#include "rig/joint_class.hpp"

namespace sinew::rigging {

// Numbers are those of SINEW_CATEGORY_* in sinew/rig.h, which says what they mean.
enum class BodyKind : uint8_t { kAny, kBiped, kQuadruped, kBird, kFish, kSnake, kManyLegged };
constexpr uint32_t kBodyKinds = 7;

// What a joint is in such a body: arms of birds and all limbs of fish are wings, snakes' limbs are spine, all limbs of
// the many-legged are legs. Other classes stay.
uint8_t class_in_body(BodyKind kind, uint8_t joint_class);

// Gives the chances of classes that such a body does not have to those that stand for them.
//   chances  in, out: one point's, [classes], kJointClasses or more
void steer_classes(BodyKind kind, uint16_t* chances);

}  // namespace sinew::rigging
#endif
