// SPDX-License-Identifier: MIT
// What the page is told of a skeleton, and the edits it asks for.
#ifndef SINEW_WEB_RIG_JSON_HPP
#define SINEW_WEB_RIG_JSON_HPP

#include <nlohmann/json.hpp>
#include <vector>

#include "rigs.hpp"
#include "sinew_character/predict/edit_skeleton.hpp"

namespace sinew::web {

// The present rig: {joints: [{name, parent, position, colour, side, end, partner, confidence}], predicted, editable, canUndo,
// canRedo}, and of one that can be edited {mirrored, axis, plane, spread, doubtful, seconds}, of a predicted one upAxis, which it
// is bound with. Of others nobody knows partners,
// ends and confidence: -1, false and 1.
nlohmann::json rig_json(const Rigs& rigs);

// From [{kind, joint, other, place}, ...], as SkeletonEdit has them.
std::vector<SkeletonEdit> read_edits(const nlohmann::json& edits);

}  // namespace sinew::web
#endif
