// SPDX-License-Identifier: MIT
// Products, inverses and images of affine transforms.
#include "sinew_formats/base/affine.hpp"

#include <cmath>

namespace sinew {

Affine multiply(const Affine& a, const Affine& b) {
  Affine out{};
  for (size_t r = 0; r < 3; ++r)
    for (size_t c = 0; c < 4; ++c) {
      out[r * 4 + c] = a[r * 4] * b[c] + a[r * 4 + 1] * b[4 + c] + a[r * 4 + 2] * b[8 + c];
      if (c == 3) out[r * 4 + c] += a[r * 4 + 3];
    }
  return out;
}

Rotation multiply(const Rotation& a, const Rotation& b) {
  Rotation out{};
  for (size_t r = 0; r < 3; ++r)
    for (size_t k = 0; k < 3; ++k)
      for (size_t c = 0; c < 3; ++c) out[3 * r + c] += a[3 * r + k] * b[3 * k + c];
  return out;
}

Rotation axis_rotation(const std::array<double, 3>& axis, double angle) {
  const Rotation k = {0, -axis[2], axis[1], axis[2], 0, -axis[0], -axis[1], axis[0], 0};
  const Rotation kk = multiply(k, k);
  Rotation out = kNoRotation;
  for (size_t i = 0; i < 9; ++i) out[i] += std::sin(angle) * k[i] + (1 - std::cos(angle)) * kk[i];
  return out;
}

Affine rotation_about(const Rotation& rotation, const std::array<double, 3>& center) {
  Affine out{};
  for (size_t r = 0; r < 3; ++r) {
    out[4 * r + 3] = center[r];
    for (size_t c = 0; c < 3; ++c) {
      out[4 * r + c] = rotation[3 * r + c];
      out[4 * r + 3] -= rotation[3 * r + c] * center[c];
    }
  }
  return out;
}

std::array<double, 3> transform_point(const Affine& m, double x, double y, double z) {
  return {m[0] * x + m[1] * y + m[2] * z + m[3], m[4] * x + m[5] * y + m[6] * z + m[7],
          m[8] * x + m[9] * y + m[10] * z + m[11]};
}

double determinant(const Affine& m) {
  return m[0] * (m[5] * m[10] - m[6] * m[9]) - m[1] * (m[4] * m[10] - m[6] * m[8]) + m[2] * (m[4] * m[9] - m[5] * m[8]);
}

std::optional<Affine> inverse(const Affine& m) {
  const double c00 = m[5] * m[10] - m[6] * m[9], c01 = m[6] * m[8] - m[4] * m[10], c02 = m[4] * m[9] - m[5] * m[8];
  const double determinant = m[0] * c00 + m[1] * c01 + m[2] * c02;
  if (!std::isfinite(1 / determinant)) return std::nullopt;
  const double d = 1 / determinant;
  Affine out = {c00 * d, (m[2] * m[9] - m[1] * m[10]) * d, (m[1] * m[6] - m[2] * m[5]) * d, 0,
                c01 * d, (m[0] * m[10] - m[2] * m[8]) * d, (m[2] * m[4] - m[0] * m[6]) * d, 0,
                c02 * d, (m[1] * m[8] - m[0] * m[9]) * d,  (m[0] * m[5] - m[1] * m[4]) * d, 0};
  for (size_t r = 0; r < 3; ++r) out[r * 4 + 3] = -(out[r * 4] * m[3] + out[r * 4 + 1] * m[7] + out[r * 4 + 2] * m[11]);
  return out;
}

std::array<double, 3> transform_normal(const Affine& m, double x, double y, double z) {
  const double side =
      m[0] * (m[5] * m[10] - m[6] * m[9]) + m[1] * (m[6] * m[8] - m[4] * m[10]) + m[2] * (m[4] * m[9] - m[5] * m[8]);
  const double s = side < 0 ? -1 : 1;
  return {s * ((m[5] * m[10] - m[6] * m[9]) * x + (m[6] * m[8] - m[4] * m[10]) * y + (m[4] * m[9] - m[5] * m[8]) * z),
          s * ((m[2] * m[9] - m[1] * m[10]) * x + (m[0] * m[10] - m[2] * m[8]) * y + (m[1] * m[8] - m[0] * m[9]) * z),
          s * ((m[1] * m[6] - m[2] * m[5]) * x + (m[2] * m[4] - m[0] * m[6]) * y + (m[0] * m[5] - m[1] * m[4]) * z)};
}

// Products, blends and conversions of rotations.
Quaternion multiply(const Quaternion& a, const Quaternion& b) {
  return {a[3] * b[0] + a[0] * b[3] + a[1] * b[2] - a[2] * b[1], a[3] * b[1] - a[0] * b[2] + a[1] * b[3] + a[2] * b[0],
          a[3] * b[2] + a[0] * b[1] - a[1] * b[0] + a[2] * b[3], a[3] * b[3] - a[0] * b[0] - a[1] * b[1] - a[2] * b[2]};
}

double dot(const Quaternion& a, const Quaternion& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3]; }

Quaternion normalized(const Quaternion& q) {
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
  return normalized(out);
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
  if (w2 >= x2 && w2 >= y2 && w2 >= z2) return normalized({m[7] - m[5], m[2] - m[6], m[3] - m[1], w2});
  if (x2 >= y2 && x2 >= z2) return normalized({x2, m[1] + m[3], m[2] + m[6], m[7] - m[5]});
  if (y2 >= z2) return normalized({m[1] + m[3], y2, m[5] + m[7], m[2] - m[6]});
  return normalized({m[2] + m[6], m[5] + m[7], z2, m[3] - m[1]});
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
