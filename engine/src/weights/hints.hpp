// SPDX-License-Identifier: MIT
// Painted weights steer their surroundings (stage 9): what was painted minus what was predicted is spread over the
// mesh.
#ifndef SINEW_WEIGHTS_HINTS_HPP
#define SINEW_WEIGHTS_HINTS_HPP

#include "mesh/mesh.hpp"
#include "skeleton/skeleton.hpp"
#include "weights/rows.hpp"

namespace sinew {

// Changes `rows` around the vertices whose given row steers, and puts the given rows themselves in place. For every
// joint the difference r between the given and the predicted weight is held at the hinted vertices and solved for
// elsewhere in the part:
//   (L + S) x = S r at hints, 0 elsewhere
// with the cotangent Laplacian L and screening S, which lets x fall with distance. Rows become prediction + x,
// cut at 0. A vertex where no |x| reaches 1/1024 keeps its row bit by bit; a part without a hint is not touched.
// Joints that may get no weight are left out. Returns SINEW_OK, SINEW_ERROR_WORKSPACE or SINEW_ERROR_CANCELLED.
sinew_status steer_rows(const Mesh& mesh, const Skeleton& skeleton, const GivenRows& given, const Counts& counts,
                        const Progress& progress, Arena& arena, Rows* rows);

}  // namespace sinew
#endif
