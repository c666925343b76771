// SPDX-License-Identifier: MIT
// What is cloth of a character: parts around a part around the bone, in any order of the file, and nothing else.
#include "score/bends.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "sinew_formats/io.hpp"

namespace sinew {
namespace {

// An arm along x whose elbow is at 2.
Character arm() {
  Character c;
  c.name = "arm";
  c.joints = {{"hips", {0, 0, 0}, -1},
              {"spine", {0, 1, 0}, 0},
              {"upper_arm.L", {1, 1, 0}, 1},
              {"forearm.L", {2, 1, 0}, 2},
              {"hand.L", {3, 1, 0}, 3}};
  return c;
}

// Rings around the arm from x = from to 3; a share of each ring's faces. Its vertices are one part of the mesh.
void add_tube(Character* c, float radius, float from, uint32_t faces_around, float height = 1) {
  constexpr uint32_t kAround = 16, kRings = 9;
  const uint32_t first = static_cast<uint32_t>(c->vertices.size());
  for (uint32_t r = 0; r < kRings; ++r)
    for (uint32_t a = 0; a < kAround; ++a) {
      const float t = 6.2831853f * static_cast<float>(a) / kAround;
      const float x = from + (3 - from) * static_cast<float>(r) / (kRings - 1);
      c->vertices.push_back({x, height + radius * std::cos(t), radius * std::sin(t)});
      c->influences.push_back({{x < 2 ? 2u : 3u, 1.0f}});
    }
  for (uint32_t r = 0; r + 1 < kRings; ++r)
    for (uint32_t a = 0; a < faces_around; ++a) {
      const uint32_t b = (a + 1) % kAround;
      for (const uint32_t v : {r * kAround + a, r * kAround + b, (r + 1) * kAround + b, (r + 1) * kAround + a})
        c->face_vertices.push_back(first + v);
      c->face_offsets.push_back(static_cast<uint32_t>(c->face_vertices.size()));
    }
}

TEST(Dressed, ASleeveIsClothWhereverItLiesInTheFile) {
  for (const bool sleeve_first : {false, true}) {
    Character c = arm();
    add_tube(&c, sleeve_first ? 0.3f : 0.2f, 1, 16);
    add_tube(&c, sleeve_first ? 0.2f : 0.3f, 1, 16);
    const std::optional<Dressed> dressed = take_apart(c);
    ASSERT_TRUE(dressed);
    ASSERT_EQ(dressed->bends.size(), 2u) << "shoulder and elbow";
    EXPECT_EQ(dressed->bends[0].second, 3u);
    EXPECT_EQ(dressed->body.vertices.size(), 144u);
    EXPECT_EQ(dressed->garment.vertices.size(), 144u);
    EXPECT_EQ(dressed->garment.face_count(), 128u);
    EXPECT_NEAR(dressed->body.vertices[0].y, 1.2, 1e-6);
    EXPECT_NEAR(dressed->garment.vertices[0].y, 1.3, 1e-6);
    EXPECT_EQ(dressed->body.influences.size(), 144u);
    EXPECT_TRUE(dressed->garment.influences.empty());
  }
}

TEST(Dressed, WhatLiesBesideOrOpenOrBelowIsNone) {
  Character c = arm();
  add_tube(&c, 0.2f, 1, 16);
  EXPECT_FALSE(take_apart(c)) << "an arm alone";
  add_tube(&c, 0.25f, 1, 12);
  EXPECT_FALSE(take_apart(c)) << "a gutter";
  add_tube(&c, 0.1f, 1, 16, 2);
  EXPECT_FALSE(take_apart(c)) << "beside the arm";
  add_tube(&c, 0.28f, 2.6f, 16);
  EXPECT_FALSE(take_apart(c)) << "a cuff, far from the elbow";
  add_tube(&c, 0.3f, 1.8f, 16);
  const std::optional<Dressed> dressed = take_apart(c);
  ASSERT_TRUE(dressed) << "a sleeve from the elbow on";
  EXPECT_EQ(dressed->bends.size(), 1u);
  EXPECT_EQ(dressed->garment.vertices.size(), 144u);
  EXPECT_EQ(dressed->body.vertices.size(), 4u * 144u) << "all that is not cloth";
}

TEST(Dressed, NeedsWeightsAndNames) {
  Character c = arm();
  add_tube(&c, 0.2f, 1, 16);
  add_tube(&c, 0.3f, 1, 16);
  Character nameless = c;
  for (size_t j = 0; j < nameless.joints.size(); ++j) nameless.joints[j].name = "b" + std::to_string(j);
  EXPECT_FALSE(take_apart(nameless));
  c.influences.clear();
  EXPECT_FALSE(take_apart(c));
  EXPECT_FALSE(take_apart(read_character(std::string(SINEW_SOURCE_DIR) + "/samples/data/snake__long.obj")));
}

}  // namespace
}  // namespace sinew
