// SPDX-License-Identifier: MIT
#include "sinew_character/pose/character_transform.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "expect_error.hpp"
#include "sinew_formats/io.hpp"
#include "temp_folder.hpp"

namespace sinew {
namespace {

// A tetrahedron over two joints, from y = 1 to y = 3.
Character body() {
  Character character;
  character.name = "body";
  character.joints = {{"Hips", {0, 1.5f, 0}, -1}, {"Head", {0.25f, 2.5f, 0}, 0}};
  character.vertices = {{0, 1, 0}, {1, 1, 0}, {0, 1, 1}, {0, 3, 0}};
  character.influences = {{{0, 1.0f}}, {{0, 1.0f}}, {{0, 1.0f}}, {{1, 1.0f}}};
  character.face_vertices = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
  character.face_offsets = {0, 3, 6, 9, 12};
  return character;
}

void expect_at(const Vec3& p, float x, float y, float z) {
  EXPECT_EQ(p.x, x);
  EXPECT_EQ(p.y, y);
  EXPECT_EQ(p.z, z);
}

TEST(CharacterTransform, QuartersAreExactAndFollowEachOther) {
  expect_at(transformed(body(), {{"x"}, 0, false}, Axis::kY).joints[1].position, 0.25f, 0, 2.5f);
  expect_at(transformed(body(), {{"y"}, 0, false}, Axis::kY).joints[1].position, 0, 2.5f, -0.25f);
  expect_at(transformed(body(), {{"z"}, 0, false}, Axis::kY).joints[1].position, -2.5f, 0.25f, 0);
  expect_at(transformed(body(), {{"x", "-x"}, 0, false}, Axis::kY).vertices[3], 0, 3, 0);
  expect_at(transformed(body(), {{"x", "y"}, 0, false}, Axis::kY).joints[1].position, 2.5f, 0, -0.25f);
}

TEST(CharacterTransform, HeightAndFloorAreAlongUp) {
  const Character tall = transformed(body(), {{}, 1, true}, Axis::kY);
  expect_at(tall.vertices[0], 0, 0, 0);
  expect_at(tall.vertices[3], 0, 1, 0);
  expect_at(tall.joints[1].position, 0.125f, 0.75f, 0);
  const Character turned = transformed(body(), {{"x"}, 4, true}, Axis::kZ);
  expect_at(turned.vertices[3], 0, 0, 4);
  EXPECT_EQ(turned.influences.size(), 4u);
}

TEST(CharacterTransform, NothingIsAskedForAndNothingChanges) {
  EXPECT_TRUE(is_identity(CharacterTransform()));
  expect_at(transformed(body(), {}, Axis::kY).vertices[3], 0, 3, 0);
}

TEST(CharacterTransform, ADocumentOfGltfGoesAlong) {
  const TempFolder folder;
  const std::string file = folder.file("body.glb"), moved = folder.file("moved.glb");
  write_gltf(file, body());
  const Character there = transformed(read_gltf(file), {{"z", "y"}, 0.5, true}, Axis::kY);
  ASSERT_TRUE(there.gltf);
  write_gltf(moved, there);
  const Character again = read_gltf(moved);
  ASSERT_EQ(again.vertices.size(), there.vertices.size());
  for (size_t v = 0; v < again.vertices.size(); ++v) {
    EXPECT_NEAR(again.vertices[v].x, there.vertices[v].x, 1e-6f);
    EXPECT_NEAR(again.vertices[v].y, there.vertices[v].y, 1e-6f);
    EXPECT_NEAR(again.vertices[v].z, there.vertices[v].z, 1e-6f);
  }
  ASSERT_EQ(again.joints.size(), 2u);
  for (size_t j = 0; j < 2; ++j) {
    EXPECT_NEAR(again.joints[j].position.x, there.joints[j].position.x, 1e-6f);
    EXPECT_NEAR(again.joints[j].position.y, there.joints[j].position.y, 1e-6f);
    EXPECT_NEAR(again.joints[j].position.z, there.joints[j].position.z, 1e-6f);
  }
}

TEST(CharacterTransform, WrongOptionsAreOneLine) {
  EXPECT_ERROR(transformed(body(), {{"w"}, 0, false}, Axis::kY), "rotation 'w'", "expected x, y, z, -x, -y or -z");
  EXPECT_ERROR(transformed(body(), {{}, -1, false}, Axis::kY), "height");
  Character flat = body();
  for (Vec3& p : flat.vertices) p.y = 0;
  EXPECT_ERROR(transformed(flat, {{}, 1.8, false}, Axis::kY), "body", "is flat along y");
}

}  // namespace
}  // namespace sinew
