// SPDX-License-Identifier: MIT
// To which part of the body each vertex near a seam belongs.
#ifndef SINEW_CHARACTER_RIG_SEAM_HOMES_HPP
#define SINEW_CHARACTER_RIG_SEAM_HOMES_HPP

#include <cstdint>
#include <vector>

#include "bind/seam_surface.hpp"
#include "bind/skeleton_paths.hpp"
#include "sinew_character/bind/seams.hpp"

namespace sinew {

// Joint of the largest weight, the first of those that are equal; kNoHome without weight.
uint32_t home_joint(const std::vector<Influence>& row);

// Decides the homes of the welded vertices of a band anew.
//   band   welded vertices, ascending
//   homes  in/out [V] of welded vertices: each one's strongest joint, kNoHome without weights
void find_seam_homes(const SeamSurface& surface, const SkeletonPaths& paths, const WeightRows& rows,
                     const std::vector<uint32_t>& band, std::vector<uint32_t>* homes);

}  // namespace sinew
#endif
