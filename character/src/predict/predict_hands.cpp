// SPDX-License-Identifier: MIT
// A skeleton's arrays go through sinew_rig_details(); longer ones come back.
#include "sinew_character/predict/predict_hands.hpp"

#include <set>

#include "skeleton_arrays.hpp"

namespace sinew {

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

}  // namespace sinew
