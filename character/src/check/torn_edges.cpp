// SPDX-License-Identifier: MIT
// Lengths of edges before and after.
#include "check/torn_edges.hpp"

#include <cmath>

#include "sinew_formats/base/box.hpp"

namespace sinew {
namespace {

constexpr double kTornRatio = 4, kTornLength = 0.02;

double length_between(const Vec3& a, const Vec3& b) {
  return std::hypot(static_cast<double>(a.x - b.x), static_cast<double>(a.y - b.y), static_cast<double>(a.z - b.z));
}

}  // namespace

std::vector<TornEdge> torn_edges(const Character& rest, const Character& posed) {
  std::vector<TornEdge> torn;
  if (rest.vertices.empty()) return torn;
  const double side = static_cast<double>(box_of(rest.vertices).longest_side());
  for (size_t f = 0; f < rest.face_count(); ++f) {
    const uint32_t first = rest.face_offsets[f], last = rest.face_offsets[f + 1];
    for (uint32_t c = first; c < last; ++c) {
      const uint32_t a = rest.face_vertices[c], b = rest.face_vertices[c + 1 < last ? c + 1 : first];
      const double before = length_between(rest.vertices[a], rest.vertices[b]);
      const double after = length_between(posed.vertices[a], posed.vertices[b]);
      if (after > kTornRatio * before && after - before > kTornLength * side) torn.push_back({a, b});
    }
  }
  return torn;
}

}  // namespace sinew
