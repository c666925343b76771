// SPDX-License-Identifier: MIT
// Fingers for the hands of a skeleton, through sinew_rig_details() of sinew/rig.h.
#ifndef SINEW_CHARACTER_PREDICT_HANDS_HPP
#define SINEW_CHARACTER_PREDICT_HANDS_HPP

#include "sinew_character/predict/predict_skeleton.hpp"

namespace sinew {

inline bool is_finger_class(uint8_t joint_class) {
  return joint_class >= SINEW_CLASS_THUMB && joint_class <= SINEW_CLASS_PINKY;
}

// Adds finger joints to a skeleton in the mesh of `character`, predicted or read: as sinew_rig_details() says, named after
// the hand. Its seconds grow.
//   hands    model of sinew_rig_model_open(), made for hands
//   options  up_axis and kernel count
// Returns how many hands got fingers. Throws Error with the character's name, and OutOfMemory; `skeleton` is untouched then.
size_t predict_hands(const Character& character, const sinew_model& hands, const SkeletonOptions& options,
                     PredictedSkeleton* skeleton);

}  // namespace sinew
#endif
