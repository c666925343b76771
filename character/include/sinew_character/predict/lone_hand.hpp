// SPDX-License-Identifier: MIT
// A mesh that is a hand and nothing else.
#ifndef SINEW_CHARACTER_LONE_HAND_HPP
#define SINEW_CHARACTER_LONE_HAND_HPP

#include <optional>

#include "sinew_character/predict/predict_skeleton.hpp"

namespace sinew {

struct LoneHand {
  PredictedSkeleton skeleton;  // LeftForeArm where there is one, LeftHand, LeftHandThumb1 ..., or Right
  bool right = false, thumb = false;
  bool side_known = false;  // a flat hand is a left one and, turned over, a right one
  float agreement = 0;      // 0..1: how well the votes of the fingers' joints agree, mean of five fingers
};

// Looks for fingers along the mesh's longest axis, either way, palm up and down, of a left and of a right hand; the way with the most
// agreement is taken, and it is a hand if that is enough.
//   hands    model of sinew_rig_model_open(), made for hands
//   options  kernel counts
// Throws Error with the character's name, and OutOfMemory.
std::optional<LoneHand> find_lone_hand(const Character& character, const sinew_model& hands,
                                       const SkeletonOptions& options);

}  // namespace sinew
#endif
