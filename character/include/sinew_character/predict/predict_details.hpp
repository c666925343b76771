// SPDX-License-Identifier: MIT
// Details of a skeleton: fingers, a face, and objects in its hands.
#ifndef SINEW_CHARACTER_PREDICT_DETAILS_HPP
#define SINEW_CHARACTER_PREDICT_DETAILS_HPP

#include <string>
#include <vector>

#include "sinew_character/predict/predict_skeleton.hpp"

namespace sinew {

// Eyes and a jaw for the heads of a skeleton, and joints for objects in its hands, by sinew_rig_details() of
// sinew/rig.h.
inline bool is_face_class(uint8_t joint_class) {
  return joint_class == SINEW_CLASS_EYE || joint_class == SINEW_CLASS_JAW;
}
inline bool is_prop_class(uint8_t joint_class) { return joint_class == SINEW_CLASS_PROP; }

// Adds joints of eyes and jaws to a skeleton in the mesh of `character`, predicted or read, by sinew_rig_details().
// Adds to its seconds.
//   options  uses up_axis
// Returns the number of new joints without bone ends. Throws Error with the character's name, and OutOfMemory;
// `skeleton` is then untouched.
size_t predict_face(const Character& character, const SkeletonOptions& options, PredictedSkeleton* skeleton);
// The same for joints of props. Returns the number of new joints.
size_t predict_props(const Character& character, const SkeletonOptions& options, PredictedSkeleton* skeleton);

// Fingers for the hands of a skeleton, by sinew_rig_details() of sinew/rig.h.
inline bool is_finger_class(uint8_t joint_class) {
  return joint_class >= SINEW_CLASS_THUMB && joint_class <= SINEW_CLASS_PINKY;
}

// Adds finger joints to a skeleton in the mesh of `character`, predicted or read, by sinew_rig_details(), named after
// the hand. Adds to its seconds.
//   hands    model for hands from sinew_rig_model_open()
//   options  uses up_axis and kernel
// Returns the number of hands that got fingers. Throws Error with the character's name, and OutOfMemory; `skeleton`
// is then untouched.
size_t predict_hands(const Character& character, const sinew_model& hands, const SkeletonOptions& options,
                     PredictedSkeleton* skeleton);

enum class SkeletonDetail : uint8_t {
  kBody = 0,
  kHands,  // fingers, where the mesh has them
  kFull    // also eyes that are separate spheres, a jaw and props
};

// Adds the joints of this detail to a skeleton in the mesh of `character`, as predict_hands(), predict_face() and predict_props()
// do; with kBody none.
//   hands    model for hands from sinew_rig_model_open(); unused for kBody
//   options  uses up_axis and kernel
// Returns a note for the user per detail that the mesh lacks. Throws Error with the character's name, and
// OutOfMemory.
std::vector<std::string> predict_details(const Character& character, SkeletonDetail detail, const sinew_model& hands,
                                         const SkeletonOptions& options, PredictedSkeleton* skeleton);

}  // namespace sinew
#endif
