// SPDX-License-Identifier: MIT
// Layouts and pixels of vertex animation textures.
#include "sinew_character/crowd/vertex_textures.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "expect_error.hpp"
#include "sinew_formats/base/point.hpp"

namespace sinew {
namespace {

TEST(VertexTextures, SmallMeshHasOneRowAFrame) {
  const TextureLayout layout = texture_layout("hero", 291, 40);
  EXPECT_EQ(layout.width, 291u);
  EXPECT_EQ(layout.rows, 1u);
  EXPECT_EQ(layout.height(), 40u);
}

TEST(VertexTextures, BigMeshWrapsAndWastesLessThanARow) {
  EXPECT_EQ(texture_layout("hero", kMostTextureWidth, 3).rows, 1u);
  for (const size_t vertices : {4096u, 4097u, 10000u, 100003u}) {
    const TextureLayout layout = texture_layout("hero", vertices, 3);
    EXPECT_LE(layout.width, kMostTextureWidth);
    EXPECT_GE(size_t{layout.width} * layout.rows, vertices);
    EXPECT_LT(size_t{layout.width} * layout.rows - vertices, layout.rows) << vertices;
  }
}

TEST(VertexTextures, EveryVertexOfEveryFrameHasATexelOfItsOwnWhereItsCoordinatesAre) {
  const TextureLayout layout = texture_layout("hero", 4099, 3);
  std::set<size_t> seen;
  for (size_t f = 0; f < 3; ++f)
    for (size_t v = 0; v < 4099; ++v) {
      const size_t texel = layout.texel(v, f);
      EXPECT_TRUE(seen.insert(texel).second);
      // As a shader finds it: coordinates of frame 0, then rows down.
      const std::array<float, 2> at = layout.coordinates(v);
      const auto column = static_cast<size_t>(at[0] * static_cast<float>(layout.width));
      const auto row = static_cast<size_t>(at[1] * static_cast<float>(layout.height())) + f * layout.rows;
      EXPECT_EQ(row * layout.width + column, texel);
    }
  EXPECT_LT(*seen.rbegin(), size_t{layout.width} * layout.height());
}

TEST(VertexTextures, MoreFramesThanATextureHoldsAreRefused) {
  EXPECT_EQ(texture_layout("hero", 10000, kMostTextureHeight / 3).height(), kMostTextureHeight / 3 * 3);
  EXPECT_ERROR(texture_layout("hero", 10000, kMostTextureHeight / 3 + 1), "hero: ", "1 to 2730 frames", "found 2731",
               "--fps", "sinew lod");
  EXPECT_ERROR(texture_layout("hero", 4096 * 8192 + 1, 1), "hero: ", "33554433 vertices");
}

TEST(VertexTextures, PositionsAreHalfAStepOffAtMost) {
  const Box bounds = {{-0.9f, -0.05f, -0.4f}, {0.9f, 1.85f, -0.4f}};
  VertexTextures textures = blank_textures(texture_layout("hero", 1001, 2), bounds);
  for (size_t v = 0; v < 1001; ++v) {
    const float share = static_cast<float>(v) / 1000;
    const Vec3 p = {-0.9f + 1.8f * share, 1.85f - 1.9f * share * share, -0.4f};
    const size_t texel = textures.layout.texel(v, 1);
    set_position(p, texel, &textures);
    const Vec3 back = position_at(textures, texel);
    // Half a step of 65535 and the rounding of floats.
    EXPECT_NEAR(back.x, p.x, 1.8 / 65535 / 2 + 1e-7);
    EXPECT_NEAR(back.y, p.y, 1.9 / 65535 / 2 + 2e-7);
    EXPECT_EQ(back.z, p.z);  // flat
  }
  // Both ends are exact.
  EXPECT_EQ(position_at(textures, textures.layout.texel(0, 1)).x, bounds.low.x);
  EXPECT_EQ(position_at(textures, textures.layout.texel(1000, 1)).x, bounds.high.x);
}

TEST(VertexTextures, NormalsAreHalfAStepAnAxisOffAtMost) {
  VertexTextures textures = blank_textures(texture_layout("hero", 1, 1), {});
  // Half of 1 / 127 along three axes, seen from the center.
  const double most = std::asin(std::sqrt(3.0) / 2 / 127) * 180 / std::numbers::pi;
  for (int i = 0; i < 20000; ++i) {
    const double z = -1 + 2 * (i + 0.5) / 20000, around = 2.399963 * i, r = std::sqrt(1 - z * z);
    const Point3 n = {r * std::cos(around), r * std::sin(around), z};
    set_normal(to_vec3(n), 0, &textures);
    const Point3 back = point(normal_at(textures, 0));
    EXPECT_NEAR(length(back), 1, 1e-6);
    EXPECT_LE(std::atan2(length(cross(n, back)), dot(n, back)) * 180 / std::numbers::pi, most);
  }
  for (const Vec3& axis : {Vec3{1, 0, 0}, Vec3{0, -1, 0}, Vec3{0, 0, 1}}) {
    set_normal(axis, 0, &textures);
    const Vec3 back = normal_at(textures, 0);
    EXPECT_EQ(back.x, axis.x);
    EXPECT_EQ(back.y, axis.y);
    EXPECT_EQ(back.z, axis.z);
  }
}

}  // namespace
}  // namespace sinew
