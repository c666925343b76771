// SPDX-License-Identifier: MIT
// Walls and specks are added behind what is there.
#include "data/sourced_surface.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <vector>

#include "sinew_character/picture/mesh_drawing.hpp"

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

namespace {

// World axes to image axes (x right, y up, z to the viewer), and back.
Point3 seen(SilhouetteView view, const Point3& p) {
  return view == SilhouetteView::kFromSide ? Point3{p[2], p[1], -p[0]} : p;
}
Point3 unseen(SilhouetteView view, const Point3& p) {
  return view == SilhouetteView::kFromSide ? Point3{-p[2], p[1], p[0]} : p;
}

}  // namespace

SilhouetteView broad_view(const SourcedSurface& surface) {
  std::array<std::vector<double>, 2> along;
  for (const Point3& p : surface.vertices) {
    along[0].push_back(p[0]);
    along[1].push_back(p[2]);
  }
  const auto extent = [](const std::vector<double>& v) {
    const auto [low, high] = std::minmax_element(v.begin(), v.end());
    return *high - *low;
  };
  return extent(along[1]) > extent(along[0]) ? SilhouetteView::kFromSide : SilhouetteView::kFromFront;
}

SourcedSurface silhouette_of(const SourcedSurface& surface, SilhouetteView view, uint32_t pixels) {
  std::vector<Point3> vertices;
  for (const Point3& p : surface.vertices) vertices.push_back(seen(view, p));
  const MeshDrawing drawing(vertices, surface.triangles, pixels);
  const Character mesh = drawing.round_mesh();
  SourcedSurface out;
  for (const Vec3& p : mesh.vertices) {
    out.vertices.push_back(unseen(view, point(p)));
    out.source.push_back(surface.source[drawing.corner_at(p)]);
  }
  for (size_t f = 0; f + 2 < mesh.face_vertices.size(); f += 3)
    out.triangles.push_back({mesh.face_vertices[f], mesh.face_vertices[f + 1], mesh.face_vertices[f + 2]});
  return out;
}

}  // namespace sinew
