// SPDX-License-Identifier: MIT
// The skeleton half of stage 1: checks, order, bones of the heat stage.
#ifndef SINEW_SKELETON_SKELETON_HPP
#define SINEW_SKELETON_SKELETON_HPP

#include "grid/grid_quantizer.hpp"
#include "mesh/mesh.hpp"

namespace sinew {

// Fills everything of an allocated skeleton but `source`.
// Returns SINEW_OK, SINEW_ERROR_NOT_FINITE, SINEW_ERROR_INDEX, SINEW_ERROR_HIERARCHY or SINEW_ERROR_NO_JOINT.
sinew_status build_skeleton(const sinew_skeleton& input, const Quantizer& quantizer, Skeleton* skeleton);
// Fills `source`, which needs the height of the welded mesh.
void find_sources(const Mesh& mesh, Skeleton* skeleton);

}  // namespace sinew
#endif
