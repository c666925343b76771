// SPDX-License-Identifier: MIT
// Corrects a skeleton after it was fitted into a mesh: its fingers move to those of the mesh, limbs stay in the mesh.
#ifndef SINEW_CHARACTER_PREDICT_FIT_DETAILS_HPP
#define SINEW_CHARACTER_PREDICT_FIT_DETAILS_HPP

#include <cstddef>
#include <optional>
#include <vector>

#include "sinew_character/predict/fit_skeleton.hpp"
#include "sinew_character/predict/predict_skeleton.hpp"

namespace sinew {

// Returns whether some joints are fingers by name.
bool has_fingers(const std::vector<Joint>& joints);
bool is_lone_hand(const PredictedSkeleton& skeleton);  // fingers, a hand, at most a forearm

// Fingers of the fitted skeleton (by names) go to those of the found one (by classes), of the hand that is nearest and no farther than its fingers are long; what such a finger has
// more at its root lies in the palm. Fingers that were not found stay. Returns how many were.
size_t fit_fingers(const PredictedSkeleton& found, FittedSkeleton* fitted);

// Fits a hand's skeleton to a lone hand: rotates, scales and moves the whole by its fingers, then fits these as
// above. nullopt: fewer than three fingers are in both.
std::optional<FittedSkeleton> fit_lone_hand(const std::vector<Joint>& own, const PredictedSkeleton& found);

// Bones of chains that nothing of the mesh spoke for (FitHow::kCarried) become so short, by tenths to a tenth, that they end in it or within
// 2 % of its longest side from a vertex; both of a mirrored pair alike. Parents of matched joints are unchanged.
// Returns the number of shortened bones.
size_t keep_inside(const Character& mesh, FittedSkeleton* fitted);

}  // namespace sinew
#endif
