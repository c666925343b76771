// SPDX-License-Identifier: MIT
// A figure becomes a closed mesh at the picture's position, as thick as it is wide.
#include "sinew_character/picture/picture_mesh.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "expect_error.hpp"
#include "picture/mesh/plane_mesh.hpp"
#include "small_pictures.hpp"

namespace sinew::test {
namespace {

// A trunk with two thin arms, and a hole.
bool in_body(int x, int y) {
  const bool trunk = in_disc(x, y, 150, 120, 60) && !in_disc(x, y, 150, 120, 20);
  return trunk || (y >= 116 && y < 124 && x >= 20 && x < 280 && !in_disc(x, y, 150, 120, 50));
}

struct Made {
  PictureFile picture;
  Figure figure;
};
Made made() {
  Made out = {picture_of(300, 200, [](int x, int y) { return in_body(x, y) ? kRed : kClear; }), {}};
  out.figure = find_figure(out.picture);
  return out;
}

TEST(PictureMesh, IsClosedAndTurnsOutwards) {
  const Made m = made();
  PictureMeshOptions options;
  options.pixels = true;
  const Character mesh = picture_mesh(m.picture, m.figure, options);
  EXPECT_GT(mesh.vertices.size(), 500u);
  EXPECT_LT(mesh.vertices.size(), 4000u);
  std::map<std::pair<uint32_t, uint32_t>, int> edges;
  double volume = 0;
  for (size_t f = 0; f < mesh.face_count(); ++f) {
    const uint32_t* c = &mesh.face_vertices[3 * f];
    for (size_t i = 0; i < 3; ++i) {
      ++edges[{c[i], c[(i + 1) % 3]}];
      --edges[{c[(i + 1) % 3], c[i]}];
    }
    const Vec3 &p = mesh.vertices[c[0]], &q = mesh.vertices[c[1]], &r = mesh.vertices[c[2]];
    volume += static_cast<double>(p.x * (q.y * r.z - q.z * r.y) + p.y * (q.z * r.x - q.x * r.z) +
                                  p.z * (q.x * r.y - q.y * r.x));
  }
  for (const auto& [edge, count] : edges) EXPECT_EQ(count, 0) << edge.first << " " << edge.second;
  EXPECT_GT(volume, 0);
}

TEST(PictureMesh, LiesWhereThePictureShowsIt) {
  const Made m = made();
  PictureMeshOptions options;
  options.pixels = true;
  const Character mesh = picture_mesh(m.picture, m.figure, options);
  double area = 0, expected = 0;
  for (size_t f = 0; f < mesh.face_count(); ++f) {
    const Vec3 &p = mesh.vertices[mesh.face_vertices[3 * f]], &q = mesh.vertices[mesh.face_vertices[3 * f + 1]],
               &r = mesh.vertices[mesh.face_vertices[3 * f + 2]];
    area += std::abs(static_cast<double>((q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x))) / 4;
  }
  for (int y = 0; y < 200; ++y)
    for (int x = 0; x < 300; ++x) expected += in_body(x, y) ? 1 : 0;
  EXPECT_NEAR(area, expected, 0.02 * expected);
  for (size_t c = 0; c < mesh.face_vertices.size(); ++c) {
    const Vec3& v = mesh.vertices[mesh.face_vertices[c]];
    EXPECT_NEAR(mesh.corner_uvs[c][0] * 300, v.x, 0.01f);
    EXPECT_NEAR(mesh.corner_uvs[c][1] * 200, v.y, 0.01f);
  }
}

TEST(PictureMesh, StandsOnTheFloorAndIsOneLong) {
  const Made m = made();
  const Character mesh = picture_mesh(m.picture, m.figure);
  float low = 9, high = -9, left = 9, right = -9;
  for (const Vec3& v : mesh.vertices) {
    low = std::min(low, v.y), high = std::max(high, v.y);
    left = std::min(left, v.x), right = std::max(right, v.x);
  }
  EXPECT_NEAR(low, 0, 1e-5f);
  EXPECT_NEAR(right - left, 1, 1e-5f);
  EXPECT_NEAR(right + left, 0, 1e-5f);
  PictureMeshOptions flat;
  flat.flat = true;
  for (const Vec3& v : picture_mesh(m.picture, m.figure, flat).vertices) EXPECT_LE(std::abs(v.z), 0.0051f);
}

TEST(Inflation, LimbsAreRound) {
  Mask bar{100, 40, std::vector<uint8_t>(4000, 0)};
  for (uint32_t y = 10; y < 29; ++y)
    for (uint32_t x = 5; x < 95; ++x) bar.inside[y * 100 + x] = 1;  // 19 thick
  const picture::Inflation inflation = picture::inflate(bar);
  for (const int off : {0, 3, 6, 9})
    EXPECT_NEAR(inflation.height.at(50, static_cast<uint32_t>(19 + off)),
                std::sqrt(100.0f - static_cast<float>(off * off)), 0.01f);
  EXPECT_EQ(inflation.height.at(50, 5), 0);
}

TEST(Delaunay, NoPointIsInsideOfACircle) {
  picture::Delaunay net;
  std::vector<std::array<double, 2>> points;
  uint32_t state = 7;
  const auto next = [&state] { return (state = state * 1664525u + 1013904223u) >> 16; };
  for (int i = 0; i < 150; ++i) {
    // A third on one line, a third on a grid.
    const int64_t x = i % 3 == 0   ? 5000
                      : i % 3 == 1 ? next() % 8 * 2500
                                   : next() % 20000,
                  y = i % 3 == 1 ? next() % 8 * 2500 : next() % 20000;
    if (net.insert(x, y) == points.size()) points.push_back({static_cast<double>(x), static_cast<double>(y)});
  }
  double area = 0;
  for (const auto& t : net.triangles()) {
    const auto &a = points[t[0]], &b = points[t[1]], &c = points[t[2]];
    const double twice = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    EXPECT_GT(twice, 0);
    area += twice / 2;
    for (const auto& p : points) {
      const double m[3][2] = {{a[0] - p[0], a[1] - p[1]}, {b[0] - p[0], b[1] - p[1]}, {c[0] - p[0], c[1] - p[1]}};
      double det = 0;
      for (int i = 0; i < 3; ++i) {
        const double* q = m[(i + 1) % 3];
        const double* r = m[(i + 2) % 3];
        det += (m[i][0] * m[i][0] + m[i][1] * m[i][1]) * (q[0] * r[1] - q[1] * r[0]);
      }
      EXPECT_LE(det, 1e-3 * 4e8);
    }
  }
  EXPECT_GT(area, 0.5 * 4e8);
}

}  // namespace
}  // namespace sinew::test
