// SPDX-License-Identifier: MIT
// The check of a character finds each constructed defect and nothing in a sound one.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sinew_data_sets/dataset.hpp"
#include "tube.hpp"

namespace sinew {
namespace {

TEST(Check, ASoundCharacterHasOnlyNotes) {
  const CheckReport r = check_training_character(tube());
  EXPECT_FALSE(has_more_than_notes(r));
  EXPECT_EQ(r.vertices, 320u);
  EXPECT_EQ(r.faces, 304u);
  EXPECT_EQ(r.parts, 1u);
  EXPECT_EQ(r.boundary_edges, 32u);
  EXPECT_EQ(r.roots, 1u);
  EXPECT_EQ(r.max_influences, 2u);
  const auto boundary = std::find_if(r.findings.begin(), r.findings.end(),
                                     [](const CheckFinding& f) { return f.code == "boundary-edges"; });
  ASSERT_NE(boundary, r.findings.end());
  EXPECT_EQ(boundary->text, "32 boundary edges in 2 loops");
}

TEST(Check, FindsEachMeshDefect) {
  Character c = tube();
  c.vertices.push_back({3, 3, 3});
  c.influences.push_back({{0, 1.0f}});
  add_face(&c, {0, 16, 320});  // third face at edge 0-16
  c.vertices.push_back({9, 0, 0});
  c.influences.push_back({{0, 1.0f}});
  CheckReport r = check_character(c);
  EXPECT_EQ(r.non_manifold_edges, 1u);
  EXPECT_TRUE(has(r, "non-manifold-edges"));
  EXPECT_EQ(r.isolated_vertices, 1u);
  EXPECT_TRUE(has(r, "isolated-vertices"));
  EXPECT_EQ(r.parts, 1u);

  c = tube();
  add_face(&c, {5, 5, 6});
  add_face(&c, {17, 1, 0, 16});  // face 0 again, turned
  r = check_character(c);
  EXPECT_EQ(r.degenerate_faces, 1u);
  EXPECT_EQ(r.duplicate_faces, 1u);
  EXPECT_EQ(r.non_manifold_edges, 0u);

  c = tube();
  for (const Vec3& p : std::vector<Vec3>{{8, 0, 0}, {9, 0, 0}, {10, 0, 0}})
    c.vertices.push_back(p), c.influences.push_back({{0, 1.0f}});
  add_face(&c, {320, 321, 322});  // a line
  r = check_character(c);
  EXPECT_EQ(r.degenerate_faces, 1u);
  EXPECT_EQ(r.parts, 2u);

  c = tube();
  std::swap(c.face_vertices[1], c.face_vertices[3]);
  EXPECT_TRUE(has(check_character(c), "flipped-faces"));
  c = tube();
  c.face_vertices[0] = 4000;
  EXPECT_TRUE(has(check_character(c), "bad-faces"));
  c.vertices[1].x = std::nanf("");
  EXPECT_TRUE(has(check_character(c), "not-finite"));
}

TEST(Check, FindsEachSkeletonDefect) {
  Character c = tube();  // 2 x 4 x 2: the limit is 2 beyond the box
  c.joints.push_back({"near", {0, 5.9f, 0}, 1});
  c.joints.push_back({"as near", {0, -1.9f, 0}, 1});
  EXPECT_EQ(check_character(c).joints_outside, 0u);
  c.joints.push_back({"far", {0, 6.1f, 0}, 1});
  EXPECT_EQ(check_character(c).joints_outside, 1u);
  c.joints.push_back({"as far", {0, -2.1f, 0}, 1});
  EXPECT_EQ(check_character(c).joints_outside, 2u);
  c.joints.push_back({"other root", {0, 0, 0}, -1});
  EXPECT_EQ(check_character(c).roots, 2u);
  EXPECT_TRUE(has(check_character(c), "several-roots"));
  c.joints.push_back({"a", {0, 0, 0}, 8});
  c.joints.push_back({"b", {0, 0, 0}, 7});
  c.joints.push_back({"hangs on the cycle", {0, 0, 0}, 7});
  EXPECT_EQ(check_character(c).hierarchy_cycles, 1u);
  c.joints.push_back({"orphan", {0, 0, 0}, 77});
  EXPECT_TRUE(has(check_character(c), "bad-parents"));
  c.joints.clear();
  EXPECT_TRUE(has(check_character(c), "no-joints"));
}

TEST(Check, FindsEachWeightDefect) {
  Character c = tube();
  c.influences[3].clear();
  c.influences[4] = {{0, 0.5f}, {1, 0.4985f}};
  c.influences[5] = {{0, 0.5f}, {1, 0.4995f}};  // within 1e-3
  CheckReport r = check_character(c);
  EXPECT_EQ(r.unbound_vertices, 1u);
  EXPECT_EQ(r.bad_weight_sums, 1u);
  c.influences[6] = {{7, 1.0f}};
  c.influences[7] = {{0, -1.0f}, {1, 2.0f}};
  EXPECT_TRUE(has(check_character(c), "bad-influences"));
  c.influences.resize(10);
  EXPECT_TRUE(has(check_character(c), "weight-rows"));
  c.influences.clear();
  EXPECT_TRUE(has(check_character(c), "no-weights"));
}

}  // namespace
}  // namespace sinew
