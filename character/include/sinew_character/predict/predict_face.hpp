// SPDX-License-Identifier: MIT
// Eyes and a jaw for the heads of a skeleton, and joints for what its hands hold, through sinew_rig_details() of
// sinew/rig.h.
#ifndef SINEW_CHARACTER_PREDICT_FACE_HPP
#define SINEW_CHARACTER_PREDICT_FACE_HPP

#include "sinew_character/predict/predict_skeleton.hpp"

namespace sinew {

inline bool is_face_class(uint8_t joint_class) {
  return joint_class == SINEW_CLASS_EYE || joint_class == SINEW_CLASS_JAW;
}
inline bool is_prop_class(uint8_t joint_class) { return joint_class == SINEW_CLASS_PROP; }

// Adds joints of eyes and jaws to a skeleton in the mesh of `character`, predicted or read: as sinew_rig_details() says. Its
// seconds grow.
//   options  up_axis counts
// Returns how many joints there are more, bone ends not counted. Throws Error with the character's name, and OutOfMemory; `skeleton` is untouched
// then.
size_t predict_face(const Character& character, const SkeletonOptions& options, PredictedSkeleton* skeleton);
// The same for joints of props, as sinew_rig_details() says. Returns how many there are more.
size_t predict_props(const Character& character, const SkeletonOptions& options, PredictedSkeleton* skeleton);

}  // namespace sinew
#endif
