// SPDX-License-Identifier: MIT
// The rotation that turns old bones to where the new ones point.
#ifndef SINEW_CHARACTER_PREDICT_TURN_HPP
#define SINEW_CHARACTER_PREDICT_TURN_HPP

#include <vector>

#include "base/points.hpp"
#include "sinew_formats/affine.hpp"

namespace sinew {

using Point = Point3;
inline Vec3 vec(const Point& p) {
  return {static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])};
}

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
