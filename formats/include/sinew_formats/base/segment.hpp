// SPDX-License-Identifier: MIT
// Distances from line segments.
#ifndef SINEW_FORMATS_SEGMENT_HPP
#define SINEW_FORMATS_SEGMENT_HPP

#include <algorithm>

#include "sinew_formats/base/point.hpp"

namespace sinew {

inline Point3 nearest_on_segment(const Point3& p, const Point3& a, const Point3& b) {
  const Point3 along = b - a;
  const double square = dot(along, along);
  const double share = square > 0 ? std::min(1.0, std::max(0.0, dot(p - a, along) / square)) : 0;
  return a + share * along;
}
inline double segment_distance(const Point3& p, const Point3& a, const Point3& b) {
  return length(p - nearest_on_segment(p, a, b));
}

}  // namespace sinew
#endif
