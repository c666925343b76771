// SPDX-License-Identifier: MIT
// Triangles to pixels, with the nearest and the farthest corner of each.
#include "sinew_character/picture/mesh_drawing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sinew_character/picture/picture_mesh.hpp"

namespace sinew {
namespace {

constexpr uint32_t kEdgePixels = 2;  // pixels around the figure
constexpr double kNoDepth = std::numeric_limits<double>::infinity();

}  // namespace

MeshDrawing::MeshDrawing(const std::vector<Point3>& vertices, const std::vector<std::array<uint32_t, 3>>& triangles,
                         uint32_t pixels) {
  Point3 low = vertices[0], high = vertices[0];
  for (const Point3& p : vertices)
    for (size_t a = 0; a < 3; ++a) {
      low[a] = std::min(low[a], p[a]);
      high[a] = std::max(high[a], p[a]);
    }
  scale_ = pixels / std::max({high[0] - low[0], high[1] - low[1], 1e-12});
  left_ = low[0];
  top_ = high[1];
  width_ = static_cast<uint32_t>((high[0] - low[0]) * scale_) + 2 * kEdgePixels + 1;
  height_ = static_cast<uint32_t>((high[1] - low[1]) * scale_) + 2 * kEdgePixels + 1;
  const size_t all = size_t{width_} * height_;
  near_.assign(all, -kNoDepth);
  far_.assign(all, kNoDepth);
  near_corner_.assign(all, UINT32_MAX);
  far_corner_.assign(all, UINT32_MAX);
  for (const auto& t : triangles) fill({vertices[t[0]], vertices[t[1]], vertices[t[2]]}, t);
}

double MeshDrawing::x_of(double x) const { return (x - left_) * scale_ + kEdgePixels; }
double MeshDrawing::y_of(double y) const { return (top_ - y) * scale_ + kEdgePixels; }

// Pixels whose middles are in the triangle.
void MeshDrawing::fill(const std::array<Point3, 3>& corners, const std::array<uint32_t, 3>& numbers) {
  std::array<Point3, 3> c;
  for (size_t k = 0; k < 3; ++k) c[k] = {x_of(corners[k][0]), y_of(corners[k][1]), corners[k][2]};
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

void MeshDrawing::put(size_t pixel, double depth, uint32_t corner) {
  if (depth > near_[pixel]) {
    near_[pixel] = depth;
    near_corner_[pixel] = corner;
  }
  if (depth < far_[pixel]) {
    far_[pixel] = depth;
    far_corner_[pixel] = corner;
  }
}

Figure MeshDrawing::figure() const {
  Figure figure;
  figure.mask.width = width_;
  figure.mask.height = height_;
  for (const uint32_t corner : near_corner_) figure.mask.inside.push_back(corner != UINT32_MAX ? 1 : 0);
  return figure;
}

Character MeshDrawing::round_mesh() const {
  PictureFile picture;
  picture.name = "silhouette";
  picture.pixels.width = width_;
  picture.pixels.height = height_;
  PictureMeshOptions options;
  options.pixels = true;
  Character mesh = picture_mesh(picture, figure(), options);
  for (Vec3& p : mesh.vertices)
    p = to_vec3({left_ + (static_cast<double>(p.x) - kEdgePixels) / scale_,
                 top_ - (height_ - static_cast<double>(p.y) - kEdgePixels) / scale_,
                 static_cast<double>(p.z) / scale_});
  return mesh;
}

uint32_t MeshDrawing::corner_at(const Vec3& p) const {
  const std::vector<uint32_t>& corners = p.z < 0 ? far_corner_ : near_corner_;
  const double x = x_of(static_cast<double>(p.x)), y = y_of(static_cast<double>(p.y));
  for (int64_t reach = 0; reach < int64_t{width_} + height_; ++reach) {
    double least = kNoDepth;
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

}  // namespace sinew
