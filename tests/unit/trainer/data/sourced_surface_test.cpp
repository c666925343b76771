// SPDX-License-Identifier: MIT
// Silhouettes of boxes: where the box is, as wide and as high, with the corners that are seen from either side.
#include "data/sourced_surface.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "sinew_formats/base/point.hpp"

namespace sinew {
namespace {

// Corners are numbered by their bits: 1 x, 2 y, 4 z. Vertex v has the source 10 + v.
SourcedSurface box(const Point3& low, const Point3& high) {
  SourcedSurface out;
  for (uint32_t c = 0; c < 8; ++c) {
    out.vertices.push_back({c & 1 ? high[0] : low[0], c & 2 ? high[1] : low[1], c & 4 ? high[2] : low[2]});
    out.source.push_back(10 + c);
  }
  constexpr uint32_t kQuads[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                     {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
  for (const auto& q : kQuads) {
    out.triangles.push_back({q[0], q[1], q[2]});
    out.triangles.push_back({q[0], q[2], q[3]});
  }
  return out;
}

std::array<Point3, 2> extent(const SourcedSurface& s) {
  std::array<Point3, 2> e = {s.vertices[0], s.vertices[0]};
  for (const Point3& p : s.vertices)
    for (size_t a = 0; a < 3; ++a) {
      e[0][a] = std::min(e[0][a], p[a]);
      e[1][a] = std::max(e[1][a], p[a]);
    }
  return e;
}

constexpr double kPixel = 1.6 / 160;

TEST(Silhouette, FromTheFrontIsWhereTheSurfaceIs) {
  const SourcedSurface surface = box({0.1, 0.0, -0.2}, {0.7, 1.6, 0.5});
  ASSERT_EQ(broad_view(surface), SilhouetteView::kFromSide);
  const SourcedSurface drawn = silhouette_of(surface, SilhouetteView::kFromFront, 160);
  const auto [low, high] = extent(drawn);
  EXPECT_NEAR(low[0], 0.1, 1.5 * kPixel);
  EXPECT_NEAR(high[0], 0.7, 1.5 * kPixel);
  EXPECT_NEAR(low[1], 0.0, 1.5 * kPixel);
  EXPECT_NEAR(high[1], 1.6, 1.5 * kPixel);
  EXPECT_NEAR(low[2], -high[2], 1e-9);  // the picture's plane is the middle
  for (size_t v = 0; v < drawn.vertices.size(); ++v) {
    const Point3& p = drawn.vertices[v];
    const uint32_t corner = drawn.source[v] - 10;
    if (std::abs(p[0] - 0.4) > 0.2 && std::abs(p[1] - 0.8) > 0.6) {  // beyond the diagonals of the faces
      EXPECT_EQ(corner & 1, p[0] > 0.4 ? 1u : 0u) << v;
      EXPECT_EQ(corner >> 1 & 1, p[1] > 0.8 ? 1u : 0u) << v;
    }
    EXPECT_EQ(corner >> 2, p[2] < 0 ? 0u : 1u) << v;
  }
}

// The front is to the picture's right, and who looks stands at the side of -x.
TEST(Silhouette, FromTheSideIsSeenWithTheFrontToTheRight) {
  const SourcedSurface drawn = silhouette_of(box({-0.3, 0.0, 0.2}, {0.3, 0.5, 1.8}), SilhouetteView::kFromSide, 160);
  const auto [low, high] = extent(drawn);
  EXPECT_NEAR(low[2], 0.2, 1.5 * kPixel);
  EXPECT_NEAR(high[2], 1.8, 1.5 * kPixel);
  EXPECT_NEAR(high[1], 0.5, 1.5 * kPixel);
  EXPECT_NEAR(low[0], -high[0], 1e-9);
  for (size_t v = 0; v < drawn.vertices.size(); ++v)
    EXPECT_EQ((drawn.source[v] - 10) & 1, drawn.vertices[v][0] > 0 ? 1u : 0u) << v;
}

TEST(Silhouette, FacesLookOutward) {
  const SourcedSurface drawn = silhouette_of(box({0, 0, 0}, {1, 1, 1}), SilhouetteView::kFromFront, 64);
  double volume = 0;
  for (const auto& t : drawn.triangles) {
    const Point3 &a = drawn.vertices[t[0]], &b = drawn.vertices[t[1]], &c = drawn.vertices[t[2]];
    volume +=
        a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
  }
  EXPECT_GT(volume, 0.1);
}

}  // namespace
}  // namespace sinew
