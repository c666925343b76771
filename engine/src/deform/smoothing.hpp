// SPDX-License-Identifier: MIT
// Uniform Laplacian smoothing of a surface, for delta mush and for the end of the published method.
#ifndef SINEW_DEFORM_SMOOTHING_HPP
#define SINEW_DEFORM_SMOOTHING_HPP

#include "deform/rest.hpp"

namespace sinew::deform {

// Fills rest->border: vertices of edges with one triangle. edge_triangles [6 T] is scratch.
void find_borders(uint8_t* edge_triangles, DeformRest* rest);
// Half way to the mean of the neighbours, all at once; border vertices go to border neighbours alone. mask [U]: vertices that move,
// null = all. scratch [U].
void smooth(const DeformRest& rest, uint32_t rounds, const uint8_t* mask, Vec3d* scratch, Vec3d* positions);
// Fills rest->smooth from the rest pose; its second half is scratch.
void smooth_rest(DeformRest* rest);

}  // namespace sinew::deform
#endif
