// SPDX-License-Identifier: MIT
// The user's say about style (stage 9): whether loose parts are rigid, and how softly weights blend. Artists bind the
// same geometry both ways, so no network can always guess it.
#ifndef SINEW_WEIGHTS_STYLE_HPP
#define SINEW_WEIGHTS_STYLE_HPP

#include "heat/heat.hpp"
#include "mesh/mesh.hpp"
#include "weights/rows.hpp"

namespace sinew {

// Every part gets one joint: the one with the largest sum of weights over its vertices (ties: the lower
// joint).
sinew_status make_parts_rigid(const Mesh& mesh, const Counts& counts, Arena& arena, Rows* rows);
// Parts where one joint has at least 19/20 of the weight, but not in the heat field, get the heat field's rows.
sinew_status make_parts_soft(const Mesh& mesh, const HeatField& heat, const Counts& counts, Arena& arena, Rows* rows);

// Differences of logits [count] from their largest are divided by softness / 100: 200 blends twice as softly.
void soften_logits(const int16_t* logits, const uint16_t* joints, uint32_t count, uint32_t softness_percent,
                   int16_t* out);

}  // namespace sinew
#endif
