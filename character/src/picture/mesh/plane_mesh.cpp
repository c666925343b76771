// SPDX-License-Identifier: MIT
// A silhouette in triangles, and how thick it is where.
#include "picture/mesh/plane_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace sinew::picture {
namespace {

constexpr double kLeastSpacing = 1.5;  // pixels
constexpr double kTolerance = 0.6;     // of the outline, pixels
constexpr int kRounds = 5;

// Where distances to the outline have their ridge: a limb's middle line.
bool on_ridge(const Grid<float>& depth, uint32_t x, uint32_t y) {
  if (x == 0 || y == 0 || x + 1 >= depth.width || y + 1 >= depth.height) return false;
  const float gx = 0.5f * (depth.at(x + 1, y) - depth.at(x - 1, y)),
              gy = 0.5f * (depth.at(x, y + 1) - depth.at(x, y - 1));
  return std::hypot(gx, gy) < 0.75f;
}

// No two nearer than `spacing`, from the middle lines outwards; near the outline on middle lines alone.
std::vector<Point2> inner_points(const Inflation& inflation, double spacing) {
  const Grid<float>& depth = inflation.depth;
  struct Candidate {
    float depth;
    uint32_t at;
  };
  std::vector<Candidate> candidates;
  for (uint32_t y = 0; y < depth.height; ++y)
    for (uint32_t x = 0; x < depth.width; ++x)
      if (const float d = depth.at(x, y);
          d >= 1.2f && (static_cast<double>(d) >= 0.6 * spacing || on_ridge(depth, x, y)))
        candidates.push_back({d, static_cast<uint32_t>(depth.index(x, y))});
  std::sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
    return a.depth != b.depth ? a.depth > b.depth : a.at < b.at;
  });
  const auto columns = static_cast<size_t>(depth.width / spacing) + 3,
             rows = static_cast<size_t>(depth.height / spacing) + 3;
  std::vector<std::vector<uint32_t>> cells(columns * rows);
  std::vector<Point2> points;
  for (const Candidate& one : candidates) {
    const Point2 p = {one.at % depth.width + 0.5, static_cast<double>(one.at / depth.width) + 0.5};
    const size_t cx = static_cast<size_t>(p[0] / spacing) + 1, cy = static_cast<size_t>(p[1] / spacing) + 1;
    bool free = true;
    for (size_t y = cy - 1; y <= cy + 1 && free; ++y)
      for (size_t x = cx - 1; x <= cx + 1 && free; ++x)
        for (const uint32_t other : cells[y * columns + x])
          free = free && std::hypot(points[other][0] - p[0], points[other][1] - p[1]) >= spacing;
    if (!free) continue;
    cells[cy * columns + cx].push_back(static_cast<uint32_t>(points.size()));
    points.push_back(p);
  }
  return points;
}

// Points of a triangulation, in whole steps of its grid.
class Net {
 public:
  explicit Net(const Mask& mask) : scale_(static_cast<double>(Delaunay::kMost) / std::max(mask.width, mask.height)) {}
  uint32_t insert(const Point2& p) {
    const uint32_t number = net_.insert(std::llround(p[0] * scale_), std::llround(p[1] * scale_));
    if (number == points_.size()) points_.push_back(p);
    return number;
  }
  std::vector<std::array<uint32_t, 3>> triangles() const { return net_.triangles(); }
  const std::vector<Point2>& points() const { return points_; }

 private:
  double scale_;
  Delaunay net_;
  std::vector<Point2> points_;
};

using Edge = std::pair<uint32_t, uint32_t>;
Edge edge_of(uint32_t a, uint32_t b) { return {std::min(a, b), std::max(a, b)}; }

