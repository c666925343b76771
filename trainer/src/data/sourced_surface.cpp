// SPDX-License-Identifier: MIT
// Walls and specks are added behind what is there. Silhouettes: triangles to pixels, with the nearest and the farthest corner of
// each; the picture house makes the mesh.
#include "data/sourced_surface.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "sinew_character/picture/picture_mesh.hpp"
#include "sinew_formats/base/point.hpp"

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

// To the picture's axes, x right, y up, z to who looks, and back.
Point3 seen(SilhouetteView view, const Point3& p) {
  return view == SilhouetteView::kFromSide ? Point3{p[2], p[1], -p[0]} : p;
}
Point3 unseen(SilhouetteView view, const Point3& p) {
  return view == SilhouetteView::kFromSide ? Point3{-p[2], p[1], p[0]} : p;
}

constexpr uint32_t kMargin = 2;  // pixels around the figure

class Drawing {
 public:
  Drawing(const std::vector<Point3>& vertices, uint32_t pixels) {
    Point3 low = vertices[0], high = vertices[0];
    for (const Point3& p : vertices)
      for (size_t a = 0; a < 3; ++a) {
        low[a] = std::min(low[a], p[a]);
        high[a] = std::max(high[a], p[a]);
      }
    scale_ = pixels / std::max({high[0] - low[0], high[1] - low[1], 1e-12});
    left_ = low[0];
    top_ = high[1];
    width_ = static_cast<uint32_t>((high[0] - low[0]) * scale_) + 2 * kMargin + 1;
    height_ = static_cast<uint32_t>((high[1] - low[1]) * scale_) + 2 * kMargin + 1;
    const size_t all = size_t{width_} * height_;
    near_.assign(all, -std::numeric_limits<double>::infinity());
    far_.assign(all, std::numeric_limits<double>::infinity());
    near_corner_.assign(all, UINT32_MAX);
    far_corner_.assign(all, UINT32_MAX);
  }

  // Pixels whose middles are in the triangle.
  void fill(const std::array<Point3, 3>& corners, const std::array<uint32_t, 3>& numbers) {
    std::array<Point3, 3> c;
    for (size_t k = 0; k < 3; ++k) c[k] = {x_of(corners[k]), y_of(corners[k]), corners[k][2]};
    const double twice = (c[1][0] - c[0][0]) * (c[2][1] - c[0][1]) - (c[2][0] - c[0][0]) * (c[1][1] - c[0][1]);
    if (std::abs(twice) < 1e-12) return;
    const auto [x0, x1] = std::minmax({c[0][0], c[1][0], c[2][0]});
    const auto [y0, y1] = std::minmax({c[0][1], c[1][1], c[2][1]});
    for (auto y = static_cast<uint32_t>(y0); y <= static_cast<uint32_t>(y1); ++y)
      for (auto x = static_cast<uint32_t>(x0); x <= static_cast<uint32_t>(x1); ++x) {
        const double px = x + 0.5, py = y + 0.5;
        const double b1 = ((px - c[0][0]) * (c[2][1] - c[0][1]) - (c[2][0] - c[0][0]) * (py - c[0][1])) / twice;
        const double b2 = ((c[1][0] - c[0][0]) * (py - c[0][1]) - (px - c[0][0]) * (c[1][1] - c[0][1])) / twice;
        const std::array<double, 3> share = {1 - b1 - b2, b1, b2};
        if (std::min({share[0], share[1], share[2]}) < 0) continue;
        const double depth = share[0] * c[0][2] + share[1] * c[1][2] + share[2] * c[2][2];
        const auto largest = static_cast<size_t>(std::max_element(share.begin(), share.end()) - share.begin());
        put(size_t{y} * width_ + x, depth, numbers[largest]);
      }
  }

  Figure figure() const {
    Figure figure;
    figure.mask.width = width_;
    figure.mask.height = height_;
    for (const uint32_t corner : near_corner_) figure.mask.inside.push_back(corner != UINT32_MAX ? 1 : 0);
    return figure;
  }
  uint32_t width() const { return width_; }
  uint32_t height() const { return height_; }

  // A point of the mesh in pixels, x from the left edge, y up from the bottom edge, as a point of the picture's axes.
  Point3 point_of(const Vec3& p) const {
    return {left_ + (p.x - kMargin) / scale_, top_ - (height_ - double{p.y} - kMargin) / scale_, p.z / scale_};
  }
  // The corner that is drawn nearest to the point; the figure covers a pixel at least.
  uint32_t corner_at(const Vec3& p) const {
    const std::vector<uint32_t>& corners = p.z < 0 ? far_corner_ : near_corner_;
    const double x = p.x, y = height_ - double{p.y};
    for (int64_t reach = 0; reach < int64_t{width_} + height_; ++reach) {
      double least = std::numeric_limits<double>::infinity();
      uint32_t best = UINT32_MAX;
      for (int64_t v = int64_t(y) - reach; v <= int64_t(y) + reach; ++v)
        for (int64_t u = int64_t(x) - reach; u <= int64_t(x) + reach; ++u) {
          if (u < 0 || v < 0 || u >= width_ || v >= height_) continue;
          const uint32_t corner = corners[size_t(v) * width_ + size_t(u)];
          const double d = std::hypot(double(u) + 0.5 - x, double(v) + 0.5 - y);
          if (corner == UINT32_MAX || d >= least) continue;
          least = d;
          best = corner;
        }
      if (best != UINT32_MAX) return best;
    }
    return 0;
  }

 private:
  double x_of(const Point3& p) const { return (p[0] - left_) * scale_ + kMargin; }
  double y_of(const Point3& p) const { return (top_ - p[1]) * scale_ + kMargin; }
  void put(size_t pixel, double depth, uint32_t corner) {
    if (depth > near_[pixel]) {
      near_[pixel] = depth;
      near_corner_[pixel] = corner;
    }
    if (depth < far_[pixel]) {
      far_[pixel] = depth;
      far_corner_[pixel] = corner;
    }
  }

  double scale_ = 1, left_ = 0, top_ = 0;
  uint32_t width_ = 0, height_ = 0;
  std::vector<double> near_, far_;                  // [height x width]
  std::vector<uint32_t> near_corner_, far_corner_;  // [height x width] vertex
};

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
  Drawing drawing(vertices, pixels);
  for (const auto& t : surface.triangles) drawing.fill({vertices[t[0]], vertices[t[1]], vertices[t[2]]}, t);

  PictureFile picture;
  picture.name = "silhouette";
  picture.pixels.width = drawing.width();
  picture.pixels.height = drawing.height();
  PictureMeshOptions options;
  options.pixels = true;
  const Character mesh = picture_mesh(picture, drawing.figure(), options);

  SourcedSurface out;
  for (const Vec3& p : mesh.vertices) {
    out.vertices.push_back(unseen(view, drawing.point_of(p)));
    out.source.push_back(surface.source[drawing.corner_at(p)]);
  }
  for (size_t f = 0; f + 2 < mesh.face_vertices.size(); f += 3)
    out.triangles.push_back({mesh.face_vertices[f], mesh.face_vertices[f + 1], mesh.face_vertices[f + 2]});
  return out;
}

}  // namespace sinew
