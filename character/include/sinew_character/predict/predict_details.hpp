// SPDX-License-Identifier: MIT
// What a skeleton may have besides a body: fingers, a face, and what its hands hold.
#ifndef SINEW_CHARACTER_PREDICT_DETAILS_HPP
#define SINEW_CHARACTER_PREDICT_DETAILS_HPP

#include <string>
#include <vector>

#include "sinew_character/predict/predict_skeleton.hpp"

namespace sinew {

// Eyes and a jaw for the heads of a skeleton, and joints for what its hands hold, through sinew_rig_details() of
// sinew/rig.h.
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

// Fingers for the hands of a skeleton, through sinew_rig_details() of sinew/rig.h.
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

enum class SkeletonDetail : uint8_t {
  kBody = 0,
  kHands,  // fingers, where the mesh shows some
  kFull    // eyes that are loose balls, a jaw and props, too
};

// Adds the joints of this detail to a skeleton in the mesh of `character`, as predict_hands(), predict_face() and predict_props()
// do; with kBody none.
//   hands    model of sinew_rig_model_open(), made for hands; not looked at for kBody
//   options  up_axis and kernel count
// Returns a line for the user for what the mesh does not show. Throws Error with the character's name, and OutOfMemory.
std::vector<std::string> predict_details(const Character& character, SkeletonDetail detail, const sinew_model& hands,
                                         const SkeletonOptions& options, PredictedSkeleton* skeleton);

}  // namespace sinew
#endif
