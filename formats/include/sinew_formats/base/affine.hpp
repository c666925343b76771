// SPDX-License-Identifier: MIT
// Affine transforms in double: glTF nodes, bind matrices, poses. Row-major 3x4, the last row 0 0 0 1 is left out.
// Sums run from left to right, so that the same transforms give the same bits everywhere.
#ifndef SINEW_FORMATS_BASE_AFFINE_HPP
#define SINEW_FORMATS_BASE_AFFINE_HPP

#include <array>
#include <optional>
#include <vector>

#include "sinew_formats/base/point.hpp"

namespace sinew {

using Affine = std::array<double, 12>;

constexpr Affine kIdentity = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};

Affine multiply(const Affine& a, const Affine& b);

// Rotation alone, row-major 3x3.
using Rotation = std::array<double, 9>;
constexpr Rotation kNoRotation = {1, 0, 0, 0, 1, 0, 0, 0, 1};

Rotation multiply(const Rotation& a, const Rotation& b);

// By `angle` radians about a unit axis (Rodrigues): I + sin(t) K + (1 - cos(t)) K^2.
Rotation axis_rotation(const Point3& axis, double angle);

// The rotation about a centre that stays where it is.
Affine rotation_about(const Rotation& rotation, const Point3& centre);

Point3 transform_point(const Affine& m, double x, double y, double z);

// Of the linear part: below 0 for a mirrored one.
double determinant(const Affine& m);

// nullopt when it flattens space (a scale of 0).
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

}  // namespace sinew
#endif
