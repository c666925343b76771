// SPDX-License-Identifier: MIT
// Parts of a hand: the classes of a hands network, at the indices of JointClass.
#ifndef SINEW_DETAILS_HAND_CLASS_HPP
#define SINEW_DETAILS_HAND_CLASS_HPP

#include "votes/joint_class.hpp"

namespace sinew::rigging {

constexpr uint32_t kFingers = 5;       // thumb, index, middle, ring, pinky
constexpr uint32_t kFingerJoints = 3;  // of a finger, from the palm outward

// Numbers are in models; never reused. Ends of bones have kClassTip as well.
enum HandClass : uint8_t {
  kHandRest = 0,  // no part of the hand: forearm, sleeve, what the hand hangs beside
  kHandPalm = 1,  // its joint is the wrist
  kHandFinger = 2,
  kHandNothing = 17,  // kClassOther, which is not taught
};
constexpr uint8_t finger_class(uint32_t finger, uint32_t joint) {
  return static_cast<uint8_t>(kHandFinger + kFingerJoints * finger + joint);
}
static_assert(finger_class(kFingers - 1, kFingerJoints - 1) < kHandNothing && kHandNothing < kJointClasses,
              "the classes have room in the rows of a rig network");

}  // namespace sinew::rigging
#endif
