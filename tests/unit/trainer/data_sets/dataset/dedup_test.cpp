// SPDX-License-Identifier: MIT
// Copies in a data set are found, moved or painted anew.
#include "sinew_data_sets/dedup.hpp"

#include <gtest/gtest.h>

#include "sinew_data_sets/synthesize.hpp"

namespace sinew {
namespace {

Character made(uint64_t seed) {
  SynthesizeOptions options;
  options.plan = BodyPlan::kQuadruped;
  options.seed = seed;
  options.resolution = 24;
  return synthesize(options);
}

// Another order of vertices, twice the size, somewhere else.
Character moved(const Character& c) {
  Character out = c;
  const auto count = static_cast<uint32_t>(c.vertices.size());
  const auto moved_point = [&](const Vec3& p) { return Vec3{2 * p.x + 7, 2 * p.y - 3, 2 * p.z + 1}; };
  for (uint32_t v = 0; v < count; ++v) {
    out.vertices[count - 1 - v] = moved_point(c.vertices[v]);
    out.influences[count - 1 - v] = c.influences[v];
  }
  for (uint32_t& v : out.face_vertices) v = count - 1 - v;
  for (Joint& joint : out.joints) {
    joint.position = moved_point(joint.position);
    joint.name = "other " + joint.name;
  }
  return out;
}

std::vector<DuplicateGroup> groups_of(const std::vector<Character>& characters) {
  DuplicateFinder finder;
  for (const Character& c : characters) finder.add(c);
  return finder.groups();
}

TEST(Dedup, FindsCopiesThatMovedGrewAndChangedTheirOrder) {
  const Character a = made(1);
  const auto groups = groups_of({made(2), a, made(3), moved(a)});
  ASSERT_EQ(groups.size(), 1u);
  ASSERT_EQ(groups[0].members.size(), 2u);
  EXPECT_EQ(groups[0].members[0].index, 1u);
  EXPECT_EQ(groups[0].members[1].index, 3u);
  EXPECT_EQ(groups[0].members[1].likeness, Likeness::kSame);
  EXPECT_EQ(groups[0].members[1].like, 1u);
}

TEST(Dedup, TellsNearFromOtherWeightsAndOtherSkeletons) {
  const Character a = made(1);
  Character near = a, repainted = a, rerigged = a;
  for (size_t v = 0; v < near.vertices.size(); v += 2) near.vertices[v].y += 0.002f;
  for (size_t v = 0; v < a.vertices.size() / 2; ++v) repainted.influences[v] = {{0, 1.0f}};
  for (Joint& joint : rerigged.joints) joint.position.x += 0.2f;
  Character rerigged_again = rerigged;
  const auto groups = groups_of({a, near, repainted, rerigged, rerigged_again});
  ASSERT_EQ(groups.size(), 1u);
  const auto& m = groups[0].members;
  ASSERT_EQ(m.size(), 5u);
  EXPECT_EQ(m[1].likeness, Likeness::kNear);
  EXPECT_EQ(m[1].like, 0u);
  EXPECT_EQ(m[2].likeness, Likeness::kOtherWeights);
  EXPECT_EQ(m[2].like, 2u);
  EXPECT_GT(m[2].weights, 0.1);
  EXPECT_EQ(m[3].likeness, Likeness::kOtherSkeleton);
  EXPECT_EQ(m[3].like, 3u);
  EXPECT_EQ(m[4].likeness, Likeness::kSame) << "to the other skeleton's first";
  EXPECT_EQ(m[4].like, 3u);
  EXPECT_TRUE(groups_of({a, made(4)}).empty());
}

}  // namespace
}  // namespace sinew
