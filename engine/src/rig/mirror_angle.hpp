// SPDX-License-Identifier: MIT
// Upright mirror planes at any angle.
#ifndef SINEW_RIG_MIRROR_ANGLE_HPP
#define SINEW_RIG_MIRROR_ANGLE_HPP

#include "rig/surface_points.hpp"

namespace sinew {

// A direction in the floor's plane, Q28.
struct Heading {
  int64_t x, z;
};

// The upright plane that mirrors the mesh best, a plane along the expected front being liked better than one across it.
//   up_axis   of the grid: 0 = y, 1 = z
//   expected  unit vector, or (0, 0) where any will do
//   normal    out  unit vector, untouched where no plane mirrors the mesh
// Where the mesh's vertices mirror each other the plane is theirs, exact to the grid. Scratch is taken from the arena and
// released. Returns arena.ok().
bool find_mirror_angle(const Mesh& mesh, uint32_t up_axis, Heading expected, Arena& arena, Heading* normal,
                       bool* found);

}  // namespace sinew
#endif
