// SPDX-License-Identifier: MIT
// A Character's arrays in the engine's order, and what cannot be bound.
#include "sinew_character/bind/engine_views.hpp"

#include <gtest/gtest.h>

#include "expect_error.hpp"

namespace sinew {
namespace {

Character two_triangles() {
  Character c;
  c.name = "pair";
  c.vertices = {{0, 1, 2}, {3, 4, 5}, {6, 7, 8}, {9, 10, 11}};
  c.face_offsets = {0, 3, 6};
  c.face_vertices = {0, 1, 2, 2, 1, 3};
  c.joints = {{"a", {1, 2, 3}, -1}, {"b", {4, 5, 6}, 0}};
  return c;
}

TEST(EngineViews, ShowTheCharacter) {
  const Character c = two_triangles();
  const EngineViews views(c, {0, SINEW_JOINT_NEVER});
  EXPECT_EQ(views.mesh.vertex_count, 4u);
  for (uint32_t i = 0; i < 12; ++i) EXPECT_EQ(views.mesh.positions[i], static_cast<float>(i));
  EXPECT_EQ(views.mesh.face_count, 2u);
  EXPECT_EQ(views.mesh.corner_count, 6u);
  EXPECT_EQ(views.mesh.face_offsets, c.face_offsets.data());
  EXPECT_EQ(views.mesh.face_vertices, c.face_vertices.data());
  EXPECT_EQ(views.skeleton.joint_count, 2u);
  EXPECT_EQ(views.skeleton.positions[5], 6.0f);
  EXPECT_EQ(views.skeleton.parents[0], -1);
  EXPECT_EQ(views.skeleton.parents[1], 0);
  EXPECT_EQ(views.skeleton.flags[1], SINEW_JOINT_NEVER);
  EXPECT_EQ(EngineViews(c, {}).skeleton.flags, nullptr);
}

TEST(EngineViews, CheckBindableSaysWhatIsMissingOrTooMuch) {
  Character c = two_triangles();
  EXPECT_NO_THROW(check_bindable(c));
  c.joints.resize(SINEW_MAX_JOINTS + 1);
  EXPECT_ERROR(check_bindable(c), "pair: 4097 joints", "at most 4096");
  c.joints.clear();
  EXPECT_ERROR(check_bindable(c), "pair: no skeleton", "--skeleton");
  c.vertices.clear();
  EXPECT_ERROR(check_bindable(c), "pair: the mesh has no vertices");
}

TEST(EngineViews, ThrowStatusNamesTheCharacter) {
  const Character c = two_triangles();
  EXPECT_NO_THROW(throw_status(c, SINEW_OK));
  EXPECT_ERROR(throw_status(c, SINEW_ERROR_INDEX), "pair: ", sinew_status_text(SINEW_ERROR_INDEX));
}

}  // namespace
}  // namespace sinew
