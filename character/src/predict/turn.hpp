// SPDX-License-Identifier: MIT
// The rotation of old bones onto the directions of the new ones.
#ifndef SINEW_CHARACTER_PREDICT_TURN_HPP
#define SINEW_CHARACTER_PREDICT_TURN_HPP

#include <vector>

#include "sinew_formats/base/affine.hpp"
#include "sinew_formats/base/point.hpp"

namespace sinew {

Point3 turned(const Rotation& r, const Point3& p);

struct RotationPair {
  Point3 from, to;
  double weight = 1;
};

// Least squares over directions and lengths (Horn 1987, "Closed-form solution of absolute orientation using unit
// quaternions"). If the pairs leave a rotation open, such as about a single bone, it is the one nearest to `usual`.
Rotation best_rotation(const std::vector<RotationPair>& pairs, const Rotation& usual);

}  // namespace sinew
#endif
