// SPDX-License-Identifier: MIT
// Joint classes in which skeletons of all makers are compared and predicted.
#ifndef SINEW_VOTES_JOINT_CLASS_HPP
#define SINEW_VOTES_JOINT_CLASS_HPP

#include <stdint.h>

namespace sinew::rigging {

// Front legs are arms, hind legs are legs. Numbers are in models and tables; never reused.
enum JointClass : uint8_t {
  kClassPelvis,
  kClassSpine,
  kClassNeck,
  kClassHead,
  kClassClavicle,
  kClassUpperArm,
  kClassForearm,
  kClassHand,
  kClassHip,
  kClassThigh,
  kClassCalf,
  kClassFoot,
  kClassToe,
  kClassTail,
  kClassWing,
  kClassEar,
  kClassHair,
  kClassOther,
};
constexpr uint32_t kJointClasses = 18;
constexpr uint32_t kClassTip = 18;  // the end of a bone that has no joint there
constexpr uint32_t kEndClasses = 19;

// Joints of these come in mirrored pairs.
constexpr bool is_paired_class(uint32_t c) { return (c >= kClassClavicle && c <= kClassToe) || c == kClassEar; }
// Joints of these stand in chains, any number of them.
constexpr bool is_chain_class(uint32_t c) {
  return c == kClassSpine || c == kClassNeck || c == kClassTail || c == kClassHair || c == kClassWing ||
         c == kClassOther;
}

}  // namespace sinew::rigging
#endif
