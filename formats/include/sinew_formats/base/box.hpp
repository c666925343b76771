// SPDX-License-Identifier: MIT
// Bounding boxes, and helpers for axes.
#ifndef SINEW_FORMATS_BASE_BOX_HPP
#define SINEW_FORMATS_BASE_BOX_HPP

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "sinew_formats/character.hpp"

namespace sinew {

// An axis that may not be known.
using MaybeAxis = std::optional<Axis>;

// 0, 1, 2: the axis's index in x, y, z.
constexpr uint32_t axis_index(Axis axis) { return static_cast<uint32_t>(axis); }

struct Box {
  Vec3 low, high;
  void add(const Vec3& p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  float diagonal() const { return std::hypot(high.x - low.x, high.y - low.y, high.z - low.z); }
  // low first, high last.
  std::vector<Vec3> corners() const {
    std::vector<Vec3> out;
    for (int c = 0; c < 8; ++c)
      out.push_back({(c & 1) != 0 ? high.x : low.x, (c & 2) != 0 ? high.y : low.y, (c & 4) != 0 ? high.z : low.z});
    return out;
  }
  float longest_side() const { return std::max({high.x - low.x, high.y - low.y, high.z - low.z}); }
};

// Needs at least one point.
inline Box box_of(const std::vector<Vec3>& points) {
  Box box = {points.front(), points.front()};
  for (const Vec3& p : points) box.add(p);
  return box;
}

}  // namespace sinew
#endif
