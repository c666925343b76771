// SPDX-License-Identifier: MIT
// Boxes of a mesh's parts along left, up and front.
#ifndef SINEW_CHARACTER_PREDICT_PART_BOX_HPP
#define SINEW_CHARACTER_PREDICT_PART_BOX_HPP

#include <algorithm>
#include <array>
#include <cmath>

#include "sinew_formats/base/point.hpp"
#include "sinew_formats/character.hpp"

namespace sinew {

// Along left, up and front.
struct PartBox {
  Point3 low = {1e300, 1e300, 1e300}, high = {-1e300, -1e300, -1e300};
  void add(const Point3& p) {
    for (size_t a = 0; a < 3; ++a) {
      low[a] = std::min(low[a], p[a]);
      high[a] = std::max(high[a], p[a]);
    }
  }
  Point3 middle() const { return 0.5 * (low + high); }
  double side(size_t a) const { return high[a] - low[a]; }
  double longest() const { return std::max({side(0), side(1), side(2)}); }
};
constexpr size_t kLeft = 0, kUp = 1, kFront = 2;

inline double gap(const PartBox& a, const PartBox& b) {
  double sum = 0;
  for (size_t k = 0; k < 3; ++k) {
    const double d = std::max({0.0, a.low[k] - b.high[k], b.low[k] - a.high[k]});
    sum += d * d;
  }
  return std::sqrt(sum);
}

// The box that both share. Where they are apart, it is the box between them.
inline PartBox common(const PartBox& a, const PartBox& b) {
  PartBox out;
  for (size_t k = 0; k < 3; ++k) {
    const double from = std::max(a.low[k], b.low[k]), to = std::min(a.high[k], b.high[k]);
    out.low[k] = std::min(from, to);
    out.high[k] = std::max(from, to);
  }
  return out;
}

inline double volume(const PartBox& box, double thin) {
  return (box.side(0) + thin) * (box.side(1) + thin) * (box.side(2) + thin);
}

struct BodyAxes {
  std::array<Point3, 3> of;  // unit vectors in the mesh's axes

  //   front  unit vector, horizontal
  BodyAxes(Axis up, const std::array<float, 3>& front) {
    of[kUp] = {};
    of[kUp][axis_index(up)] = 1;
    of[kFront] = {double{front[0]}, double{front[1]}, double{front[2]}};
    of[kLeft] = cross(of[kUp], of[kFront]);
  }
  Point3 local(const Vec3& v) const {
    const Point3 p = {double{v.x}, double{v.y}, double{v.z}};
    return {dot(of[0], p), dot(of[1], p), dot(of[2], p)};
  }
  Vec3 world(const Point3& p) const { return sinew::to_vec3(p[0] * of[0] + p[1] * of[1] + p[2] * of[2]); }
};

}  // namespace sinew
#endif
