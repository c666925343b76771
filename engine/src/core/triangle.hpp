// SPDX-License-Identifier: MIT
// Triangles, in doubles of one order of operations: the point that is nearest to a position, and what goes through.
#ifndef SINEW_CORE_TRIANGLE_HPP
#define SINEW_CORE_TRIANGLE_HPP

#include "core/vec3d.hpp"

namespace sinew {

// Barycentric coordinates of the nearest point to p: the regions of C. Ericson, "Real-Time Collision Detection", 2005, 5.1.5.
inline void nearest_on_triangle(Vec3d p, Vec3d a, Vec3d b, Vec3d c, double* shares) {
  const auto set = [shares](double x, double y, double z) {
    shares[0] = x;
    shares[1] = y;
    shares[2] = z;
  };
  const Vec3d ab = b - a, ac = c - a, ap = p - a, bp = p - b, cp = p - c;
  const double d1 = dot(ab, ap), d2 = dot(ac, ap), d3 = dot(ab, bp), d4 = dot(ac, bp), d5 = dot(ab, cp),
               d6 = dot(ac, cp);
  if (d1 <= 0 && d2 <= 0) return set(1, 0, 0);
  if (d3 >= 0 && d4 <= d3) return set(0, 1, 0);
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return set(1 - d1 / (d1 - d3), d1 / (d1 - d3), 0);
  if (d6 >= 0 && d5 <= d6) return set(0, 0, 1);
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return set(1 - d2 / (d2 - d6), 0, d2 / (d2 - d6));
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
    const double share = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    return set(0, 1 - share, share);
  }
  const double sum = va + vb + vc;
  if (!(sum > 0 || sum < 0)) return set(1, 0, 0);
  set(1 - vb / sum - vc / sum, vb / sum, vc / sum);
}

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
