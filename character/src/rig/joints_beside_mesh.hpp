// SPDX-License-Identifier: MIT
// Whether a point lies in a mesh, by rays along the axes.
#ifndef SINEW_CHARACTER_RIG_JOINTS_BESIDE_MESH_HPP
#define SINEW_CHARACTER_RIG_JOINTS_BESIDE_MESH_HPP

#include "sinew_formats/character.hpp"

namespace sinew {

// In how many of the six directions along the axes a ray from `p` meets a face (as a fan of triangles).
int directions_with_mesh(const Character& character, const Vec3& p);
constexpr int kMostHitsOutside = 2;  // directions in which a point outside may see the mesh

}  // namespace sinew
#endif
