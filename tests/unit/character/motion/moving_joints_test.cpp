// SPDX-License-Identifier: MIT
// Means over frames, mirror images by counts and lengths.
#include <gtest/gtest.h>

#include <cmath>

#include "sinew_character/motion/stance.hpp"
#include "sinew_formats/base/point.hpp"
#include "swinging_motion.hpp"
#include "walking_motion.hpp"

namespace sinew {
namespace {

TEST(MovingJoints, MeansAreSeenFromAJoint) {
  Motion motion = swing(5);                                         // 0 to 0.4 radians about z
  for (double& x : motion.clips[0].frames[4].rotations[1]) x = -x;  // the same rotation
  const MovingJoints moving(motion);
  EXPECT_EQ(moving.frame_count(), 5u);
  const std::vector<size_t> frames = {0, 1, 2, 3, 4};
  EXPECT_NEAR(std::abs(dot(moving.mean_rotation(frames, 0, 1), axis_rotation(2, 0.2))), 1, 1e-12);
  EXPECT_NEAR(std::abs(dot(moving.mean_rotation(frames, 1, 0), axis_rotation(2, -0.2))), 1, 1e-12);
  EXPECT_LT(length(moving.mean_difference(frames, 0, 0, 1) - Point3{0, 1, 0}), 1e-12);
  EXPECT_LT(length(moving.mean_direction(frames, 1, {1, 0, 0}) - rotate(axis_rotation(2, -0.2), Point3{1, 0, 0})),
            1e-12);
  EXPECT_TRUE(moving.is_still(0));
  EXPECT_FALSE(moving.is_still(1));
  const std::vector<size_t> last = moving.best_frames(0.5, [](size_t f) { return static_cast<double>(f); });
  EXPECT_EQ(last, (std::vector<size_t>{4, 3}));
}

TEST(MovingJoints, LimbsAreMirrorImagesByTheirLengths) {
  const Motion walk = walking_person();
  const Motion written = with_random_axes(numbered(walk));
  const MovingJoints moving(written);
  EXPECT_EQ(moving.trunk_root(), 0);
  const auto pairs = moving.mirror_pairs();
  EXPECT_EQ(pairs.size(), 10u);
  for (const auto& [a, b] : pairs)
    EXPECT_EQ("Right" + walk.joints[static_cast<size_t>(a)].name.substr(4), walk.joints[static_cast<size_t>(b)].name);
}

TEST(MovingJoints, PosesAreOfRotationsInTheWorld) {
  const Motion motion = swing(2);
  const MovingJoints moving(motion);
  const std::vector<Point3> positions = moving.posed({axis_rotation(2, std::acos(0.0)), kNoRotation4});
  EXPECT_LT(length(positions[1] - Point3{-1, 0, 0}), 1e-12);
}

}  // namespace
}  // namespace sinew
