// SPDX-License-Identifier: MIT
// Axes are the eigenvectors of the covariance.
#include "published/oriented_box.hpp"

#include "core/eigenpairs.hpp"

namespace sinew::rigging {

void OrientedBox::turn() {
  double m[9], v[9];
  const double mean[3] = {sum_.x / count_, sum_.y / count_, sum_.z / count_};
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) m[3 * i + k] = squares_[i][k] / count_ - mean[i] * mean[k];
  }
  find_eigenpairs(3, m, v);
  for (int i = 0; i < 3; ++i) axes_[i] = {v[i], v[3 + i], v[6 + i]};
}

bool OrientedBox::overlaps(const OrientedBox& other, double gap) const {
  const Vec3d between = other.middle() - middle();
  const auto apart = [&](const Vec3d& axis) {
    const double squared = dot(axis, axis);
    if (!(squared > 1e-12)) return false;
    const Vec3d unit = (1 / root(squared)) * axis;
    return absolute(dot(between, unit)) > reach(unit) + other.reach(unit) + gap;
  };
  for (int i = 0; i < 3; ++i) {
    if (apart(axes_[i]) || apart(other.axes_[i])) return false;
  }
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) {
      if (apart(cross(axes_[i], other.axes_[k]))) return false;
    }
  }
  return true;
}

}  // namespace sinew::rigging
