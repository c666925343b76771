// SPDX-License-Identifier: MIT
// What a skeleton may have besides a body: fingers, a face, and what its hands hold.
#ifndef SINEW_CHARACTER_PREDICT_DETAILS_HPP
#define SINEW_CHARACTER_PREDICT_DETAILS_HPP

#include <string>
#include <vector>

#include "sinew_character/predict/predict_skeleton.hpp"

namespace sinew {

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
