// SPDX-License-Identifier: MIT
// Sums, products and directions of points, and the rotations between directions.
#ifndef SINEW_FORMATS_BASE_POINTS_HPP
#define SINEW_FORMATS_BASE_POINTS_HPP

#include <cmath>

#include "motion/turns.hpp"
#include "sinew_formats/character.hpp"

namespace sinew {

inline Point3 point(const Vec3& p) {
  return {static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z)};
}
inline Point3 operator+(const Point3& a, const Point3& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline Point3 operator-(const Point3& a, const Point3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline Point3 operator*(double s, const Point3& a) { return {s * a[0], s * a[1], s * a[2]}; }
inline double dot(const Point3& a, const Point3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Point3 cross(const Point3& a, const Point3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline double length(const Point3& a) { return std::sqrt(dot(a, a)); }
// Zero for a point without length.
inline Point3 unit(const Point3& a) {
  const double l = length(a);
  return l > 0 ? (1 / l) * a : Point3{};
}
inline Point3 across(const Point3& a, const Point3& axis) { return a - dot(a, axis) * axis; }

// Along the shortest arc; none where one of the two has no length, half a turn about any axis where they are opposite.
inline Quaternion rotation_between(const Point3& from, const Point3& to) {
  const Point3 a = unit(from), b = unit(to);
  const double c = dot(a, b);
  if (dot(a, a) == 0 || dot(b, b) == 0) return kNoRotation4;
  if (c < 1e-9 - 1) {
    const Point3 axis = unit(across(std::abs(a[0]) < 0.9 ? Point3{1, 0, 0} : Point3{0, 1, 0}, a));
    return {axis[0], axis[1], axis[2], 0};
  }
  const Point3 axis = cross(a, b);
  return normalised({axis[0], axis[1], axis[2], 1 + c});
}
// Brings x to to_x, and y as near to to_y as that leaves it.
inline Quaternion rotation_between(const Point3& x, const Point3& y, const Point3& to_x, const Point3& to_y) {
  const auto axes = [](const Point3& a, const Point3& b) {
    const Point3 first = unit(a), second = unit(across(b, first)), third = cross(first, second);
    return Rotation{first[0], first[1], first[2], second[0], second[1], second[2], third[0], third[1], third[2]};
  };
  const Rotation from = axes(x, y), to = axes(to_x, to_y);
  const Rotation back = {to[0], to[3], to[6], to[1], to[4], to[7], to[2], to[5], to[8]};
  return quaternion_of(multiply(back, from));
}

}  // namespace sinew
#endif
