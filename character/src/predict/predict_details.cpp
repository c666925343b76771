// SPDX-License-Identifier: MIT
// Details of a skeleton, whose arrays go through sinew_rig_details() and come back longer: fingers first, since props hang on hands.
#include "sinew_character/predict/predict_details.hpp"

#include <algorithm>
#include <set>

#include "skeleton_arrays.hpp"

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

size_t predict_hands(const Character& character, const sinew_model& hands, const SkeletonOptions& options,
                     PredictedSkeleton* skeleton) {
  // Names here are longer than there, so only what is put behind them is taken: the hand's own name is left empty.
  SkeletonArrays arrays(character, *skeleton, "fingers", false);
  arrays.grow(character, options, SINEW_DETAIL_HANDS, &hands, skeleton);

  std::set<int> fingered;
  arrays.resize(skeleton);
  for (size_t j = 0; j < arrays.joint_count(); ++j) {
    if (!is_finger_class(arrays.joint_class(j)) || *arrays.name(j) == 0) continue;
    int hand = arrays.parent(j);
    while (is_finger_class(arrays.joint_class(static_cast<size_t>(hand))))
      hand = arrays.parent(static_cast<size_t>(hand));
    fingered.insert(hand);
    arrays.take(j, skeleton->joints[static_cast<size_t>(hand)].name + arrays.name(j), skeleton);
  }
  return fingered.size();
}

namespace {

// Lets the skeleton grow by one detail and returns how many joints there are more that are no bone ends.
size_t add_joints(const Character& character, const SkeletonOptions& options, const char* what, sinew_rig_detail detail,
                  PredictedSkeleton* skeleton) {
  const size_t before = skeleton->joints.size();
  SkeletonArrays arrays(character, *skeleton, what, true);
  arrays.grow(character, options, detail, nullptr, skeleton);
  size_t more = 0;
  arrays.resize(skeleton);
  for (size_t j = before; j < arrays.joint_count(); ++j) {
    arrays.take(j, arrays.name(j), skeleton);
    more += skeleton->ends[j] == 0 ? 1 : 0;
  }
  return more;
}

}  // namespace

size_t predict_face(const Character& character, const SkeletonOptions& options, PredictedSkeleton* skeleton) {
  return add_joints(character, options, "faces", SINEW_DETAIL_FACE, skeleton);
}

size_t predict_props(const Character& character, const SkeletonOptions& options, PredictedSkeleton* skeleton) {
  return add_joints(character, options, "props", SINEW_DETAIL_PROPS, skeleton);
}

}  // namespace sinew
