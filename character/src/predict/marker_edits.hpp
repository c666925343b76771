// SPDX-License-Identifier: MIT
// A marker: where a joint of a known name is, whether the prediction has found it or not.
#ifndef SINEW_CHARACTER_PREDICT_MARKER_EDITS_HPP
#define SINEW_CHARACTER_PREDICT_MARKER_EDITS_HPP

#include <vector>

#include "sinew_character/predict/edit_skeleton.hpp"

namespace sinew {

// The joints that are to be added for a marker (kAt) that no joint is called like: its own, and those between it and the body that are
// missing too, at their usual shares of the way. Throws Error for a name that no chain has, or a skeleton without what the chain hangs on.
std::vector<SkeletonEdit> marker_edits(const std::vector<Joint>& joints, const SkeletonEdit& marker);

}  // namespace sinew
#endif
