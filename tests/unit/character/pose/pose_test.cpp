// SPDX-License-Identifier: MIT
// Poses: given turns, and characters moved by them.
#include "sinew_character/pose/pose.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "expect_affine.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/io.hpp"

namespace sinew {
namespace {

using sinew_test::expect_affine;

Character chain() {
  Character c;
  c.name = "chain";
  c.joints = {{"a", {0, 0, 0}, -1}, {"b", {1, 0, 0}, 0}, {"e", {2, 0, 0}, 1}};
  c.vertices = {{0, 0.1f, 0}, {1, 0.1f, 0}, {2, 0.1f, 0}, {5, 5, 5}};
  c.face_offsets = {0, 3};
  c.face_vertices = {0, 1, 2};
  c.influences = {{{0, 1.0f}}, {{0, 0.5f}, {1, 0.5f}}, {{1, 1.0f}}, {}};
  return c;
}

TEST(PosePalette, RefusesAParentThatDoesNotExist) {
  Character c = chain();
  c.joints[0].parent = 9;
  EXPECT_THROW(pose_palette(c, {}), Error);
}

TEST(PosePalette, TurnsAboutTheJointAndCarriesChildren) {
  const auto palette = pose_palette(chain(), {{1, 0, 0, 90}});
  expect_affine(palette[0], {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0});
  expect_affine(palette[1], {0, -1, 0, 1, 1, 0, 0, -1, 0, 0, 1, 0});
  expect_affine(palette[2], palette[1]);
}

TEST(PosePalette, AnglesAreAppliedXThenYThenZ) {
  // R = Rz Ry Rx with 90 degrees each takes y to z (x turn), z to x (y turn), x to y (z turn): y stays y.
  const auto palette = pose_palette(chain(), {{0, 90, 90, 90}});
  expect_affine(palette[0], {0, 0, 1, 0, 0, 1, 0, 0, -1, 0, 0, 0});
  EXPECT_THROW(pose_palette(chain(), {{3, 0, 0, 0}}), Error);
}

TEST(ApplyPose, MovesVerticesAndJointsAndLeavesUnboundOnes) {
  for (const bool dual_quaternion : {false, true}) {
    const Character c = chain();
    const Character posed = apply_pose(c, pose_palette(c, {{1, 0, 0, 90}}), dual_quaternion);
    EXPECT_NEAR(posed.vertices[0].x, 0, 1e-4);
    EXPECT_NEAR(posed.vertices[2].x, 0.9, 1e-4);  // (2, 0.1) about (1, 0) by 90 degrees
    EXPECT_NEAR(posed.vertices[2].y, 1, 1e-4);
    EXPECT_EQ(apply_pose(c, pose_palette(c, {{0, 0, 0, 90}}), dual_quaternion).vertices[3].x, 5);
    EXPECT_NEAR(posed.joints[2].position.x, 1, 1e-5);
    EXPECT_NEAR(posed.joints[2].position.y, 1, 1e-5);
    // Half a turn each: the linear blend pulls inwards, the dual quaternion keeps the distance of 0.1.
    const double dx = static_cast<double>(posed.vertices[1].x) - 1, dy = static_cast<double>(posed.vertices[1].y);
    EXPECT_NEAR(std::sqrt(dx * dx + dy * dy), dual_quaternion ? 0.1 : 0.1 / std::sqrt(2.0), 1e-4);
  }
}

TEST(ApplyPose, KeepsTheTwelveStrongestOfLongRows) {
  Character c;
  c.name = "many";
  c.vertices = {{1, 0, 0}};
  c.influences.resize(1);
  for (uint32_t j = 0; j < 20; ++j) {
    c.joints.push_back({std::to_string(j), {0, 0, 0}, -1});
    c.influences[0].push_back({j, j < 12 ? 0.08f : 0.005f});
  }
  std::vector<JointRotation> turns;
  for (size_t j = 12; j < 20; ++j) turns.push_back({j, 0, 0, 180});
  EXPECT_NEAR(apply_pose(c, pose_palette(c, turns)).vertices[0].x, 1, 1e-6);
}

TEST(ApplyPose, RefusesWhatDoesNotFit) {
  Character c = chain();
  const auto palette = pose_palette(c, {});
  EXPECT_THROW(apply_pose(c, {}), Error);
  c.influences[0] = {{7, 1.0f}};
  EXPECT_THROW(apply_pose(c, palette), Error);
  c.influences.clear();
  EXPECT_THROW(apply_pose(c, palette), Error);
}

TEST(ApplyPose, ResultCanBeWrittenAsObj) {
  const Character c = chain();
  const auto path = std::filesystem::temp_directory_path() / "sinew_pose_test.obj";
  write_obj(path.string(), apply_pose(c, pose_palette(c, {{1, 0, 0, 90}})));
  const Character back = read_obj(path.string());
  std::filesystem::remove(path);
  ASSERT_EQ(back.vertices.size(), 4u);
  EXPECT_EQ(back.face_count(), 1u);
  EXPECT_NEAR(back.vertices[2].y, 1, 1e-4);
}

}  // namespace
}  // namespace sinew
