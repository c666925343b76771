// SPDX-License-Identifier: MIT
// What a mesh says about its joints: those that stand in the air beside it, and tips.
#include "sinew_character/rig/joint_verdicts.hpp"

#include <gtest/gtest.h>

namespace sinew {
namespace {

// A box from 0 to 1.
Character box() {
  Character c;
  for (const float x : {0.0f, 1.0f})
    for (const float y : {0.0f, 1.0f})
      for (const float z : {0.0f, 1.0f}) c.vertices.push_back({x, y, z});
  for (const auto& quad : std::vector<std::vector<uint32_t>>{
           {0, 1, 3, 2}, {4, 6, 7, 5}, {0, 4, 5, 1}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 5, 7, 3}}) {
    c.face_vertices.insert(c.face_vertices.end(), quad.begin(), quad.end());
    c.face_offsets.push_back(static_cast<uint32_t>(c.face_vertices.size()));
  }
  return c;
}

TEST(JointsBesideMesh, PolesWithoutAName) {
  Character c = box();
  c.joints = {{"a", {0.5f, 0.5f, 0.5f}, -1},
              {"b", {0.5f, 0.9f, 0.5f}, 0},
              {"knee", {0.5f, 0.5f, 2}, -1},
              {"antenna", {0.5f, 2, 0.5f}, 1},
              {"c", {0.5f, 0.2f, 0.5f}, 0}};
  std::vector<uint8_t> roles = joint_verdicts(c.joints).roles;
  find_joints_beside_mesh(c, &roles);
  EXPECT_EQ(roles[0], SINEW_ROLE_DEFORMS);  // far from every vertex, but inside
  EXPECT_EQ(roles[2], SINEW_ROLE_CONTROL);
  EXPECT_EQ(roles[3], SINEW_ROLE_DEFORMS);  // hangs on a limb
}

TEST(JointsBesideMesh, TipsThatNoMeshIsNearAreEnds) {
  Character c = box();
  c.joints = {{"a", {0.5f, 0.5f, 0.5f}, -1},
              {"near_tip", {0.95f, 0.95f, 0.95f}, 0},
              {"far_tip", {0.5f, 0.5f, 2}, 0},
              {"far", {0.5f, 0.5f, 2}, 0},
              {"any_end", {1, 1, 1}, 0}};
  std::vector<uint8_t> roles = joint_verdicts(c.joints).roles;
  EXPECT_EQ(roles[2], SINEW_ROLE_DEFORMS);
  find_tips_without_mesh(c, &roles);
  EXPECT_EQ(roles, (std::vector<uint8_t>{SINEW_ROLE_DEFORMS, SINEW_ROLE_DEFORMS, SINEW_ROLE_END, SINEW_ROLE_DEFORMS,
                                         SINEW_ROLE_END}));
}

TEST(JointVerdicts, WeightsOfACharacter) {
  Character c = box();
  c.joints = {{"a", {0, 0, 0}, -1}, {"a_end", {0, 1, 0}, 0}, {"b", {1, 0, 0}, 0}};
  c.influences.resize(8);
  EXPECT_TRUE(follows_of(c).empty());
  c.influences[3] = {{1, 0.5f}, {0, 0.5f}};
  EXPECT_EQ(follows_of(c), (std::vector<uint8_t>{SINEW_FOLLOWS_SOME, SINEW_FOLLOWS_SOME, SINEW_FOLLOWS_NONE}));
  const JointVerdicts got = joint_verdicts(c.joints, follows_of(c));
  EXPECT_FALSE(got.is_end(1)) << "a vertex follows it";
  EXPECT_TRUE(got.is_end(2));
}

}  // namespace
}  // namespace sinew
