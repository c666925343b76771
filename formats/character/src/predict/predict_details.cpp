// SPDX-License-Identifier: MIT
// Details in their order: fingers first, since props hang on hands.
#include "sinew_character/predict_details.hpp"

#include "sinew_character/predict_face.hpp"
#include "sinew_character/predict_hands.hpp"

namespace sinew {

std::vector<std::string> predict_details(const Character& character, SkeletonDetail detail, const sinew_model& hands,
                                         const SkeletonOptions& options, PredictedSkeleton* skeleton) {
  std::vector<std::string> notes;
  if (detail == SkeletonDetail::kBody) return notes;
  if (predict_hands(character, hands, options, skeleton) == 0)
    notes.push_back("no hand with fingers that can be told apart");
  if (detail != SkeletonDetail::kFull) return notes;
  if (predict_face(character, options, skeleton) == 0)
    notes.push_back("no head with eyes that are parts of their own, so no joints of a face");
  predict_props(character, options, skeleton);
  return notes;
}

}  // namespace sinew
