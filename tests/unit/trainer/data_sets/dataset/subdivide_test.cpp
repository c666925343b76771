// SPDX-License-Identifier: MIT
// Subdivided characters: counts, positions and weights.
#include <gtest/gtest.h>

#include "sinew_data_sets/dataset.hpp"
#include "tube.hpp"

namespace sinew {
namespace {

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
