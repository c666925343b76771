// SPDX-License-Identifier: MIT
// Details in their order: fingers first, since props hang on hands.
#include "sinew_character/predict/predict_details.hpp"

#include <algorithm>

#include "sinew_character/predict/predict_face.hpp"
#include "sinew_character/predict/predict_hands.hpp"

namespace sinew {
namespace {

// Hands that have fingers, but no thumb among them: a line each.
void say_thumbs(const PredictedSkeleton& skeleton, std::vector<std::string>* notes) {
  const auto is_finger = [&](size_t j) { return is_finger_class(skeleton.classes[j]); };
  std::vector<uint8_t> fingers(skeleton.joints.size(), 0), thumbs(skeleton.joints.size(), 0);
  for (size_t j = 0; j < skeleton.joints.size(); ++j) {
    const int parent = skeleton.joints[j].parent;
    if (parent < 0 || !is_finger(j) || is_finger(static_cast<size_t>(parent))) continue;
    (skeleton.classes[j] == SINEW_CLASS_THUMB ? thumbs : fingers)[static_cast<size_t>(parent)] = 1;
  }
  for (size_t j = 0; j < skeleton.joints.size(); ++j)
    if (fingers[j] != 0 && thumbs[j] == 0) notes->push_back(skeleton.joints[j].name + ": no thumb was found");
}

}  // namespace

std::vector<std::string> predict_details(const Character& character, SkeletonDetail detail, const sinew_model& hands,
                                         const SkeletonOptions& options, PredictedSkeleton* skeleton) {
  std::vector<std::string> notes;
  if (detail == SkeletonDetail::kBody) return notes;
  const bool fingers = std::any_of(skeleton->classes.begin(), skeleton->classes.end(), is_finger_class);
  if (!fingers && predict_hands(character, hands, options, skeleton) == 0)
    notes.push_back("no hand with fingers that can be told apart");
  say_thumbs(*skeleton, &notes);
  if (detail != SkeletonDetail::kFull) return notes;
  if (predict_face(character, options, skeleton) == 0)
    notes.push_back("no head with eyes that are parts of their own, so no joints of a face");
  predict_props(character, options, skeleton);
  return notes;
}

}  // namespace sinew
