// SPDX-License-Identifier: MIT
// Unit quaternions in double, of one order of operations and without the maths library: the same bits
// everywhere.
#ifndef SINEW_MOTION_QUATERNION_HPP
#define SINEW_MOTION_QUATERNION_HPP

#include "core/vec3d.hpp"

namespace sinew::motion {

struct Quat {
  double x, y, z, w;
};
constexpr Quat kNoRotation = {0, 0, 0, 1};

// a after b.
inline Quat operator*(Quat a, Quat b) {
  return {a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y, a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x,
          a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w, a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z};
}
inline Quat conjugate(Quat q) { return {-q.x, -q.y, -q.z, q.w}; }
// The identity for a quaternion without length.
inline Quat normalized(Quat q) {
  const double square = q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w;
  if (!(square > kLeastSquare)) return kNoRotation;
  const double s = reciprocal_root(square);
  return {q.x * s, q.y * s, q.z * s, q.w * s};
}
inline Vec3d rotate(Quat q, Vec3d v) {
  const Vec3d u = {q.x, q.y, q.z};
  const Vec3d t = 2.0 * cross(u, v);
  return v + q.w * t + cross(u, t);
}

// The shortest rotation from one direction to another; 180 degrees about some perpendicular axis if they are
// opposite, none where one of them has no length.
inline Quat shortest_arc(Vec3d from, Vec3d to) {
  const Vec3d a = unit(from), b = unit(to);
  const double c = dot(a, b);
  if (c < 1e-12 - 1) {
    const Vec3d other = a.x < 0.9 && a.x > -0.9 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0};
    const Vec3d axis = unit(other - dot(other, a) * a);
    return {axis.x, axis.y, axis.z, 0};
  }
  if (dot(a, a) == 0 || dot(b, b) == 0) return kNoRotation;
  const Vec3d axis = cross(a, b);
  return normalized({axis.x, axis.y, axis.z, 1 + c});
}

}  // namespace sinew::motion
#endif
