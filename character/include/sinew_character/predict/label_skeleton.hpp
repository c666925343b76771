// SPDX-License-Identifier: MIT
// A file's skeleton with the classes of its joints, as a predicted one has them.
#ifndef SINEW_CHARACTER_LABEL_SKELETON_HPP
#define SINEW_CHARACTER_LABEL_SKELETON_HPP

#include <vector>

#include "sinew_character/predict/fit_skeleton.hpp"
#include "sinew_character/predict/predict_skeleton.hpp"

namespace sinew {

// By names: joint_verdicts(); controls, slots, fingers and faces are details. Leaves
// called ends or tips are bone ends.
LabelledSkeleton label_skeleton(const std::vector<Joint>& joints);
LabelledSkeleton label_skeleton(const PredictedSkeleton& skeleton);

// A file's skeleton in the place of a predicted one: parents first, partners where it is its own mirror image, confidence
// 1. Throws Error for a skeleton without joints or with a cycle.
PredictedSkeleton skeleton_from_joints(const std::vector<Joint>& joints);

}  // namespace sinew
#endif
