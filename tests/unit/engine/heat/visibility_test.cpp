// SPDX-License-Identifier: MIT
// Which faces hide a bone: the crossing test, exact at any scale, and the box tree against brute force.
#include "heat/visibility.hpp"

#include <gtest/gtest.h>

#include <random>

#include "arena_block.hpp"
#include "heat_scene.hpp"

namespace {

using namespace sinew;
using sinew_test::Block;
using sinew_test::HeatRun;
using sinew_test::HeatScene;

// Counter-clockwise seen from above: its front looks up.
constexpr Vec3i kA = {0, 0, 0}, kB = {0, 0, 100}, kC = {100, 0, 0};

TEST(Visibility, OnlyTheFrontHides) {
  EXPECT_TRUE(crosses_front({20, 50, 20}, {20, -50, 20}, kA, kB, kC));
  EXPECT_FALSE(crosses_front({20, -50, 20}, {20, 50, 20}, kA, kB, kC));
  EXPECT_FALSE(crosses_front({20, 50, 20}, {20, -50, 20}, kA, kC, kB));
  EXPECT_TRUE(crosses_front({20, -50, 20}, {20, 50, 20}, kA, kC, kB));
}

TEST(Visibility, EdgesAndCornersBelongToTheFace) {
  EXPECT_TRUE(crosses_front({50, 10, 0}, {50, -10, 0}, kA, kB, kC));
  EXPECT_TRUE(crosses_front({50, 10, 50}, {50, -10, 50}, kA, kB, kC));
  EXPECT_TRUE(crosses_front({0, 10, 0}, {0, -10, 0}, kA, kB, kC));
  EXPECT_FALSE(crosses_front({50, 10, -1}, {50, -10, -1}, kA, kB, kC));
  EXPECT_FALSE(crosses_front({51, 10, 50}, {51, -10, 50}, kA, kB, kC));
}

TEST(Visibility, EndsOnTheFaceAndMovesInItsPlaneDoNotCross) {
  EXPECT_FALSE(crosses_front({20, 50, 20}, {20, 0, 20}, kA, kB, kC));
  EXPECT_TRUE(crosses_front({20, 50, 20}, {20, -1, 20}, kA, kB, kC));
  EXPECT_FALSE(crosses_front({20, 0, 20}, {20, -50, 20}, kA, kB, kC));
  EXPECT_FALSE(crosses_front({-50, 0, 20}, {200, 0, 20}, kA, kB, kC));
}

TEST(Visibility, OneUnitDecidesAtFullScale) {
  // The crossing point lies a billionth of a grid unit beside the long edge; any rounding gives the wrong answer for
  // one of the two.
  const Vec3i a = {-524288, 3, -524287}, b = {524287, 5, 524288}, c = {524287, 1, -524288};
  int hits = 0, differs = 0;
  for (int32_t dx = -1; dx <= 1; ++dx) {
    for (int32_t dz = -1; dz <= 1; ++dz) {
      const bool one = crosses_front({dx, 500000, dz}, {dx + 1, -400001, dz}, a, b, c);
      hits += one;
      differs += one != crosses_front_wide({dx, 500000, dz}, {dx + 1, -400001, dz}, a, b, c);
    }
  }
  EXPECT_GT(hits, 0);
  EXPECT_LT(hits, 9);
  EXPECT_EQ(differs, 0);
}

TEST(Visibility, WideDeterminantsEqualTheFastOnes) {
  std::mt19937 random(7);
  const auto pick = [&](int32_t reach) {
    return static_cast<int32_t>(random() % static_cast<uint32_t>(2 * reach + 1)) - reach;
  };
  int hits = 0;
  for (int i = 0; i < 20000; ++i) {
    const int32_t reach = i % 2 == 0 ? 6 : 1 << 18;  // a small lattice meets edges and planes all the time
    const auto point = [&] { return Vec3i{pick(reach), pick(reach), pick(reach)}; };
    const Vec3i s = point(), t = point(), a = point(), b = point(), c = point();
    const bool fast = crosses_front(s, t, a, b, c);
    hits += fast;
    ASSERT_EQ(fast, crosses_front_wide(s, t, a, b, c));
    ASSERT_EQ(fast, crosses_front(s, t, b, c, a));
  }
  EXPECT_GT(hits, 100);
}

TEST(Visibility, FarTargetsUseTheWideWay) {
  const Vec3i a = {-500000, 0, -500000}, b = {-500000, 0, 500000}, c = {500000, 0, 0};
  EXPECT_TRUE(crosses_front({0, 500000, 0}, {0, -8000000, 0}, a, b, c));
  EXPECT_TRUE(crosses_front({0, 500000, 0}, {7000000, -8000000, 0}, a, b, c));
  EXPECT_FALSE(crosses_front({0, 500000, 0}, {8000000, -4000000, 0}, a, b, c));
}

TEST(Visibility, TreeEqualsBruteForce) {
  HeatScene scene = sinew_test::tangle(300, 900, 3, 11);
  for (const uint32_t part : {40u, 70u}) {  // two parts more, at the same position
    const HeatScene other = sinew_test::tangle(part, 2 * part, 1, part);
    const uint32_t base = scene.vertex_count();
    for (size_t i = 0; i < other.positions.size(); i += 3)
      scene.add_vertex(other.positions[i], other.positions[i + 1], other.positions[i + 2]);
    for (size_t i = 0; i < other.triangles.size(); i += 3)
      scene.add_triangle(base + other.triangles[i], base + other.triangles[i + 1], base + other.triangles[i + 2]);
  }
  const HeatRun run(scene, false);
  ASSERT_EQ(run.status, SINEW_OK);
  Arena measure;
  FaceTree tree;
  tree.allocate(measure, run.counts);
  Block block(measure.high_water());
  tree.allocate(block.arena, run.counts);
  tree.build(run.mesh);
  std::mt19937 random(3);
  int hidden[2] = {};
  uint32_t kept[2] = {FaceTree::kNoGroup, FaceTree::kNoGroup};  // hints, from one vertex to the next
  for (uint32_t v = 0; v < run.mesh.welded_count; ++v) {
    const Vec3i target = run.mesh.positions[random() % run.mesh.welded_count];
    const uint32_t first = tree.part_first[run.mesh.part[v]], last = tree.part_first[run.mesh.part[v] + 1];
    for (const bool outside : {false, true}) {
      bool brute = false;
      for (uint32_t t = 0; t < run.mesh.triangle_count; ++t) {
        const uint32_t* c = run.mesh.triangles + 3 * t;
        if (c[0] == v || c[1] == v || c[2] == v) continue;
        if ((run.mesh.part[c[0]] == run.mesh.part[v]) == outside) continue;
        brute = brute || crosses_front(run.mesh.positions[v], target, run.mesh.positions[c[0]],
                                       run.mesh.positions[c[1]], run.mesh.positions[c[2]]);
      }
      uint32_t hint = FaceTree::kNoGroup;
      ASSERT_EQ(tree.hidden(run.mesh, v, target, first, last, outside, &hint), brute) << v;
      ASSERT_EQ(tree.hidden(run.mesh, v, target, first, last, outside, &hint), brute) << v;  // with the hint
      ASSERT_EQ(tree.hidden(run.mesh, v, target, first, last, outside, &kept[outside]), brute) << v;
      hidden[outside] += brute;
    }
  }
  EXPECT_GT(hidden[0], 20);
  EXPECT_GT(hidden[1], 20);
  EXPECT_LT(hidden[1], static_cast<int>(run.mesh.welded_count));
}

}  // namespace
