// SPDX-License-Identifier: MIT
// The corrected poses, one function a method.
#ifndef SINEW_DEFORM_CORRECTION_HPP
#define SINEW_DEFORM_CORRECTION_HPP

#include "deform/posed_joints.hpp"

namespace sinew::deform {

struct PoseCounts {
  uint32_t active_tetrahedra = 0, inverted_tetrahedra = 0;
};

// Each fills positions [V] with the posed vertices, the common scale divided out. The matrices are rotations (posed.rigid). Works
// with a measuring arena; scratch is released. Returns SINEW_OK or SINEW_ERROR_WORKSPACE.
sinew_status pose_volume(const PosedJoints& posed, Arena& arena, Vec3d* positions, PoseCounts* counts);
sinew_status pose_delta_mush(const PosedJoints& posed, Arena& arena, Vec3d* positions);

// The published correction; the room `published` defines both functions.
sinew_status pose_published(const PosedJoints& posed, Arena& arena, Vec3d* positions, PoseCounts* counts);
// Replaces the rows of all nodes: the nearest bone and those beside it, by inverse squared distances, as SINEW_METHOD_DISTANCE weighs
// vertices. Joints without weight in the skin take none. Works with a measuring arena. Returns SINEW_OK or SINEW_ERROR_WORKSPACE.
sinew_status weigh_nodes_by_distance(Arena& arena, DeformRest* rest);

}  // namespace sinew::deform
#endif
