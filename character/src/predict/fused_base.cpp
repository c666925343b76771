// SPDX-License-Identifier: MIT
// A pedestal that has fused with its figure, by the cross-sections of the whole.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "sinew_character/predict/scenery.hpp"
#include "sinew_character/rig/joint_mirror.hpp"
#include "sinew_character/rig/mesh_surface.hpp"
#include "sinew_formats/base/box.hpp"

namespace sinew {
namespace {

constexpr uint32_t kCells = 72;        // along the longest side
constexpr uint32_t kBlur = 2;          // layers between the base's edge and what stands on it
constexpr double kMostHigh = 0.35;     // of the whole
constexpr double kLeastWide = 0.2;     // of its height, in both horizontal directions
constexpr double kEven = 0.5;          // of the largest section of a base, the smallest
constexpr double kDrop = 0.55;         // of that, the largest section right above it
constexpr double kLeastConvex = 0.92;  // of its convex hull: two feet are not

struct Section {
  double cells = 0;   // that it has, what it encloses too
  double convex = 0;  // of its convex hull
  double wide = 0;    // the smaller side of its box
};

using Layer = std::vector<uint8_t>;  // [kCells x kCells]

int64_t turn_of(const std::array<int64_t, 2>& a, const std::array<int64_t, 2>& b, const std::array<int64_t, 2>& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

// Twice the area of the hull of points in order of x, then y.
double hull_area(std::vector<std::array<int64_t, 2>> points) {
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  std::vector<std::array<int64_t, 2>> hull;
  for (int side = 0; side < 2; ++side) {
    const size_t first = hull.size();
    for (const auto& p : points) {
      while (hull.size() >= first + 2 && turn_of(hull[hull.size() - 2], hull.back(), p) <= 0) hull.pop_back();
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  double twice = 0;
  for (size_t i = 0; i < hull.size(); ++i) {
    const auto &a = hull[i], &b = hull[(i + 1) % hull.size()];
    twice += static_cast<double>(a[0] * b[1] - a[1] * b[0]);
  }
  return twice;
}

Section section_of(const Layer& surface) {
  Layer outside(surface.size());
  std::vector<uint32_t> stack;
  const auto reach = [&](uint32_t at) {
    if (surface[at] != 0 || outside[at] != 0) return;
    outside[at] = 1;
    stack.push_back(at);
  };
  for (uint32_t i = 0; i < kCells; ++i)
    for (const uint32_t at : {i, (kCells - 1) * kCells + i, i * kCells, i * kCells + kCells - 1}) reach(at);
  while (!stack.empty()) {
    const uint32_t at = stack.back(), x = at % kCells, y = at / kCells;
    stack.pop_back();
    if (x > 0) reach(at - 1);
    if (x + 1 < kCells) reach(at + 1);
    if (y > 0) reach(at - kCells);
    if (y + 1 < kCells) reach(at + kCells);
  }
  Section out;
  std::vector<std::array<int64_t, 2>> corners;
  int64_t low[2] = {kCells, kCells}, high[2] = {0, 0};
  for (uint32_t at = 0; at < outside.size(); ++at) {
    if (outside[at] != 0) continue;
    ++out.cells;
    const int64_t cell[2] = {at % kCells, at / kCells};
    for (int a = 0; a < 2; ++a) {
      low[a] = std::min(low[a], cell[a]);
      high[a] = std::max(high[a], cell[a] + 1);
    }
    for (const auto& [dx, dy] : {std::pair{0, 0}, {1, 0}, {0, 1}, {1, 1}})
      corners.push_back({cell[0] + dx, cell[1] + dy});
  }
  if (corners.empty()) return out;
  out.wide = static_cast<double>(std::min(high[0] - low[0], high[1] - low[1]));
  out.convex = 2 * out.cells / std::max(hull_area(std::move(corners)), 1.0);
  return out;
}

// [layers] which cells of each the surface passes.
std::vector<Layer> surface_layers(const Character& mesh, const Box& box, Axis up, float cell) {
  const size_t u = axis_index(up), a = (u + 1) % 3, b = (u + 2) % 3;
  const auto coordinates = [](const Vec3& v) { return std::array<float, 3>{v.x, v.y, v.z}; };
  const std::array<float, 3> low = coordinates(box.low), high = coordinates(box.high);
  const auto count = static_cast<size_t>((high[u] - low[u]) / cell) + 1;
  std::vector<Layer> layers(count, Layer(size_t{kCells} * kCells));
  const auto mark = [&](const std::array<float, 3>& p) {
    const auto place = [&](size_t axis, size_t most) {
      return std::min(static_cast<size_t>(std::max(0.0f, (p[axis] - low[axis]) / cell)), most - 1);
    };
    layers[place(u, count)][place(b, kCells) * kCells + place(a, kCells)] = 1;
  };
  for (const auto& triangle : fan_triangles(mesh)) {
    std::array<std::array<float, 3>, 3> p;
    for (size_t k = 0; k < 3; ++k) p[k] = coordinates(mesh.vertices[triangle[k]]);
    float longest = 0;
    for (size_t k = 0; k < 3; ++k)
      for (size_t i = 0; i < 3; ++i) longest = std::max(longest, std::abs(p[k][i] - p[(k + 1) % 3][i]));
    const auto steps = static_cast<uint32_t>(2 * longest / cell) + 1;
    for (uint32_t i = 0; i <= steps; ++i)
      for (uint32_t j = 0; i + j <= steps; ++j) {
        const float s = static_cast<float>(i) / static_cast<float>(steps),
                    t = static_cast<float>(j) / static_cast<float>(steps);
        std::array<float, 3> at{};
        for (size_t k = 0; k < 3; ++k) at[k] = p[0][k] + s * (p[1][k] - p[0][k]) + t * (p[2][k] - p[0][k]);
        mark(at);
      }
  }
  return layers;
}

}  // namespace

std::vector<uint8_t> find_fused_base(const Character& mesh, Axis up) {
  if (mesh.vertices.empty()) return {};
  const Box box = box_of(mesh.vertices);
  const float cell = box.longest_side() / static_cast<float>(kCells);
  if (!(cell > 0)) return {};
  const std::vector<Layer> layers = surface_layers(mesh, box, up, cell);
  const auto most = static_cast<size_t>(kMostHigh * static_cast<double>(layers.size()));
  double largest = 0, smallest = 1e30;
  std::vector<Section> sections;
  for (size_t k = 0; k < most; ++k) sections.push_back(section_of(layers[k]));
  for (size_t top = 0; top + kBlur < sections.size(); ++top) {
    const Section& section = sections[top];
    largest = std::max(largest, section.cells);
    smallest = std::min(smallest, section.cells);
    const bool slab = smallest >= kEven * largest && section.convex >= kLeastConvex &&
                      section.wide >= kLeastWide * static_cast<double>(layers.size());
    if (!slab) return {};
    if (sections[top + kBlur].cells > kDrop * smallest) continue;
    const float end = component(box.low, axis_index(up)) + cell * static_cast<float>(top + kBlur);
    std::vector<uint8_t> scenery(mesh.vertices.size());
    for (size_t v = 0; v < scenery.size(); ++v) scenery[v] = component(mesh.vertices[v], axis_index(up)) < end ? 1 : 0;
    return scenery;
  }
  return {};
}

}  // namespace sinew