// Outlines whose every line is an edge: the points in the middle of those that are none are added, round by round.
void insert_outlines(const std::vector<Loop>& loops, double spacing, Net* net) {
  std::vector<std::vector<size_t>> kept;
  for (const Loop& loop : loops) kept.push_back(simplified(loop, kTolerance, spacing));
  for (size_t l = 0; l < loops.size(); ++l)
    for (const size_t i : kept[l]) net->insert(loops[l][i]);
  for (int round = 0; round < kRounds; ++round) {
    std::set<Edge> edges;
    for (const auto& t : net->triangles())
      for (size_t i = 0; i < 3; ++i) edges.insert(edge_of(t[i], t[(i + 1) % 3]));
    bool added = false;
    for (size_t l = 0; l < loops.size(); ++l) {
      const size_t n = loops[l].size();
      std::vector<size_t> more;
      for (size_t k = 0; k < kept[l].size(); ++k) {
        const size_t a = kept[l][k], b = k + 1 < kept[l].size() ? kept[l][k + 1] : kept[l][0] + n;
        more.push_back(a);
        if (b - a < 2) continue;
        const uint32_t from = net->insert(loops[l][a]), to = net->insert(loops[l][b % n]);
        if (from == to || edges.count(edge_of(from, to)) > 0) continue;
        const size_t middle = (a + b) / 2;
        if (middle >= n) continue;
        net->insert(loops[l][middle]);
        more.push_back(middle);
        added = true;
      }
      kept[l] = std::move(more);
    }
    if (!added) break;
  }
}

PlaneMesh mesh_at(const Mask& mask, const std::vector<Loop>& loops, const Inflation& inflation, double spacing) {
  Net net(mask);
  for (const Point2& p : inner_points(inflation, spacing)) net.insert(p);
  insert_outlines(loops, spacing, &net);
  // Inside by the middle; points that no triangle has are left out.
  PlaneMesh out;
  std::vector<uint32_t> numbers(net.points().size(), UINT32_MAX);
  std::map<Edge, int> uses;
  for (std::array<uint32_t, 3> t : net.triangles()) {
    Point2 middle = {0, 0};
    for (const uint32_t corner : t)
      for (size_t k = 0; k < 2; ++k) middle[k] += net.points()[corner][k] / 3;
    if (!mask.at(static_cast<int64_t>(std::floor(middle[0])), static_cast<int64_t>(std::floor(middle[1])))) continue;
    for (uint32_t& corner : t) {
      if (numbers[corner] == UINT32_MAX) {
        numbers[corner] = static_cast<uint32_t>(out.points.size());
        out.points.push_back(net.points()[corner]);
      }
      corner = numbers[corner];
    }
    out.triangles.push_back(t);
    for (size_t i = 0; i < 3; ++i) ++uses[edge_of(t[i], t[(i + 1) % 3])];
  }
  out.rim.assign(out.points.size(), 0);
  for (const auto& [edge, count] : uses)
    if (count == 1) out.rim[edge.first] = out.rim[edge.second] = 1;
  return out;
}

}  // namespace

PlaneMesh triangulate(const Mask& mask, const Inflation& inflation, size_t wanted) {
  const std::vector<Loop> loops = contours_of(mask);
  double area = 0, around = 0;
  for (const uint8_t in : mask.inside) area += in;
  for (const Loop& loop : loops) around += static_cast<double>(loop.size());
  // wanted = around / s + area / (0.87 s^2), a grid of even triangles.
  const auto count = static_cast<double>(wanted);
  double spacing = (around + std::sqrt(around * around + 4 * count * area / 0.87)) / (2 * count);
  spacing = std::max(kLeastSpacing, spacing);
  PlaneMesh out = mesh_at(mask, loops, inflation, spacing);
  for (int round = 0; round < 3 && out.points.size() > 2 * wanted; ++round)
    out = mesh_at(mask, loops, inflation, spacing *= 1.4);
  return out;
}

// A ball about q with radius d(q), the distance to the outline, is sqrt(d(q)^2 - |p - q|^2) high at p: the largest of these is one more spread of
// parabolas, of -d^2. A limb of any width has a round cross-section.
Inflation inflate(const Mask& mask) {
  Inflation out = {squared_distance(mask, true), {}};
  out.height = out.depth;
  for (float& v : out.height.values) v = v > 0 ? -v : kFar;
  spread_parabolas(&out.height);
  for (size_t i = 0; i < mask.inside.size(); ++i) {
    const bool in = mask.inside[i] != 0;
    out.height.values[i] = in ? std::sqrt(std::max(0.0f, -out.height.values[i])) : 0;
    out.depth.values[i] = in ? std::sqrt(out.depth.values[i]) : 0;
  }
  return out;
}

}  // namespace sinew::picture
