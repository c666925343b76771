// SPDX-License-Identifier: MIT
// Areas of faces to vertices, of vertices to joints.
#include "rig/joint_surfaces.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "sinew_formats/vertex_areas.hpp"

namespace sinew {
namespace {

// [V] as vertex_areas(); all alike where there is no surface.
std::vector<double> shares_of_vertices(const Character& c) {
  std::vector<double> areas = vertex_areas(c);
  if (!std::any_of(areas.begin(), areas.end(), [](double area) { return area > 0; })) areas.assign(areas.size(), 1.0);
  return areas;
}

}  // namespace

JointSurfaces joint_surfaces(const Character& c) {
  if (c.influences.empty()) return {};
  const std::vector<double> areas = shares_of_vertices(c);
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
