// SPDX-License-Identifier: MIT
// Affine transforms in double, for glTF nodes, bind matrices and poses: row-major 3x4 without the last row 0 0 0 1.
// Sums run from left to right, so that the same transforms give the same bits everywhere.
#ifndef SINEW_FORMATS_BASE_AFFINE_HPP
#define SINEW_FORMATS_BASE_AFFINE_HPP

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "sinew_formats/base/point.hpp"

namespace sinew {

using Affine = std::array<double, 12>;

constexpr Affine kIdentity = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};

Affine multiply(const Affine& a, const Affine& b);

// A rotation, row-major 3x3.
using Rotation = std::array<double, 9>;
constexpr Rotation kNoRotation = {1, 0, 0, 0, 1, 0, 0, 0, 1};

Rotation multiply(const Rotation& a, const Rotation& b);

// Rotation by `angle` radians about a unit axis (Rodrigues): I + sin(t) K + (1 - cos(t)) K^2.
Rotation axis_rotation(const Point3& axis, double angle);

// Rotation about a fixed center.
Affine rotation_about(const Rotation& rotation, const Point3& center);

Point3 transform_point(const Affine& m, double x, double y, double z);

// Determinant of the linear part; below 0 for a mirror transform.
double determinant(const Affine& m);

// Returns nullopt for a singular transform (a scale of 0).
std::optional<Affine> inverse(const Affine& m);

// Direction of a surface normal under `m`: the cofactors, which need no inverse and keep the side of a mirrored
// surface.
Point3 transform_normal(const Affine& m, double x, double y, double z);

// The 16 numbers of glTF's matrices, column by column.
inline void append_columns(const Affine& m, std::vector<float>* values) {
  for (size_t c = 0; c < 4; ++c)
    for (size_t r = 0; r < 4; ++r) values->push_back(r < 3 ? static_cast<float>(m[r * 4 + c]) : (c == 3 ? 1.0f : 0.0f));
}
inline std::vector<float> columns_of(const Affine& m) {
  std::vector<float> out;
  append_columns(m, &out);
  return out;
}

// Quaternions, conversions from other forms of rotation in files, and rotations between directions.

using Quaternion = std::array<double, 4>;  // x y z w, of length 1
constexpr Quaternion kNoRotation4 = {0, 0, 0, 1};

// a after b.
Quaternion multiply(const Quaternion& a, const Quaternion& b);
inline Quaternion conjugate(const Quaternion& q) { return {-q[0], -q[1], -q[2], q[3]}; }
double dot(const Quaternion& a, const Quaternion& b);
// Returns kNoRotation4 for a quaternion of length 0.
Quaternion normalized(const Quaternion& q);
Point3 rotate(const Quaternion& q, const Point3& v);
// Rotation about axis 0, 1 or 2.
Quaternion axis_rotation(size_t axis, double radians);
// Interpolates along the shortest arc; t from 0 to 1.
Quaternion slerp(const Quaternion& a, Quaternion b, double t);
Rotation rotation_of(const Quaternion& q);
Quaternion quaternion_of(const Rotation& r);
// Rotation part of an affine transform with scale or mirroring: its columns, orthogonalized in order.
Rotation rotation_part(const Affine& m);

// Rotation along the shortest arc: identity if one of the two has length 0, 180 degrees about any axis if they are
// opposite.
inline Quaternion rotation_between(const Point3& from, const Point3& to) {
  const Point3 a = unit(from), b = unit(to);
  const double c = dot(a, b);
  if (dot(a, a) == 0 || dot(b, b) == 0) return kNoRotation4;
  if (c < 1e-9 - 1) {
    const Point3 axis = unit(across(std::abs(a[0]) < 0.9 ? Point3{1, 0, 0} : Point3{0, 1, 0}, a));
    return {axis[0], axis[1], axis[2], 0};
  }
  const Point3 axis = cross(a, b);
  return normalized({axis[0], axis[1], axis[2], 1 + c});
}
// Rotates x to to_x, and then y as near as possible to to_y.
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
