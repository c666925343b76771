// SPDX-License-Identifier: MIT
// Delaunay's triangulation of points in the plane, one after the other.
#include <utility>

#include "picture/mesh/plane_mesh.hpp"

namespace sinew::picture {

Delaunay::Delaunay() {
  constexpr int64_t kOut = 2000;  // differences of up to 24,000: 12 * 24000^4 < 2^62
  points_ = {{-kOut, -kOut}, {kMost + kOut, -kOut}, {kMost + kOut, kMost + kOut}, {-kOut, kMost + kOut}};
  all_.push_back({{0, 1, 2}, {kNone, 1, kNone}});
  all_.push_back({{0, 2, 3}, {kNone, kNone, 0}});
}

// Twice the area; positive where (x, y) is to the left of a to b.
int64_t Delaunay::area(uint32_t a, uint32_t b, int64_t x, int64_t y) const {
  const auto &p = points_[a], &q = points_[b];
  return (q[0] - p[0]) * (y - p[1]) - (q[1] - p[1]) * (x - p[0]);
}

bool Delaunay::in_circle(const Triangle& t, int64_t x, int64_t y) const {
  std::array<std::array<int64_t, 3>, 3> m{};
  for (size_t i = 0; i < 3; ++i) {
    const int64_t dx = points_[t.corners[i]][0] - x, dy = points_[t.corners[i]][1] - y;
    m[i] = {dx, dy, dx * dx + dy * dy};
  }
  return m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]) + m[1][2] * (m[2][0] * m[0][1] - m[2][1] * m[0][0]) +
             m[2][2] * (m[0][0] * m[1][1] - m[0][1] * m[1][0]) >
         0;
}

// Walks towards the point; in a Delaunay triangulation such paths have no cycles (Edelsbrunner 1989).
size_t Delaunay::triangle_at(int64_t x, int64_t y) const {
  size_t at = last_;
  while (true) {
    const Triangle& t = all_[at];
    int32_t next = kNone;
    for (size_t i = 0; i < 3 && next == kNone; ++i)
      if (area(t.corners[(i + 1) % 3], t.corners[(i + 2) % 3], x, y) < 0) next = t.beyond[i];
    if (next == kNone) return at;
    at = static_cast<size_t>(next);
  }
}

uint32_t Delaunay::insert(int64_t x, int64_t y) {
  const size_t first = triangle_at(x, y);
  for (const uint32_t c : all_[first].corners)
    if (points_[c][0] == x && points_[c][1] == y) return c - kFrame;
  const auto point = static_cast<uint32_t>(points_.size());
  points_.push_back({x, y});
  // All triangles whose circumcircle contains the point are connected; their hole is filled with a fan.
  std::vector<size_t> hole = {first};
  all_[first].alive = false;
  struct Rim {
    uint32_t a, b;
    int32_t beyond;
  };
  std::vector<Rim> rim;
  for (size_t k = 0; k < hole.size(); ++k) {
    const Triangle t = all_[hole[k]];
    for (size_t i = 0; i < 3; ++i) {
      const int32_t next = t.beyond[i];
      if (next != kNone && !all_[static_cast<size_t>(next)].alive) continue;  // of the hole
      if (next != kNone && in_circle(all_[static_cast<size_t>(next)], x, y)) {
        all_[static_cast<size_t>(next)].alive = false;
        hole.push_back(static_cast<size_t>(next));
      } else {
        rim.push_back({t.corners[(i + 1) % 3], t.corners[(i + 2) % 3], next});
      }
    }
  }
  // A neighbor that joined the hole after its edge was seen is no rim.
  std::erase_if(rim, [&](const Rim& r) { return r.beyond != kNone && !all_[static_cast<size_t>(r.beyond)].alive; });
  for (const size_t gone : hole) free_.push_back(static_cast<int32_t>(gone));
  std::vector<int32_t> made;
  for (const Rim& r : rim) {
    int32_t at;
    if (!free_.empty()) {
      at = free_.back();
      free_.pop_back();
    } else {
      at = static_cast<int32_t>(all_.size());
      all_.emplace_back();
    }
    all_[static_cast<size_t>(at)] = {{r.a, r.b, point}, {kNone, kNone, r.beyond}, true};
    made.push_back(at);
    if (r.beyond == kNone) continue;
    Triangle& other = all_[static_cast<size_t>(r.beyond)];
    for (size_t i = 0; i < 3; ++i)
      if (other.corners[(i + 1) % 3] == r.b && other.corners[(i + 2) % 3] == r.a) other.beyond[i] = at;
  }
  for (const int32_t one : made)
    for (const int32_t other : made) {
      Triangle &t = all_[static_cast<size_t>(one)], &o = all_[static_cast<size_t>(other)];
      if (t.corners[1] == o.corners[0]) t.beyond[0] = other, o.beyond[1] = one;
    }
  last_ = static_cast<size_t>(made.front());
  return point - kFrame;
}

std::vector<std::array<uint32_t, 3>> Delaunay::triangles() const {
  std::vector<std::array<uint32_t, 3>> out;
  for (const Triangle& t : all_) {
    if (!t.alive || t.corners[0] < kFrame || t.corners[1] < kFrame || t.corners[2] < kFrame) continue;
    out.push_back({t.corners[0] - kFrame, t.corners[1] - kFrame, t.corners[2] - kFrame});
  }
  return out;
}

}  // namespace sinew::picture
