// SPDX-License-Identifier: MIT
// Clips of one skeleton for another: how much body both share, frames, canceling, errors.
#include "sinew_character/motion/retarget.hpp"

#include <gtest/gtest.h>

#include "expect_error.hpp"
#include "strip_of_quads.hpp"
#include "swinging_motion.hpp"

namespace sinew {
namespace {

TEST(Retargeter, SaysHowMuchBodyTheTwoShare) {
  const Motion motion = swing(5);
  const Character thin = strip(60, 3, 0, 1), wide = strip(60, 0, 0, 2), other = strip(20, 0, 0, 1);
  Retargeter retargeter(motion, rest_joints(motion), {0, 1}, {17, 17});
  EXPECT_EQ(retargeter.take_bodies(thin, &wide), 120u);
  EXPECT_EQ(retargeter.take_bodies(thin, &other), 0u) << "40 triangles are no body";
  EXPECT_EQ(retargeter.take_bodies(thin, nullptr), 0u);
  EXPECT_EQ(retargeter.run(motion.clips[0]).frames.size(), 5u);
  Character unbound = wide;
  unbound.influences.clear();
  EXPECT_EQ(retargeter.take_bodies(thin, &unbound), 0u);
}

TEST(Retargeter, PlaysAClipAndCanBeStopped) {
  const Motion motion = swing(5);
  const std::vector<Joint> joints = rest_joints(motion);
  Retargeter same(motion, joints, {0, 1}, {17, 17});
  const Clip clip = same.run(motion.clips[0]);
  ASSERT_EQ(clip.frames.size(), 5u);
  for (size_t f = 0; f < 5; ++f) {
    EXPECT_NEAR(dot(clip.frames[f].rotations[1], motion.clips[0].frames[f].rotations[1]), 1, 1e-9);
    EXPECT_NEAR(clip.frames[f].translations[0][0], motion.clips[0].frames[f].translations[0][0], 1e-6);
  }
  int asked = 0;
  EXPECT_ERROR((void)same.run(motion.clips[0], [&] { return ++asked < 3; }), "swing", "interrupted");
  EXPECT_EQ(asked, 3);
  EXPECT_ERROR(Retargeter(motion, joints, {-1, -1}, {17, 17}), "swing", "cannot retarget");
}

}  // namespace
}  // namespace sinew
