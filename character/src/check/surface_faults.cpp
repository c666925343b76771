// SPDX-License-Identifier: MIT
// Pairs of triangles of two layers that cross: boxes first, swept along x, then edges.
#include "sinew_character/check/surface_faults.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "core/triangle.hpp"
#include "sinew_formats/base/box.hpp"

namespace sinew {
namespace {

struct Triangle {
  std::array<Vec3d, 3> corners;
  Box box;
  uint32_t number = 0;
};

// By the low end of their boxes along x.
std::vector<Triangle> triangles_of(const Character& character) {
  std::vector<Triangle> out;
  for (size_t f = 0; f < character.face_count(); ++f) {
    const uint32_t begin = character.face_offsets[f], end = character.face_offsets[f + 1];
    for (uint32_t i = begin + 2; i < end; ++i) {
      const std::vector<Vec3> points = {character.vertices[character.face_vertices[begin]],
                                        character.vertices[character.face_vertices[i - 1]],
                                        character.vertices[character.face_vertices[i]]};
      Triangle triangle;
      triangle.box = box_of(points);
      triangle.number = static_cast<uint32_t>(out.size());
      for (size_t c = 0; c < 3; ++c)
        triangle.corners[c] = {static_cast<double>(points[c].x), static_cast<double>(points[c].y),
                               static_cast<double>(points[c].z)};
      out.push_back(triangle);
    }
  }
  std::stable_sort(out.begin(), out.end(),
                   [](const Triangle& a, const Triangle& b) { return a.box.low.x < b.box.low.x; });
  return out;
}

bool apart(const Box& a, const Box& b) {
  return a.high.x < b.low.x || b.high.x < a.low.x || a.high.y < b.low.y || b.high.y < a.low.y || a.high.z < b.low.z ||
         b.high.z < a.low.z;
}

bool goes_through(const Triangle& edges, size_t edge, const Triangle& wall) {
  const auto& [a, b, c] = wall.corners;
  return goes_through(edges.corners[edge], edges.corners[(edge + 1) % 3], a, b, c);
}

bool cross_each_other(const Triangle& a, const Triangle& b) {
  for (size_t k = 0; k < 3; ++k)
    if (goes_through(a, k, b) || goes_through(b, k, a)) return true;
  return false;
}

}  // namespace

std::vector<std::pair<uint32_t, uint32_t>> crossing_pairs(const Character& a, const Character& b) {
  const std::vector<Triangle> ours = triangles_of(a), theirs = triangles_of(b);
  std::vector<std::pair<uint32_t, uint32_t>> pairs;
  std::vector<const Triangle*> open;  // of theirs, those that may reach over where the sweep is
  size_t next = 0;
  for (const Triangle& one : ours) {
    while (next < theirs.size() && theirs[next].box.low.x <= one.box.high.x) open.push_back(&theirs[next++]);
    // The sweep's low end only grows: what lies behind it is met by none of the rest.
    open.erase(std::remove_if(open.begin(), open.end(),
                              [&](const Triangle* other) { return other->box.high.x < one.box.low.x; }),
               open.end());
    for (const Triangle* other : open)
      if (!apart(one.box, other->box) && cross_each_other(one, *other)) pairs.emplace_back(one.number, other->number);
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

size_t new_crossings(const std::vector<std::pair<uint32_t, uint32_t>>& rest,
                     const std::vector<std::pair<uint32_t, uint32_t>>& posed) {
  std::vector<std::pair<uint32_t, uint32_t>> added;
  std::set_difference(posed.begin(), posed.end(), rest.begin(), rest.end(), std::back_inserter(added));
  return added.size();
}

// Lengths of edges before and after.

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
