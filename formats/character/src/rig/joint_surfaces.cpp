// SPDX-License-Identifier: MIT
// Areas of faces to vertices, of vertices to joints.
#include "rig/joint_surfaces.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace sinew {
namespace {

double triangle_area(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double u[3] = {double{b.x} - a.x, double{b.y} - a.y, double{b.z} - a.z};
  const double v[3] = {double{c.x} - a.x, double{c.y} - a.y, double{c.z} - a.z};
  return 0.5 * std::hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]);
}

// [V] a third of the faces around a vertex; all alike where there is no surface.
std::vector<double> vertex_areas(const Character& c) {
  std::vector<double> areas(c.vertices.size(), 0.0);
  double whole = 0;
  for (size_t f = 0; f + 1 < c.face_offsets.size(); ++f) {
    const uint32_t* const corners = c.face_vertices.data() + c.face_offsets[f];
    for (size_t k = 2; k < c.face_offsets[f + 1] - c.face_offsets[f]; ++k) {
      const uint32_t triangle[3] = {corners[0], corners[k - 1], corners[k]};
      const double third = triangle_area(c.vertices[triangle[0]], c.vertices[triangle[1]], c.vertices[triangle[2]]) / 3;
      for (const uint32_t v : triangle) areas[v] += third;
      whole += third;
    }
  }
  if (!(whole > 0)) areas.assign(areas.size(), 1.0);
  return areas;
}

}  // namespace

JointSurfaces joint_surfaces(const Character& c) {
  if (c.influences.empty()) return {};
  const std::vector<double> areas = vertex_areas(c);
  std::vector<double> sums(c.joints.size(), 0.0);
  std::vector<std::array<double, 3>> middles(c.joints.size());
  double whole = 0;
  for (size_t v = 0; v < c.influences.size(); ++v) {
    const Vec3& p = c.vertices[v];
    for (const Influence& influence : c.influences[v]) {
      const double share = areas[v] * influence.weight;
      sums.at(influence.joint) += share;
      std::array<double, 3>& middle = middles[influence.joint];
      middle = {middle[0] + share * p.x, middle[1] + share * p.y, middle[2] + share * p.z};
      whole += share;
    }
  }
  if (!(whole > 0)) return {};
  JointSurfaces surfaces;
  for (size_t j = 0; j < sums.size(); ++j) {
    surfaces.shares.push_back(static_cast<float>(sums[j] / whole));
    const Vec3& at = c.joints[j].position;
    const float own[3] = {at.x, at.y, at.z};
    for (size_t axis = 0; axis < 3; ++axis)
      surfaces.centroids.push_back(sums[j] > 0 ? static_cast<float>(middles[j][axis] / sums[j]) : own[axis]);
  }
  return surfaces;
}

}  // namespace sinew
