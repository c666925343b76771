// SPDX-License-Identifier: MIT
// Points of arrays as Eigen's vectors, and back; random vectors; distances.
#ifndef SINEW_TRAINER_DATA_EIGEN_POINTS_HPP
#define SINEW_TRAINER_DATA_EIGEN_POINTS_HPP

#include <Eigen/Core>
#include <algorithm>
#include <array>

#include "core/random.hpp"

namespace sinew {

inline Eigen::Vector3d vec(const std::array<double, 3>& p) { return {p[0], p[1], p[2]}; }
inline std::array<double, 3> arr(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

// Distance of a point from the segment between two others.
inline double segment_distance(const Eigen::Vector3d& p, const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  const Eigen::Vector3d along = b - a;
  const double t = std::clamp((p - a).dot(along) / std::max(along.squaredNorm(), 1e-12), 0.0, 1.0);
  return (p - a - t * along).norm();
}

// One after the other, whatever order a compiler gives arguments.
inline Eigen::Vector3d normals(Random* random) {
  Eigen::Vector3d v = Eigen::Vector3d::Zero();
  for (int i = 0; i < 3; ++i) v[i] = random->normal();
  return v;
}

}  // namespace sinew
#endif
