// SPDX-License-Identifier: MIT
// A box along the main axes of points.
#ifndef SINEW_PUBLISHED_ORIENTED_BOX_HPP
#define SINEW_PUBLISHED_ORIENTED_BOX_HPP

#include "core/vec3d.hpp"

namespace sinew::rigging {

// Filled in three steps: add() every point, turn(), hold() every point again.
class OrientedBox {
 public:
  void add(const Vec3d& p) {
    if (count_ == 0) origin_ = p;
    const Vec3d d = p - origin_;
    count_ += 1;
    sum_ = sum_ + d;
    const double v[3] = {d.x, d.y, d.z};
    for (int i = 0; i < 3; ++i) {
      for (int k = 0; k < 3; ++k) squares_[i][k] += v[i] * v[k];
    }
  }
  // Main axes of what was added.
  void turn();
  void hold(const Vec3d& p) {
    for (int i = 0; i < 3; ++i) {
      const double along = dot(axes_[i], p - origin_);
      if (!held_ || along < low_[i]) low_[i] = along;
      if (!held_ || along > high_[i]) high_[i] = along;
    }
    held_ = true;
  }
  Vec3d middle() const {
    Vec3d m = origin_;
    for (int i = 0; i < 3; ++i) m = m + (0.5 * (low_[i] + high_[i])) * axes_[i];
    return m;
  }
  // Whether the boxes come closer than `gap`, by separating axes (Gottschalk 1996).
  bool overlaps(const OrientedBox& other, double gap) const;

 private:
  // Half the box's extent along a direction of length 1.
  double reach(const Vec3d& direction) const {
    double sum = 0;
    for (int i = 0; i < 3; ++i) sum += 0.5 * (high_[i] - low_[i]) * absolute(dot(axes_[i], direction));
    return sum;
  }

  Vec3d origin_, sum_;
  double squares_[3][3] = {};
  double count_ = 0;
  Vec3d axes_[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  double low_[3] = {}, high_[3] = {};
  bool held_ = false;
};

}  // namespace sinew::rigging
#endif
