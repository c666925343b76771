// SPDX-License-Identifier: MIT
// Fingers of a skeleton that is put into a mesh, where the mesh's are.
#ifndef SINEW_CHARACTER_PREDICT_FIT_FINGERS_HPP
#define SINEW_CHARACTER_PREDICT_FIT_FINGERS_HPP

#include <cstddef>
#include <optional>
#include <vector>

#include "sinew_character/predict/fit_skeleton.hpp"
#include "sinew_character/predict/predict_skeleton.hpp"

namespace sinew {

// Whether names say that some joints are fingers.
bool has_fingers(const std::vector<Joint>& joints);
bool is_lone_hand(const PredictedSkeleton& skeleton);  // fingers, a hand, at most a forearm

// Fingers of the fitted skeleton (by names) go to those of the found one (by classes), of the hand that is nearest and no farther than its fingers are long; what such a finger has
// more at its root lies in the palm. Fingers that were not found stay. Returns how many were.
size_t fit_fingers(const PredictedSkeleton& found, FittedSkeleton* fitted);

// A hand's skeleton put where a lone hand was found: turned, scaled and moved as a whole by its fingers, then these as above.
// nullopt: fewer than three fingers are in both.
std::optional<FittedSkeleton> fit_lone_hand(const std::vector<Joint>& own, const PredictedSkeleton& found);

}  // namespace sinew
#endif
