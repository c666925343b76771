// SPDX-License-Identifier: MIT
// Affine transforms in double for the glTF reader and writer. Row-major 3x4: the last row of a glTF node or bind matrix
// is 0 0 0 1.
#ifndef SINEW_FORMATS_MATRIX4_HPP
#define SINEW_FORMATS_MATRIX4_HPP

#include <array>
#include <cmath>
#include <optional>

namespace sinew {

using Affine = std::array<double, 12>;

constexpr Affine kIdentity = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};

inline Affine multiply(const Affine& a, const Affine& b) {
  Affine out{};
  for (size_t r = 0; r < 3; ++r)
    for (size_t c = 0; c < 4; ++c) {
      out[r * 4 + c] = a[r * 4] * b[c] + a[r * 4 + 1] * b[4 + c] + a[r * 4 + 2] * b[8 + c];
      if (c == 3) out[r * 4 + c] += a[r * 4 + 3];
    }
  return out;
}

inline std::array<double, 3> transform_point(const Affine& m, double x, double y, double z) {
  return {m[0] * x + m[1] * y + m[2] * z + m[3], m[4] * x + m[5] * y + m[6] * z + m[7],
          m[8] * x + m[9] * y + m[10] * z + m[11]};
}

// nullopt when it flattens space (a scale of 0).
inline std::optional<Affine> inverse(const Affine& m) {
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

// Direction of a surface normal under `m`: the cofactors, which need no inverse and keep the side of a mirrored
// surface.
inline std::array<double, 3> transform_normal(const Affine& m, double x, double y, double z) {
  const double side =
      m[0] * (m[5] * m[10] - m[6] * m[9]) + m[1] * (m[6] * m[8] - m[4] * m[10]) + m[2] * (m[4] * m[9] - m[5] * m[8]);
  const double s = side < 0 ? -1 : 1;
  return {s * ((m[5] * m[10] - m[6] * m[9]) * x + (m[6] * m[8] - m[4] * m[10]) * y + (m[4] * m[9] - m[5] * m[8]) * z),
          s * ((m[2] * m[9] - m[1] * m[10]) * x + (m[0] * m[10] - m[2] * m[8]) * y + (m[1] * m[8] - m[0] * m[9]) * z),
          s * ((m[1] * m[6] - m[2] * m[5]) * x + (m[2] * m[4] - m[0] * m[6]) * y + (m[0] * m[5] - m[1] * m[4]) * z)};
}

}  // namespace sinew
#endif
