// SPDX-License-Identifier: MIT
// Points and directions in double: sums, products, lengths.
#ifndef SINEW_FORMATS_BASE_POINT_HPP
#define SINEW_FORMATS_BASE_POINT_HPP

#include <array>
#include <cmath>

#include "sinew_formats/character.hpp"

namespace sinew {

using Point3 = std::array<double, 3>;

inline Point3 point(const Vec3& p) {
  return {static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z)};
}
inline Vec3 to_vec3(const Point3& p) {
  return {static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])};
}
inline Point3 operator+(const Point3& a, const Point3& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline Point3 operator-(const Point3& a, const Point3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline Point3 operator*(double s, const Point3& a) { return {s * a[0], s * a[1], s * a[2]}; }
inline double dot(const Point3& a, const Point3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Point3 cross(const Point3& a, const Point3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline double length(const Point3& a) { return std::sqrt(dot(a, a)); }
// Returns zero for a point of length 0.
inline Point3 unit(const Point3& a) {
  const double l = length(a);
  return l > 0 ? (1 / l) * a : Point3{};
}
inline Point3 across(const Point3& a, const Point3& axis) { return a - dot(a, axis) * axis; }

}  // namespace sinew
#endif
