// SPDX-License-Identifier: MIT
// Weights by distance alone, for comparison: the published way, in place of stage 4.
#ifndef SINEW_HEAT_DISTANCES_HPP
#define SINEW_HEAT_DISTANCES_HPP

#include "heat/heat.hpp"

namespace sinew {

// Fills fields->field[kFieldRule] with weights by the inverse square of the distance to bones. The vertices that are nearest to a bone are a sub-mesh: of
// the bones, its own, the one above it and those below it have weight there. Neither the surface nor what lies between is looked at.
//   source_joints  [J] from choose_source_joints(): bones that may have weight
//   fields         allocated by the caller with the same counts; the other fields stay undefined
// Returns SINEW_OK or SINEW_ERROR_WORKSPACE. The same bytes on every platform.
sinew_status weigh_by_distance(const Mesh& mesh, const Skeleton& skeleton, const uint8_t* source_joints,
                               const Counts& counts, Arena& arena, HeatFields* fields);

}  // namespace sinew
#endif
