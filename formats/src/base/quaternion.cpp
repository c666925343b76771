// SPDX-License-Identifier: MIT
// Products, blends and conversions of rotations.
#include "sinew_formats/base/quaternion.hpp"

#include <cmath>

namespace sinew {

Quaternion multiply(const Quaternion& a, const Quaternion& b) {
  return {a[3] * b[0] + a[0] * b[3] + a[1] * b[2] - a[2] * b[1], a[3] * b[1] - a[0] * b[2] + a[1] * b[3] + a[2] * b[0],
          a[3] * b[2] + a[0] * b[1] - a[1] * b[0] + a[2] * b[3], a[3] * b[3] - a[0] * b[0] - a[1] * b[1] - a[2] * b[2]};
}

double dot(const Quaternion& a, const Quaternion& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3]; }

Quaternion normalised(const Quaternion& q) {
  const double length = std::sqrt(dot(q, q));
  if (!(length > 0) || !std::isfinite(length)) return kNoRotation4;
  return {q[0] / length, q[1] / length, q[2] / length, q[3] / length};
}

Point3 rotate(const Quaternion& q, const Point3& v) {
  const Point3 t = {2 * (q[1] * v[2] - q[2] * v[1]), 2 * (q[2] * v[0] - q[0] * v[2]), 2 * (q[0] * v[1] - q[1] * v[0])};
  return {v[0] + q[3] * t[0] + q[1] * t[2] - q[2] * t[1], v[1] + q[3] * t[1] + q[2] * t[0] - q[0] * t[2],
          v[2] + q[3] * t[2] + q[0] * t[1] - q[1] * t[0]};
}

Quaternion axis_rotation(size_t axis, double radians) {
  Quaternion q = {0, 0, 0, std::cos(radians / 2)};
  q[axis] = std::sin(radians / 2);
  return q;
}

Quaternion slerp(const Quaternion& a, Quaternion b, double t) {
  double cosine = dot(a, b);
  if (cosine < 0) {
    cosine = -cosine;
    for (double& x : b) x = -x;
  }
  double first = 1 - t, second = t;
  if (cosine < 1 - 1e-9) {  // nearer, the chord is the arc
    const double angle = std::acos(cosine), sine = std::sin(angle);
    first = std::sin((1 - t) * angle) / sine;
    second = std::sin(t * angle) / sine;
  }
  Quaternion out{};
  for (size_t i = 0; i < 4; ++i) out[i] = first * a[i] + second * b[i];
  return normalised(out);
}

Rotation rotation_of(const Quaternion& q) {
  const double x = q[0], y = q[1], z = q[2], w = q[3];
  return {1 - 2 * (y * y + z * z), 2 * (x * y - z * w),     2 * (x * z + y * w),
          2 * (x * y + z * w),     1 - 2 * (x * x + z * z), 2 * (y * z - x * w),
          2 * (x * z - y * w),     2 * (y * z + x * w),     1 - 2 * (x * x + y * y)};
}

// Of the four squares 4w^2, 4x^2, 4y^2, 4z^2 the largest is at least 1 (Shepperd 1978).
Quaternion quaternion_of(const Rotation& m) {
  const double w2 = 1 + m[0] + m[4] + m[8], x2 = 1 + m[0] - m[4] - m[8], y2 = 1 - m[0] + m[4] - m[8],
               z2 = 1 - m[0] - m[4] + m[8];
  if (w2 >= x2 && w2 >= y2 && w2 >= z2) return normalised({m[7] - m[5], m[2] - m[6], m[3] - m[1], w2});
  if (x2 >= y2 && x2 >= z2) return normalised({x2, m[1] + m[3], m[2] + m[6], m[7] - m[5]});
  if (y2 >= z2) return normalised({m[1] + m[3], y2, m[5] + m[7], m[2] - m[6]});
  return normalised({m[2] + m[6], m[5] + m[7], z2, m[3] - m[1]});
}

Rotation rotation_part(const Affine& m) {
  Point3 x = {m[0], m[4], m[8]}, y = {m[1], m[5], m[9]};
  const auto scaled = [](const Point3& v, double s) { return Point3{s * v[0], s * v[1], s * v[2]}; };
  const auto product = [](const Point3& a, const Point3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; };
  const double x_length = std::sqrt(product(x, x));
  if (!(x_length > 0)) return kNoRotation;
  x = scaled(x, 1 / x_length);
  const double along = product(x, y);
  for (size_t i = 0; i < 3; ++i) y[i] -= along * x[i];
  const double y_length = std::sqrt(product(y, y));
  if (!(y_length > 0)) return kNoRotation;
  y = scaled(y, 1 / y_length);
  const Point3 z = {x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]};
  return {x[0], y[0], z[0], x[1], y[1], z[1], x[2], y[2], z[2]};
}

}  // namespace sinew
