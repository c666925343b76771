// SPDX-License-Identifier: MIT
// Decimation keeps rows, outlines and seams; subdivision keeps vertices and adds those between them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "expect_error.hpp"
#include "glb_round.hpp"
#include "sinew_data_sets/dataset.hpp"
#include "tube.hpp"

namespace sinew {
namespace {

TEST(Decimate, ReachesTheRatioAndKeepsRowsOfSurvivors) {
  const Character c = tube(48, 60);
  for (const double ratio : {0.75, 0.5, 0.25, 0.1}) {
    const Character d = decimate(c, ratio);
    EXPECT_NEAR(static_cast<double>(d.vertices.size()), ratio * static_cast<double>(c.vertices.size()),
                0.1 * ratio * static_cast<double>(c.vertices.size()));
    ASSERT_EQ(d.influences.size(), d.vertices.size());
    for (size_t v = 0; v < d.vertices.size(); ++v) {
      EXPECT_EQ(d.influences[v][1].weight, d.vertices[v].y / 4);
      EXPECT_EQ(d.influences[v][0].weight + d.influences[v][1].weight, 1.0f);
    }
    const CheckReport r = check_character(d);
    EXPECT_EQ(r.parts, 1u);
    EXPECT_EQ(r.isolated_vertices, 0u);
    EXPECT_EQ(r.non_manifold_edges, 0u);
    EXPECT_FALSE(has(r, "flipped-faces"));
    float low = 9, high = -9;
    for (const Vec3& p : d.vertices) low = std::min(low, p.y), high = std::max(high, p.y);
    EXPECT_EQ(low, 0);  // the hems
    EXPECT_EQ(high, 4);
  }
}

TEST(Decimate, AFlatOpenSheetKeepsItsOutline) {
  Character c;
  for (uint32_t i = 0; i < 400; ++i) c.vertices.push_back({static_cast<float>(i % 20), static_cast<float>(i / 20), 0});
  for (uint32_t y = 0; y < 19; ++y)
    for (uint32_t x = 0; x < 19; ++x) add_face(&c, {y * 20 + x, y * 20 + x + 1, y * 20 + x + 21, y * 20 + x + 20});
  const Character d = decimate(c, 0.1);
  double area = 0;
  for (size_t f = 0; f < d.face_count(); ++f) {
    const Vec3 &p = d.vertices[d.face_vertices[3 * f]], &q = d.vertices[d.face_vertices[3 * f + 1]],
               &r = d.vertices[d.face_vertices[3 * f + 2]];
    area += 0.5 * static_cast<double>((q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x));
  }
  EXPECT_NEAR(area, 361, 1e-3);
  EXPECT_TRUE(d.influences.empty());
}

TEST(Decimate, NonManifoldFacesStayJoined) {
  Character c = tube(24, 30);  // a fin along one line of the tube: three faces at each of its edges
  const uint32_t first = static_cast<uint32_t>(c.vertices.size());
  for (uint32_t r = 0; r < 30; ++r) {
    c.vertices.push_back({2, c.vertices[r * 24].y, 0});
    c.influences.push_back({{1, 1.0f}});
  }
  for (uint32_t r = 0; r + 1 < 30; ++r) add_face(&c, {r * 24, (r + 1) * 24, first + r + 1, first + r});
  ASSERT_EQ(check_character(c).non_manifold_edges, 29u);
  const Character d = decimate(c, 0.5);
  EXPECT_NEAR(static_cast<double>(d.vertices.size()), 375, 37.5);
  const CheckReport r = check_character(d);
  EXPECT_EQ(r.parts, 1u);
  EXPECT_EQ(r.non_manifold_edges, 29u);
}

TEST(Decimate, SeamsBetweenPartsOfOtherWeightsStayClosed) {
  Character c = tube(24, 21);
  Character top = tube(24, 21);
  const uint32_t base = static_cast<uint32_t>(c.vertices.size());
  for (size_t v = 0; v < top.vertices.size(); ++v) {
    c.vertices.push_back({top.vertices[v].x, top.vertices[v].y + 4, top.vertices[v].z});
    c.influences.push_back({{1, 1.0f}, {0, 0.0f}});
  }
  for (size_t f = 0; f < top.face_count(); ++f)
    add_face(&c, {base + top.face_vertices[4 * f], base + top.face_vertices[4 * f + 1],
                  base + top.face_vertices[4 * f + 2], base + top.face_vertices[4 * f + 3]});
  const Character d = decimate(c, 0.1);
  size_t low_side = 0, high_side = 0;
  for (size_t v = 0; v < d.vertices.size(); ++v)
    if (d.vertices[v].y == 4) (d.influences[v][0].joint == 0 ? low_side : high_side) += 1;
  EXPECT_EQ(low_side, 24u);
  EXPECT_EQ(high_side, 24u);
}

TEST(Decimate, SplitSoupIsWeldedFirst) {
  const Character whole = tube();
  Character soup;
  soup.joints = whole.joints;
  for (size_t f = 0; f < whole.face_count(); ++f) {
    for (size_t k = 0; k < 4; ++k) {
      const uint32_t v = whole.face_vertices[4 * f + k];
      soup.vertices.push_back(whole.vertices[v]);
      soup.influences.push_back(whole.influences[v]);
    }
    const uint32_t n = static_cast<uint32_t>(4 * f);
    add_face(&soup, {n, n + 1, n + 2, n + 3});
  }
  EXPECT_NEAR(static_cast<double>(decimate(soup, 0.5).vertices.size()), 160, 16);
}

TEST(Decimate, SurvivesFoldsAndFansAndDropsLooseVertices) {
  Character c;
  for (int i = 0; i < 12; ++i)
    c.vertices.push_back({static_cast<float>(i % 3), static_cast<float>(i % 5), static_cast<float>(i * i % 7)});
  for (uint32_t i = 2; i < 11; ++i) add_face(&c, {0, 1, i});  // nine faces at one edge; vertex 11 is in none
  add_face(&c, {3, 3, 4});
  const Character d = decimate(c, 1.0);
  EXPECT_EQ(d.vertices.size(), 11u);
  EXPECT_EQ(d.face_count(), 9u);
}

TEST(Decimate, RefusesWhatMakesNoSense) {
  Character c = tube();
  EXPECT_ERROR(decimate(c, 0), "ratio");
  EXPECT_ERROR(decimate(c, 1.5), "ratio", "1.5");
  EXPECT_ERROR(decimate(c, std::nan("")), "ratio");
  c.face_offsets = {0};
  c.face_vertices.clear();
  EXPECT_ERROR(decimate(c, 0.5), "tube", "without faces");
}

TEST(Decimate, KeepsMaterialsAndGroupsOfFaces) {
  Character c = tube();
  c.material_names = {"m", "n"};
  for (size_t f = 0; f < c.face_count(); ++f) c.face_materials.push_back(f < 152 ? 0 : 1);
  const Character d = decimate(c, 0.5);
  ASSERT_EQ(d.face_materials.size(), d.face_count());
  EXPECT_EQ(std::set<int>(d.face_materials.begin(), d.face_materials.end()).size(), 2u);
}

TEST(Decimate, ForgetsTheDocument) {
  const Character c = decimate(read(two_joint_strip()), 1.0);
  EXPECT_EQ(c.gltf, nullptr);
  EXPECT_NO_THROW(written(c));
}

TEST(Subdivide, EveryTriangleBecomesFourAndVerticesStay) {
  const Character c = tube(6, 4);  // 18 quads, 24 vertices
  const Character s = subdivide(c);
  EXPECT_EQ(s.face_count(), 18u * 2 * 4);
  // One more for every edge: 24 around, 18 along, 18 diagonals.
  ASSERT_EQ(s.vertices.size(), 24u + 24 + 18 + 18);
  ASSERT_EQ(s.influences.size(), s.vertices.size());
  for (size_t v = 0; v < c.vertices.size(); ++v) {
    EXPECT_EQ(s.vertices[v].y, c.vertices[v].y);
    EXPECT_EQ(s.influences[v].size(), c.influences[v].size());
  }
  // Weights of the tube are a linear function of y, and so are those in the middles.
  for (size_t v = c.vertices.size(); v < s.vertices.size(); ++v) {
    float high = 0, sum = 0;
    for (size_t i = 0; i < s.influences[v].size(); ++i) {
      const Influence& influence = s.influences[v][i];
      sum += influence.weight;
      high += influence.joint == 1 ? influence.weight : 0;
      if (i > 0) {
        EXPECT_LE(influence.weight, s.influences[v][i - 1].weight);
      }
    }
    EXPECT_NEAR(sum, 1, 1e-6);
    EXPECT_NEAR(high, s.vertices[v].y / 4, 1e-6);
  }
}

TEST(Subdivide, WithoutFacesNothingChanges) {
  Character c = tube(6, 4);
  c.face_vertices.clear();
  c.face_offsets = {0};
  EXPECT_EQ(subdivide(c).vertices.size(), c.vertices.size());
}

}  // namespace
}  // namespace sinew
