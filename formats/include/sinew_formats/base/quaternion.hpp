// SPDX-License-Identifier: MIT
// Quaternions, the other forms of a rotation that files use, and the rotations between directions.
#ifndef SINEW_FORMATS_BASE_QUATERNION_HPP
#define SINEW_FORMATS_BASE_QUATERNION_HPP

#include <array>
#include <cstddef>

#include "sinew_formats/base/affine.hpp"
#include "sinew_formats/base/point.hpp"

namespace sinew {

using Quaternion = std::array<double, 4>;  // x y z w, of length 1
constexpr Quaternion kNoRotation4 = {0, 0, 0, 1};

// a after b.
Quaternion multiply(const Quaternion& a, const Quaternion& b);
inline Quaternion conjugate(const Quaternion& q) { return {-q[0], -q[1], -q[2], q[3]}; }
double dot(const Quaternion& a, const Quaternion& b);
// kNoRotation4 for one without length.
Quaternion normalised(const Quaternion& q);
Point3 rotate(const Quaternion& q, const Point3& v);
// About axis 0, 1 or 2.
Quaternion axis_rotation(size_t axis, double radians);
// Along the shortest arc; t from 0 to 1.
Quaternion slerp(const Quaternion& a, Quaternion b, double t);
Rotation rotation_of(const Quaternion& q);
Quaternion quaternion_of(const Rotation& r);
// The rotation in an affine transform that scales, perhaps mirrors: columns made orthogonal in their order.
Rotation rotation_part(const Affine& m);

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
