// SPDX-License-Identifier: MIT
// Points against a surface by signed crossings of lines along two axes; triangles lie in a grid across each.
#include "sinew_character/springs/swing_inside.hpp"

#include <algorithm>
#include <cmath>

#include "sinew_character/pose/pose.hpp"
#include "sinew_character/rig/mesh_surface.hpp"
#include "sinew_formats/base/box.hpp"
#include "springs/body_skin.hpp"

namespace sinew {
namespace {

constexpr size_t kFrames = 24;
constexpr double kLeastWeight = 0.1;
constexpr size_t kCells = 128;  // of the grid, along each axis

// Lines along one axis.
class Lines {
 public:
  Lines(const std::vector<Vec3>& vertices, const std::vector<std::array<uint32_t, 3>>& triangles, size_t axis)
      : vertices_(vertices),
        triangles_(triangles),
        axis_(axis),
        across_{(axis + 1) % 3, (axis + 2) % 3},
        cells_(kCells * kCells) {
    const Box box = box_of(vertices);
    const Point3 low = point(box.low), high = point(box.high);
    for (size_t i = 0; i < 2; ++i) {
      low_[i] = low[across_[i]];
      step_[i] = std::max(1e-12, high[across_[i]] - low_[i]) / kCells;
    }
    for (uint32_t t = 0; t < triangles.size(); ++t) {
      std::array<size_t, 2> from = {kCells - 1, kCells - 1}, to = {0, 0};
      for (const uint32_t v : triangles[t]) {
        const Point3 p = point(vertices[v]);
        for (size_t i = 0; i < 2; ++i) {
          const size_t at = cell(p[across_[i]], i);
          from[i] = std::min(from[i], at);
          to[i] = std::max(to[i], at);
        }
      }
      for (size_t y = from[0]; y <= to[0]; ++y)
        for (size_t z = from[1]; z <= to[1]; ++z) cells_[y * kCells + z].push_back(t);
    }
  }

  bool encloses(const Vec3& p) const {
    const Point3 at_point = point(p);
    const size_t u = across_[0], v = across_[1];
    const double x = at_point[axis_], y = at_point[u] + 1e-7 * step_[0],
                 z = at_point[v] + 1e-7 * step_[1];  // not through an edge
    int before = 0, beyond = 0;
    for (const uint32_t t : cells_[cell(y, 0) * kCells + cell(z, 1)]) {
      const Point3 a = point(vertices_[triangles_[t][0]]), b = point(vertices_[triangles_[t][1]]),
                   c = point(vertices_[triangles_[t][2]]);
      const auto side = [&](const Point3& from, const Point3& to) {
        return (to[u] - from[u]) * (z - from[v]) - (to[v] - from[v]) * (y - from[u]);
      };
      const double wa = side(b, c), wb = side(c, a), wc = side(a, b), sum = wa + wb + wc;
      const bool hit = (wa >= 0 && wb >= 0 && wc >= 0) || (wa <= 0 && wb <= 0 && wc <= 0);
      if (!hit || sum == 0) continue;
      const double at = (wa * a[axis_] + wb * b[axis_] + wc * c[axis_]) / sum;
      (at < x ? before : beyond) += sum > 0 ? 1 : -1;
    }
    return before != 0 && beyond != 0;
  }

 private:
  size_t cell(double at, size_t i) const {
    return static_cast<size_t>(std::clamp((at - low_[i]) / step_[i], 0.0, kCells - 1.0));
  }

  const std::vector<Vec3>& vertices_;
  const std::vector<std::array<uint32_t, 3>>& triangles_;
  const size_t axis_;
  const std::array<size_t, 2> across_;
  std::array<double, 2> low_{}, step_{};
  std::vector<std::vector<uint32_t>> cells_;  // across the lines: triangles
};

// Bodies may be open, such as where clothes hide them: one line may pass such a hole.
class Surface {
 public:
  Surface(const std::vector<Vec3>& vertices, const std::vector<std::array<uint32_t, 3>>& triangles)
      : x_(vertices, triangles, 0), z_(vertices, triangles, 2) {}
  bool encloses(const Vec3& p) const { return x_.encloses(p) && z_.encloses(p); }

 private:
  Lines x_, z_;
};

}  // namespace

std::vector<uint8_t> swinging_vertices(const Character& character, const Springs& springs) {
  std::vector<uint8_t> swings(character.vertices.size(), 0);
  std::vector<uint8_t> turns(character.joints.size(), 0);
  for (const SpringChain& chain : springs.chains)
    for (size_t i = 0; i < chain.turning_joints(); ++i) turns[chain.joints[i].joint] = 1;
  for (size_t v = 0; v < swings.size(); ++v) {
    double weight = 0;
    for (const Influence& one : character.influences[v])
      if (turns[one.joint] != 0) weight += static_cast<double>(one.weight);
    if (weight >= kLeastWeight) swings[v] = 1;
  }
  return swings;
}

InsideShare inside_share(const Character& character, const std::vector<uint8_t>& swings, const Motion& motion,
                         const Clip& clip) {
  InsideShare out;
  std::vector<std::array<uint32_t, 3>> body;
  for (const auto& triangle : fan_triangles(character))
    if (std::none_of(triangle.begin(), triangle.end(), [&](uint32_t v) { return swings[v] != 0; }))
      body.push_back(triangle);
  const Surface rest(character.vertices, body);
  std::vector<uint32_t> outside;
  for (uint32_t v = 0; v < swings.size(); ++v) {
    if (swings[v] == 0) continue;
    if (rest.encloses(character.vertices[v]))
      ++out.at_rest;
    else
      outside.push_back(v);
  }
  const size_t count = std::min(kFrames, clip.frames.size());
  if (outside.empty() || count == 0) return out;
  size_t inside = 0;
  for (size_t i = 0; i < count; ++i) {
    const MotionFrame& frame = clip.frames[i * clip.frames.size() / count];
    const Character posed = apply_pose(character, motion_palette(motion, frame, character.joints.size()));
    const Surface surface(posed.vertices, body);
    for (const uint32_t v : outside) inside += surface.encloses(posed.vertices[v]) ? 1 : 0;
  }
  out.share = static_cast<double>(inside) / static_cast<double>(count * outside.size());
  return out;
}

}  // namespace sinew
