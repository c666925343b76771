// SPDX-License-Identifier: MIT
// A clip's name means that of the body it is for.
#include "sinew_character/motion/motion_file.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "expect_error.hpp"
#include "sinew_formats/base/point.hpp"
#include "sinew_formats/io.hpp"
#include "walking_motion.hpp"

namespace sinew {
namespace {

MapRig sample(const std::string& name) {
  return map_rig_of(read_character(SINEW_SOURCE_DIR "/samples/data/" + name + ".obj"));
}

TEST(MotionFile, AWalkIsThatOfTheCharactersLimbs) {
  EXPECT_EQ(read_motion_for({"builtin:walk"}, sample("biped__robot")).motion.joints[0].name, "mixamorig:Hips");
  EXPECT_EQ(read_motion_for({"builtin:walk"}, sample("quadruped__tailed")).motion.joints[0].name, "Hips");
  EXPECT_EQ(read_motion_for({"builtin:idle"}, sample("quadruped__tailed")).motion.clips.size(), 1u);
  EXPECT_EQ(read_motion_for({"builtin:trot"}, sample("quadruped__tailed")).motion.joints.size(),
            read_motion_for({"builtin:quadruped2/trot"}, sample("quadruped__tailed")).motion.joints.size())
      << "it has no hocks";
  EXPECT_EQ(read_motion_for({"builtin:person/walk"}, sample("quadruped__tailed")).motion.joints[0].name,
            "mixamorig:Hips")
      << "as it was asked for";
  EXPECT_ERROR(read_motion_for({"builtin:fly"}, sample("biped__robot")), "builtin:fly", "bird: flap");
  EXPECT_ERROR(read_motion_for({"builtin:wave", 0, "", "eve"}, sample("biped__robot")), "found 'eve'");
  EXPECT_ERROR(read_motion_for({"walk.doc"}, sample("biped__robot")), "walk.doc", "expected a motion");
}

// Frames that go over another floor than their rest pose are turned; those that lie on it are not.

constexpr size_t kX = 0;
const double kQuarter = std::acos(0.0);

// Frames turned in the world and moved, the rest pose as it was.
Motion turned_frames(Motion motion, const Quaternion& turn, const Point3& by = {}) {
  for (MotionFrame& frame : motion.clips[0].frames) {
    frame.rotations[0] = multiply(turn, frame.rotations[0]);
    frame.translations[0] = rotate(turn, frame.translations[0]) + by;
  }
  return motion;
}

TEST(RestFloor, FramesOfAnotherUpAreTurnedUpright) {
  const Motion walk = walking_person();
  const Motion other = turned_frames(walk, axis_rotation(kX, kQuarter));
  const std::optional<Motion> found = motion_on_rest_floor(other);
  ASSERT_TRUE(found);
  for (size_t f = 0; f < walk.clips[0].frames.size(); ++f) {
    const WorldPose a = world_pose(walk, walk.clips[0].frames[f]), b = world_pose(*found, found->clips[0].frames[f]);
    for (size_t j = 0; j < walk.joints.size(); ++j) ASSERT_LT(length(a.positions[j] - b.positions[j]), 1e-9) << f;
  }
  ASSERT_EQ(found->notes.size(), 1u);
  EXPECT_NE(found->notes[0].find("its rest pose has y up and its frames have z up"), std::string::npos);
}

// Cameras have y down: the body is turned over, and a handstand stays what it is.
TEST(UpsideDown, WorldsWithADownAxisAreTurnedOver) {
  const Motion walk = walking_person();
  for (const Axis axis : {Axis::kX, Axis::kY, Axis::kZ}) {
    const double turn = axis == Axis::kY ? 0 : axis == Axis::kX ? -1 : 1;
    const Motion up = turned_world(walk, axis_rotation(axis == Axis::kX ? 2 : 0, turn * kQuarter));
    EXPECT_FALSE(axis_that_points_down(up));
    const Motion down = turned_over(up, axis);
    EXPECT_EQ(axis_that_points_down(down), MaybeAxis(axis));
    const Motion back = turned_over(down, axis);
    for (size_t f = 0; f < walk.clips[0].frames.size(); f += 7) {
      const WorldPose a = world_pose(up, up.clips[0].frames[f]), b = world_pose(back, back.clips[0].frames[f]),
                      c = world_pose(down, down.clips[0].frames[f]);
      for (size_t j = 0; j < walk.joints.size(); ++j) {
        ASSERT_LT(length(a.positions[j] - b.positions[j]), 1e-9);
        ASSERT_NEAR(a.positions[j][static_cast<size_t>(axis)], -c.positions[j][static_cast<size_t>(axis)], 1e-9);
      }
    }
  }
  EXPECT_FALSE(axis_that_points_down(turned_frames(walk, axis_rotation(kX, 2 * kQuarter)))) << "on its hands";
}

TEST(RestFloor, WhatStandsOrLiesOnItsOwnFloorStays) {
  const Motion walk = walking_person();
  EXPECT_FALSE(motion_on_rest_floor(walk));
  EXPECT_FALSE(motion_on_rest_floor(turned_world(walk, axis_rotation(kX, kQuarter)))) << "z up at rest, too";
  Motion there = walk;
  for (MotionFrame& frame : there.clips[0].frames) frame.translations[0][2] = 0;
  EXPECT_TRUE(motion_on_rest_floor(turned_frames(there, axis_rotation(kX, kQuarter))));
  EXPECT_FALSE(motion_on_rest_floor(turned_frames(there, axis_rotation(kX, kQuarter), {0, 0.4, 0}))) << "asleep";
  EXPECT_FALSE(motion_on_rest_floor(turned_frames(walk, axis_rotation(kX, kQuarter), {0, 5, -1}))) << "it swims";
  EXPECT_FALSE(motion_on_rest_floor(turned_frames(walk, axis_rotation(kX, 0.6)))) << "it leans";
  Motion still = walk;
  still.clips.clear();
  EXPECT_FALSE(motion_on_rest_floor(still));
}

}  // namespace
}  // namespace sinew
