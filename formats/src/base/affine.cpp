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

Affine rotation_about(const Rotation& rotation, const std::array<double, 3>& centre) {
  Affine out{};
  for (size_t r = 0; r < 3; ++r) {
    out[4 * r + 3] = centre[r];
    for (size_t c = 0; c < 3; ++c) {
      out[4 * r + c] = rotation[3 * r + c];
      out[4 * r + 3] -= rotation[3 * r + c] * centre[c];
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

}  // namespace sinew
