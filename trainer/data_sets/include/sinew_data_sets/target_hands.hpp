// SPDX-License-Identifier: MIT
// The hands that a rigged character teaches: their fingers, joint by joint.
#ifndef SINEW_DATA_SETS_TARGET_HANDS_HPP
#define SINEW_DATA_SETS_TARGET_HANDS_HPP

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sinew_data_sets/target_skeleton.hpp"
#include "sinew_formats/character.hpp"

namespace sinew {

struct TargetFinger {
  uint32_t finger = 0;                           // 0 thumb, 1 index, 2 middle, 3 ring, 4 pinky
  std::vector<uint32_t> joints;                  // of the character, from the palm outward: 1 to 3
  std::vector<std::array<double, 3>> positions;  // of these
  std::optional<std::array<double, 3>> end;      // of the last bone
};

struct TargetHand {
  uint32_t joint = 0;  // of the character: the wrist
  int elbow = -1;      // joint above the wrist at another position, -1 without one
  bool right = false;
  bool clear = true;                  // false: joints that move several fingers at once, or fewer than three fingers
  std::vector<TargetFinger> fingers;  // by finger; none: a hand whose fingers its maker did not rig
  double length = 0;                  // from the wrist to the farthest of what it moves (98 % quantile)
};

// Every joint of class hand that moves something, outermost where one hangs on another. Joints of a finger that move
// nothing are left out, and metacarpals, but for the thumb's, are part of the palm. Throws Error where
// target_skeleton() does.
std::vector<TargetHand> target_hands(const Character& character);

// A body's target with the fingers of its clear hands behind it, their bone ends last: "full" bodies for the eye.
TargetSkeleton with_fingers(const Character& character, TargetSkeleton body);

}  // namespace sinew
#endif
