// SPDX-License-Identifier: MIT
// Walls and specks, added behind what is there.
#include "data/rough_surface.hpp"

#include <Eigen/Dense>

namespace sinew {

using Eigen::Vector3d;

void add_wall(Random* random, SourcedSurface* surface) {
  const double thickness = random->uniform(0.004, 0.02);
  const size_t count = surface->vertices.size(), faces = surface->triangles.size();
  std::vector<Vector3d> normals(count, Vector3d::Zero());
  const auto at = [&](uint32_t v) { return Vector3d(surface->vertices[v].data()); };
  for (const auto& t : surface->triangles) {
    const Vector3d normal = (at(t[1]) - at(t[0])).cross(at(t[2]) - at(t[0]));
    for (const uint32_t v : t) normals[v] += normal;
  }
  for (uint32_t v = 0; v < count; ++v) {
    const Vector3d inside = at(v) - thickness * normals[v].normalized();
    surface->vertices.push_back({inside.x(), inside.y(), inside.z()});
    surface->source.push_back(surface->source[v]);
  }
  const auto shift = static_cast<uint32_t>(count);
  for (size_t f = 0; f < faces; ++f) {
    const auto t = surface->triangles[f];
    surface->triangles.push_back({t[0] + shift, t[2] + shift, t[1] + shift});
  }
}

void add_specks(Random* random, SourcedSurface* surface) {
  const auto count = static_cast<uint32_t>(surface->vertices.size());
  for (uint32_t n = 10 + random->below(71); n > 0; --n) {
    const uint32_t v = random->below(count), first = static_cast<uint32_t>(surface->vertices.size());
    std::array<double, 3> middle = surface->vertices[v];
    for (double& x : middle) x += random->uniform(-0.03, 0.03);
    for (uint32_t corner = 0; corner < 4; ++corner) {
      std::array<double, 3> p = middle;
      for (double& x : p) x += 0.002 * random->normal();
      surface->vertices.push_back(p);
      surface->source.push_back(surface->source[v]);
    }
    for (const std::array<uint32_t, 3>& t : {std::array<uint32_t, 3>{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}})
      surface->triangles.push_back({first + t[0], first + t[1], first + t[2]});
  }
}

}  // namespace sinew
