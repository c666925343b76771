// SPDX-License-Identifier: MIT
// Axes by Jacobi's rotations of the covariance.
#include "rig/oriented_box.hpp"

namespace sinew {

using mapping::Point;

void OrientedBox::turn() {
  double m[3][3], v[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};  // rows of v: the axes
  const double mean[3] = {sum_.x / count_, sum_.y / count_, sum_.z / count_};
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) m[i][k] = squares_[i][k] / count_ - mean[i] * mean[k];
  }
  constexpr int kSweeps = 12;  // each squares what is off the diagonal
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    for (int p = 0; p < 2; ++p) {
      for (int q = p + 1; q < 3; ++q) {
        if (mapping::absolute(m[p][q]) <= 1e-12 * (mapping::absolute(m[p][p]) + mapping::absolute(m[q][q]))) continue;
        const double theta = (m[q][q] - m[p][p]) / (2 * m[p][q]);
        const double t = (theta < 0 ? -1 : 1) / (mapping::absolute(theta) + mapping::root(theta * theta + 1));
        const double c = 1 / mapping::root(t * t + 1), s = t * c;
        for (int k = 0; k < 3; ++k) {
          const double a = m[p][k], b = m[q][k];
          m[p][k] = c * a - s * b;
          m[q][k] = s * a + c * b;
        }
        for (int k = 0; k < 3; ++k) {
          const double a = m[k][p], b = m[k][q];
          m[k][p] = c * a - s * b;
          m[k][q] = s * a + c * b;
        }
        for (int k = 0; k < 3; ++k) {
          const double a = v[p][k], b = v[q][k];
          v[p][k] = c * a - s * b;
          v[q][k] = s * a + c * b;
        }
      }
    }
  }
  for (int i = 0; i < 3; ++i) axes_[i] = {v[i][0], v[i][1], v[i][2]};
}

bool OrientedBox::overlaps(const OrientedBox& other, double gap) const {
  const Point between = other.middle() - middle();
  const auto apart = [&](const Point& axis) {
    const double squared = mapping::dot(axis, axis);
    if (!(squared > 1e-12)) return false;
    const Point unit = (1 / mapping::root(squared)) * axis;
    return mapping::absolute(mapping::dot(between, unit)) > reach(unit) + other.reach(unit) + gap;
  };
  for (int i = 0; i < 3; ++i) {
    if (apart(axes_[i]) || apart(other.axes_[i])) return false;
  }
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) {
      if (apart(mapping::cross(axes_[i], other.axes_[k]))) return false;
    }
  }
  return true;
}

}  // namespace sinew
