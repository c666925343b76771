// SPDX-License-Identifier: MIT
// The user's say about rows (stage 9): rows that were given, hints that steer what is around them, whether loose parts are
// rigid, and how softly weights blend.
#ifndef SINEW_WEIGHTS_USERS_SAY_HPP
#define SINEW_WEIGHTS_USERS_SAY_HPP

#include "heat/heat.hpp"
#include "mesh/mesh.hpp"
#include "skeleton/skeleton.hpp"
#include "weights/rows.hpp"

namespace sinew {

// `count` weights from index `first` on, in the format's own integer steps; floats in steps of 2^-16, at most 1 counts.
// False when one is negative or NaN, or all are 0.
bool read_row(const void* weights, uint32_t format, size_t first, uint32_t count, uint32_t* out);

// Gathers the given rows of the caller's vertices (rows of `influence_count` slots, checked beforehand) on welded
// vertices: the mean of what was given to the vertices welded there, hints alone where there is one. Locked rows
// without weight count as free.
void gather_given_rows(const Mesh& mesh, const uint8_t* locked, const uint8_t* hints, const uint16_t* joints,
                       const void* weights, uint32_t format, uint32_t influence_count, GivenRows* out);

// Changes `rows` around the vertices whose given row steers, and puts the given rows themselves in place. For every
// joint the difference r between the given and the predicted weight is held at the hinted vertices and solved for
// elsewhere in the part:
//   (L + S) x = S r at hints, 0 elsewhere
// with the cotangent Laplacian L and screening S, which lets x fall with distance. Rows become prediction + x,
// cut at 0. A vertex where no |x| reaches 1/1024 keeps its row bit by bit; a part without a hint is not touched.
// Joints that may get no weight are left out. Returns SINEW_OK, SINEW_ERROR_WORKSPACE or SINEW_ERROR_CANCELLED.
sinew_status steer_rows(const Mesh& mesh, const Skeleton& skeleton, const GivenRows& given, const Counts& counts,
                        const Progress& progress, Arena& arena, Rows* rows);

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
