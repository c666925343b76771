// SPDX-License-Identifier: MIT
// Corrected poses of characters, and matrices of poses as text.
#include "sinew_character/pose/deform.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "block_body.hpp"
#include "expect_error.hpp"
#include "sinew_character/pose/pose.hpp"
#include "sinew_formats/io.hpp"

namespace sinew {
namespace {

Character bar() {
  Character c;
  c.name = "bar";
  c.joints = {{"a", {0, 0, 0}, -1}, {"b", {0, 2, 0}, 0}};
  for (int ring = 0; ring < 5; ++ring) {
    const float y = static_cast<float>(ring), share = y / 4;
    for (const Vec3& p : {Vec3{0, y, 0}, Vec3{1, y, 0}, Vec3{1, y, 1}, Vec3{0, y, 1}}) {
      c.vertices.push_back(p);
      c.influences.push_back({{0, 1 - share}, {1, share}});
    }
  }
  for (uint32_t ring = 0; ring < 4; ++ring)
    for (uint32_t side = 0; side < 4; ++side) {
      const uint32_t a = 4 * ring + side, b = 4 * ring + (side + 1) % 4;
      c.face_vertices.insert(c.face_vertices.end(), {a, a + 4, b + 4, b});
      c.face_offsets.push_back(static_cast<uint32_t>(c.face_vertices.size()));
    }
  c.vertices.push_back({9, 9, 9});  // bound to nothing
  c.influences.emplace_back();
  return c;
}

TEST(CharacterDeformer, KeepsTheRestPoseAndMovesTheBoundVertices) {
  const Character c = bar();
  CharacterDeformer deformer(c, SINEW_INIT(sinew_deform_options));
  const Character still = deformer.pose_character(c, pose_palette(c, {}));
  for (size_t v = 0; v < c.vertices.size(); ++v) {
    EXPECT_EQ(still.vertices[v].x, c.vertices[v].x);
    EXPECT_EQ(still.vertices[v].y, c.vertices[v].y);
  }
  const Character bent = deformer.pose_character(c, pose_palette(c, {{1, 0, 0, 60}}));
  EXPECT_GT(std::abs(bent.vertices[16].x - c.vertices[16].x), 0.5f);
  EXPECT_EQ(bent.vertices.back().x, 9);
  EXPECT_TRUE(deformer.corrected());
  EXPECT_NEAR(bent.joints[1].position.y, 2, 1e-6f);
}

// Thighs that have grown together: one leg swings forward, and the other, whose joints stand still, stays.
TEST(CharacterDeformer, CorrectionsDoNotCrossSeams) {
  const Character body = block_body(1, 3);
  sinew_deform_options options = SINEW_INIT(sinew_deform_options);
  options.method = SINEW_DEFORM_DELTA_MUSH;
  CharacterDeformer deformer(body, options);
  const Character posed = deformer.pose_character(body, pose_palette(body, {{kLeftUpLeg, 40, 0, 0}}));
  ASSERT_EQ(posed.vertices.size(), body.vertices.size());
  float moved = 0, swung = 0;
  for (size_t v = 0; v < body.vertices.size(); ++v) {
    const uint32_t joint = body.influences[v][0].joint;
    const float off = std::abs(posed.vertices[v].z - body.vertices[v].z);
    if (joint == kRightUpLeg || joint == kRightLeg) moved = std::max(moved, body.vertices[v].y < 4 ? off : 0);
    if (joint == kLeftLeg) swung = std::max(swung, off);
  }
  EXPECT_GT(swung, 2);
  EXPECT_LT(moved, 0.05f);
}

TEST(CharacterDeformer, RefusesWhatDoesNotFit) {
  Character c = bar();
  CharacterDeformer deformer(c, SINEW_INIT(sinew_deform_options));
  EXPECT_ERROR(deformer.pose({}), "bar", "2");
  std::vector<Affine> palette = pose_palette(c, {});
  palette[1][3] = 1e30;
  EXPECT_ERROR(deformer.pose(palette), "bar", "finite");
  c.influences[3][0].joint = 7;
  EXPECT_ERROR(CharacterDeformer(c, SINEW_INIT(sinew_deform_options)), "vertex 3", "joint 7");
}

TEST(PoseMatrices, JointsThatAreLeftOutStay) {
  const auto path = (std::filesystem::temp_directory_path() / "sinew_matrices_test.pose").string();
  write_text_file(path, "# one\npose b 1 0 0 0.5 0 1 0 -2 0 0 1 3e-1\n");
  const std::vector<Affine> palette = read_pose_matrices(path, bar());
  EXPECT_EQ(palette[0], (Affine{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}));
  EXPECT_EQ(palette[1][3], 0.5);
  EXPECT_EQ(palette[1][7], -2);
  write_text_file(path, "pose b 1 0 0 0.5 0 1 0 -2 0 0 1 3e-1\npose c 1 0 0 0 0 1 0 0 0 0 1 0\n");
  EXPECT_ERROR(read_pose_matrices(path, bar()), ":2", "'c'");
  write_text_file(path, "pose b 1 0 0 inf 0 1 0 -2 0 0 1 3e-1\n");
  EXPECT_ERROR(read_pose_matrices(path, bar()), ":1", "finite", "'inf'");
  std::filesystem::remove(path);
}

}  // namespace
}  // namespace sinew
