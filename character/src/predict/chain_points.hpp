// SPDX-License-Identifier: MIT
// Points along a chain of points.
#ifndef SINEW_CHARACTER_PREDICT_CHAIN_POINTS_HPP
#define SINEW_CHARACTER_PREDICT_CHAIN_POINTS_HPP

#include <algorithm>
#include <vector>

#include "predict/turn.hpp"

namespace sinew {

// [last - first + 1] from point `first` along the chain, 0 at first.
inline std::vector<double> lengths_along(const std::vector<Point3>& points, size_t first, size_t last) {
  std::vector<double> along = {0};
  for (size_t i = first; i < last; ++i) along.push_back(along.back() + length(points[i + 1] - points[i]));
  return along;
}

// At a share of the way from point `first` to point `last`, 0 to 1.
inline Point3 point_along(const std::vector<Point3>& points, size_t first, size_t last, double share) {
  const std::vector<double> along = lengths_along(points, first, last);
  const double wanted = share * along.back();
  for (size_t i = 0; i + 1 < along.size(); ++i) {
    if (wanted > along[i + 1] && i + 2 < along.size()) continue;
    const double step = along[i + 1] - along[i];
    const double t = step > 0 ? std::clamp((wanted - along[i]) / step, 0.0, 1.0) : 0;
    return (1 - t) * points[first + i] + t * points[first + i + 1];
  }
  return points[first];
}

}  // namespace sinew
#endif
