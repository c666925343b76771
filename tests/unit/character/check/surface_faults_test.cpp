// SPDX-License-Identifier: MIT
// Crossings of two layers: which pairs, whatever lies at rest, and as many as a count without a sweep finds.
#include "sinew_character/check/surface_faults.hpp"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "random.hpp"

namespace sinew {
namespace {

using Pairs = std::vector<std::pair<uint32_t, uint32_t>>;

Character triangles(const std::vector<Vec3>& corners) {
  Character out;
  out.vertices = corners;
  for (uint32_t v = 0; v < corners.size(); ++v) {
    out.face_vertices.push_back(v);
    if (v % 3 == 2) out.face_offsets.push_back(v + 1);
  }
  return out;
}

TEST(LayerCrossings, ATriangleThroughAnother) {
  const Character flat = triangles({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {9, 0, 0}, {12, 0, 0}, {9, 4, 0}});
  const Character through = triangles({{1, 1, -1}, {1, 1, 1}, {1, 2, 1}});
  EXPECT_EQ(crossing_pairs(flat, through), (Pairs{{0, 0}}));
  EXPECT_EQ(crossing_pairs(through, flat), (Pairs{{0, 0}}));
  // Its box lies in the other's, it does not.
  EXPECT_TRUE(crossing_pairs(flat, triangles({{3.5f, 3.5f, -1}, {3.5f, 3.5f, 1}, {3.6f, 3.6f, 1}})).empty());
}

TEST(LayerCrossings, APolygonIsAFan) {
  Character square;
  square.vertices = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};
  square.face_vertices = {0, 1, 2, 3};
  square.face_offsets = {0, 4};
  EXPECT_EQ(crossing_pairs(square, triangles({{0.5f, 1.5f, -1}, {0.5f, 1.5f, 1}, {0.4f, 1.6f, 1}})), (Pairs{{1, 0}}));
}

TEST(LayerCrossings, TheSweepLosesNone) {
  test::Random random(5);
  const auto cloud = [&](size_t count) {
    std::vector<Vec3> corners;
    for (size_t t = 0; t < count; ++t) {
      const auto value = [&](double spread) { return static_cast<float>(spread * random.uniform()); };
      const Vec3 at = {value(4), value(4), value(4)};
      for (int c = 0; c < 3; ++c) corners.push_back({at.x + value(1), at.y + value(1), at.z + value(1)});
    }
    return corners;
  };
  const std::vector<Vec3> a = cloud(80), b = cloud(90);
  Pairs one_by_one;
  for (uint32_t i = 0; i < 80; ++i)
    for (uint32_t j = 0; j < 90; ++j)
      if (!crossing_pairs(triangles({a.begin() + 3 * i, a.begin() + 3 * i + 3}),
                          triangles({b.begin() + 3 * j, b.begin() + 3 * j + 3}))
               .empty())
        one_by_one.emplace_back(i, j);
  EXPECT_GT(one_by_one.size(), 10u) << "or this test could not fail";
  EXPECT_EQ(crossing_pairs(triangles(a), triangles(b)), one_by_one);
}

TEST(LayerCrossings, WhatCrossesAtRestIsNotNew) {
  EXPECT_EQ(new_crossings({{0, 1}, {2, 2}}, {{0, 1}, {0, 2}, {3, 0}}), 2u);
  EXPECT_EQ(new_crossings({{0, 1}}, {}), 0u);
}

}  // namespace
}  // namespace sinew
