// SPDX-License-Identifier: MIT
// The rotation that turns old bones to where the new ones point.
#ifndef SINEW_CHARACTER_PREDICT_TURN_HPP
#define SINEW_CHARACTER_PREDICT_TURN_HPP

#include <array>
#include <vector>

#include "sinew_formats/affine.hpp"

namespace sinew {

using Point = std::array<double, 3>;

inline Point operator+(const Point& a, const Point& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline Point operator-(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline Point operator*(double s, const Point& a) { return {s * a[0], s * a[1], s * a[2]}; }
inline double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
double length(const Point& a);
Point turned(const Rotation& r, const Point& p);

struct RotationPair {
  Point from, to;
  double weight = 1;
};

// Least squares over directions and lengths (Horn 1987, "Closed-form solution of absolute orientation using unit
// quaternions"). Where the pairs leave a turn open, about a single bone for one, it is the one nearest to `usual`.
Rotation best_rotation(const std::vector<RotationPair>& pairs, const Rotation& usual);

}  // namespace sinew
#endif
