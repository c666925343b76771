// SPDX-License-Identifier: MIT
// Where surfaces cross: an edge of one through a triangle of the other. No stage of the engine asks; what judges layers
// of cloth does.
#ifndef SINEW_CORE_SEGMENT_TRIANGLE_HPP
#define SINEW_CORE_SEGMENT_TRIANGLE_HPP

#include "core/vec3d.hpp"

namespace sinew {

// Whether the segment goes through the triangle (a, b, c). One that lies in its plane does not; one that begins in it may.
inline bool goes_through(Vec3d from, Vec3d to, Vec3d a, Vec3d b, Vec3d c) {
  const Vec3d normal = cross(b - a, c - a);
  const double start = dot(normal, from - a), end = dot(normal, to - a);
  if ((start < 0) == (end < 0)) return false;
  const Vec3d at = from + (start / (start - end)) * (to - from);
  return dot(cross(b - a, at - a), normal) >= 0 && dot(cross(c - b, at - b), normal) >= 0 &&
         dot(cross(a - c, at - c), normal) >= 0;
}

}  // namespace sinew
#endif
