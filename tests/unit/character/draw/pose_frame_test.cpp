// SPDX-License-Identifier: MIT
// What a picture of a moving character frames: all of it in every pose, and no ground.
#include "sinew_character/draw/pose_frame.hpp"

#include <gtest/gtest.h>

namespace sinew {
namespace {

// A stick of three vertices of joint 0, and a square of joint 1 on the floor.
Character stick_on_ground(float ground) {
  Character character;
  character.joints.resize(2);
  character.vertices = {{0, 0, 0}, {0, 1, 0}, {0.2f, 0.5f, 0}};
  character.influences = {{{0, 1}}, {{0, 1}}, {{0, 1}}};
  for (const float x : {-ground, ground})
    for (const float z : {-ground, ground}) {
      character.vertices.push_back({x, 0, z});
      character.influences.push_back({{1, 1}});
    }
  return character;
}

Character moved(const Character& rest, const Vec3& by) {
  Character out = rest;
  for (size_t v = 0; v < 3; ++v) {
    const Vec3& p = rest.vertices[v];
    out.vertices[v] = {p.x + by.x, p.y + by.y, p.z + by.z};
  }
  return out;
}

TEST(PoseFrame, NoPoseLeavesThePicture) {
  const Character rest = stick_on_ground(0.1f);
  const std::vector<Character> poses = {rest, moved(rest, {0, 2, 0}), moved(rest, {5, 0.5f, 0})};
  const PoseFrame frame = frame_poses(rest, poses, Axis::kY);
  ASSERT_EQ(frame.middles.size(), 3u);
  for (size_t k = 0; k < poses.size(); ++k) {
    EXPECT_FLOAT_EQ(frame.middles[k].y, 1.5f) << "one height, from the floor to the highest jump";
    for (size_t v = 0; v < 3; ++v) {
      const Vec3 &p = poses[k].vertices[v], &middle = frame.middles[k];
      EXPECT_LE(std::hypot(p.x - middle.x, p.y - middle.y, p.z - middle.z), frame.radius * 1.05f) << k << " " << v;
    }
  }
  EXPECT_LT(frame.radius, 3.5f);
}

TEST(PoseFrame, AGroundIsNotFramed) {
  const Character rest = stick_on_ground(20);
  const PoseFrame frame = frame_poses(rest, {rest, moved(rest, {0, 0.3f, 0})}, Axis::kY);
  EXPECT_LT(frame.radius, 1);
  const PoseFrame still = frame_poses(rest, {rest}, Axis::kY);
  EXPECT_GT(still.radius, 20) << "where nothing moves all is framed";
}

}  // namespace
}  // namespace sinew
