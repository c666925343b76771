// SPDX-License-Identifier: MIT
// Recognizes a mesh that is only a hand.
#ifndef SINEW_CHARACTER_LONE_HAND_HPP
#define SINEW_CHARACTER_LONE_HAND_HPP

#include <optional>

#include "sinew_character/predict/predict_skeleton.hpp"

namespace sinew {

struct LoneHand {
  PredictedSkeleton skeleton;  // LeftForeArm if the mesh has it, LeftHand, LeftHandThumb1 ..., or Right
  bool right = false, thumb = false;
  bool side_known = false;  // false: a flat hand could be a left one or, turned over, a right one
  float agreement = 0;      // 0..1: agreement of the votes for the fingers' joints, mean of five fingers
};

// Looks for fingers in both directions of the mesh's longest axis, palm up and down, for a left and a right hand.
// Returns the orientation with the most agreement, if that is high enough for a hand.
//   hands    model for hands from sinew_rig_model_open()
//   options  uses kernel
// Throws Error with the character's name, and OutOfMemory.
std::optional<LoneHand> find_lone_hand(const Character& character, const sinew_model& hands,
                                       const SkeletonOptions& options);

}  // namespace sinew
#endif
