// SPDX-License-Identifier: MIT
// Upright mirror planes at any angle.
#ifndef SINEW_FRONT_MIRROR_ANGLE_HPP
#define SINEW_FRONT_MIRROR_ANGLE_HPP

#include "core/vector_math.hpp"
#include "front/surface_points.hpp"

namespace sinew::rigging {

// A direction in the floor's plane, Q28.
struct Heading {
  int64_t x, z;
};

inline Heading unit_heading(int64_t x, int64_t z) {
  const Vec3i u = unit_vector(Vec3l{x, z, 0}, 28);
  return {u.x, u.y};
}

// The direction in the floor's plane in which the surface reaches farthest, by moments of the vertices' areas: no choice of
// points moves it, and the plane of a mirrored mesh lies along it or across.
struct SurfaceAxis {
  Heading along;
  int64_t length;  // how much longer than wide: 0 round .. 2^10 a line
};
SurfaceAxis surface_axis(const Mesh& mesh, uint32_t up_axis);

// The upright plane that mirrors the mesh best, a plane along the expected front being liked better than one across it.
//   up_axis   of the grid: 0 = y, 1 = z
//   expected  unit vector, or (0, 0) where any will do
//   normal    out  unit vector, untouched where no plane mirrors the mesh, or six tenths of it near the expected front
// A plane beside the surface's axis is put there, where the axis is clear; else it is that of the vertices that mirror each
// other, where they do. So it is the same to the grid however the mesh is rotated. Scratch is taken from the arena and
// released. Returns arena.ok().
bool find_mirror_angle(const Mesh& mesh, uint32_t up_axis, Heading expected, Arena& arena, Heading* normal,
                       bool* found);

}  // namespace sinew::rigging
#endif
