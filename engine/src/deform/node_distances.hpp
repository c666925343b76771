// SPDX-License-Identifier: MIT
// Weights of a lattice's nodes by their distances to bones, for the published correction.
#ifndef SINEW_DEFORM_NODE_DISTANCES_HPP
#define SINEW_DEFORM_NODE_DISTANCES_HPP

#include "deform/rest.hpp"

namespace sinew::deform {

// Replaces the rows of all nodes: the nearest bone and those beside it, by inverse squared distances, as SINEW_METHOD_DISTANCE weighs
// vertices. Joints without weight in the skin take none. Works with a measuring arena. Returns SINEW_OK or SINEW_ERROR_WORKSPACE.
sinew_status weigh_nodes_by_distance(Arena& arena, DeformRest* rest);

}  // namespace sinew::deform
#endif
