// SPDX-License-Identifier: MIT
// The border of a mask as closed lines, stairs smoothed away.
#include <algorithm>
#include <cmath>
#include <utility>

#include "picture/mesh/plane_mesh.hpp"

namespace sinew::picture {
namespace {

constexpr int kStepX[] = {1, 0, -1, 0}, kStepY[] = {0, 1, 0, -1};
constexpr size_t kLeastEdges = 12;

// Weights 1 2 1, three times: stairs of single pixels become lines, corners stay within half a pixel.
void smooth(Loop* loop) {
  const size_t n = loop->size();
  for (int round = 0; round < 3; ++round) {
    Loop out(n);
    for (size_t i = 0; i < n; ++i) {
      const Point2 &a = (*loop)[(i + n - 1) % n], &b = (*loop)[i], &c = (*loop)[(i + 1) % n];
      for (size_t k = 0; k < 2; ++k) out[i][k] = 0.25 * a[k] + 0.5 * b[k] + 0.25 * c[k];
    }
    *loop = std::move(out);
  }
}

double distance_to_line(const Point2& p, const Point2& a, const Point2& b) {
  const double dx = b[0] - a[0], dy = b[1] - a[1], l = std::hypot(dx, dy);
  if (l < 1e-12) return std::hypot(p[0] - a[0], p[1] - a[1]);
  return std::abs(dx * (p[1] - a[1]) - dy * (p[0] - a[0])) / l;
}

}  // namespace

std::vector<Loop> contours_of(const Mask& mask) {
  const uint32_t width = mask.width + 1;                             // of the grid of pixels' corners
  std::vector<uint8_t> edges(size_t{width} * (mask.height + 1), 0);  // bit d: an edge leaves in direction d
  const auto corner = [&](int64_t x, int64_t y) { return static_cast<size_t>(y) * width + static_cast<size_t>(x); };
  for (int64_t y = 0; y < int64_t{mask.height}; ++y)
    for (int64_t x = 0; x < int64_t{mask.width}; ++x) {
      if (!mask.at(x, y)) continue;
      if (!mask.at(x, y - 1)) edges[corner(x, y)] |= 1;
      if (!mask.at(x + 1, y)) edges[corner(x + 1, y)] |= 2;
      if (!mask.at(x, y + 1)) edges[corner(x + 1, y + 1)] |= 4;
      if (!mask.at(x - 1, y)) edges[corner(x, y + 1)] |= 8;
    }
  std::vector<Loop> loops;
  for (size_t first = 0; first < edges.size(); ++first)
    while (edges[first] != 0) {
      Loop loop;
      auto x = static_cast<int64_t>(first % width), y = static_cast<int64_t>(first / width);
      int direction = 0;
      while ((edges[first] >> direction & 1) == 0) ++direction;
      while (true) {
        uint8_t& here = edges[corner(x, y)];
        // Tries the right first: pixels that meet only at a corner are not connected.
        bool found = false;
        for (const int turn : {1, 0, 3}) {
          const int next = (direction + turn) % 4;
          if ((here >> next & 1) == 0) continue;
          if (!loop.empty() || turn != 3) direction = next;
          found = true;
          break;
        }
        if (!found) break;
        here = static_cast<uint8_t>(here & ~(1 << direction));
        loop.push_back(
            {static_cast<double>(x) + 0.5 * kStepX[direction], static_cast<double>(y) + 0.5 * kStepY[direction]});
        x += kStepX[direction];
        y += kStepY[direction];
      }
      if (loop.size() < kLeastEdges) continue;
      smooth(&loop);
      loops.push_back(std::move(loop));
    }
  return loops;
}

std::vector<size_t> simplified(const Loop& loop, double tolerance, double longest) {
  const size_t n = loop.size();
  size_t far = 0;
  for (size_t i = 1; i < n; ++i)
    if (std::hypot(loop[i][0] - loop[0][0], loop[i][1] - loop[0][1]) >
        std::hypot(loop[far][0] - loop[0][0], loop[far][1] - loop[0][1]))
      far = i;
  std::vector<uint8_t> kept(n, 0);
  kept[0] = kept[far] = 1;
  std::vector<std::pair<size_t, size_t>> todo = {{0, far}, {far, n}};  // n: point 0 again
  while (!todo.empty()) {
    const auto [a, b] = todo.back();
    todo.pop_back();
    if (b - a < 2) continue;
    const Point2 &from = loop[a], &to = loop[b % n];
    size_t worst = 0;
    double off = tolerance;
    for (size_t i = a + 1; i < b; ++i)
      if (const double d = distance_to_line(loop[i], from, to); d > off) off = d, worst = i;
    if (worst == 0 && std::hypot(to[0] - from[0], to[1] - from[1]) > longest) worst = (a + b) / 2;
    if (worst == 0) continue;
    kept[worst] = 1;
    todo.push_back({a, worst});
    todo.push_back({worst, b});
  }
  std::vector<size_t> out;
  for (size_t i = 0; i < n; ++i)
    if (kept[i] != 0) out.push_back(i);
  return out;
}

}  // namespace sinew::picture
