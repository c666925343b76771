// SPDX-License-Identifier: MIT
// Acclaim: bones as directions and lengths, angles in axes of their own, the skeleton beside the frames.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "expect_error.hpp"
#include "sinew_formats/base/point.hpp"
#include "sinew_formats/motion.hpp"
#include "temp_folder.hpp"

namespace sinew {
namespace {

// A hip without numbers, a thigh whose axes are turned by 90 degrees about z, a shin.
const std::string kAsfSkeleton = R"(# AST/ASF file
:version 1.10
:name leg
:units
  mass 1.0
  length 0.45
  angle deg
:root
  order TX TY TZ RX RY RZ
  axis XYZ
  position 0 0 0
  orientation 0 0 0
:bonedata
  begin
    id 1
    name lhip
    direction 1 0 0
    length 2
    axis 0 0 0 XYZ
  end
  begin
    id 2
    name lfemur
    direction 0 -1 0
    length 8
    axis 0 0 90 XYZ
    dof rx ry rz
    limits (-160 20)
           (-70 70)
           (-60 70)
  end
  begin
    id 3
    name ltibia
    direction 0 -2 0
    length 7
    axis 0 0 0 XYZ
    dof rx
  end
:hierarchy
  begin
    root lhip
    lhip lfemur
    lfemur ltibia
  end
)";
const std::string kAmcFrames = R"(#!OML:ASF
:FULLY-SPECIFIED
:DEGREES
1
root 0 15 0 0 0 0
lfemur 0 0 0
ltibia 0
2
root 0 15 9 0 90 0
lfemur 0 90 0
ltibia 90
)";
constexpr double kAsfUnit = 0.0254 / 0.45;

Motion read_pair(const std::string& skeleton, const std::string& frames) {
  const TempFolder folder;
  folder.write("07.asf", skeleton);
  return read_motion(folder.write("07_01.amc", frames));
}
void expect_position(const Motion& motion, size_t frame, size_t joint, const Point3& expected) {
  const Point3 found = world_pose(motion, motion.clips[0].frames[frame]).positions[joint];
  EXPECT_LT(length(found - kAsfUnit * expected), 1e-9)
      << frame << " " << motion.joints[joint].name << " " << found[0] / kAsfUnit << " " << found[1] / kAsfUnit << " "
      << found[2] / kAsfUnit;
}

TEST(Amc, ReadsBonesThatTurnInTheirOwnAxes) {
  const Motion motion = read_pair(kAsfSkeleton, kAmcFrames);
  EXPECT_EQ(motion.name, "07_01");
  ASSERT_EQ(motion.joints.size(), 5u);
  EXPECT_EQ(motion.joints[3].name, "ltibia");
  EXPECT_EQ(motion.joints[3].parent, 2);
  EXPECT_EQ(motion.joints[4].name, "ltibia_end");
  EXPECT_TRUE(motion.joints[4].end);
  ASSERT_EQ(motion.clips[0].frames.size(), 2u);
  EXPECT_DOUBLE_EQ(motion.clips[0].frame_time, 1.0 / 120);
  EXPECT_NE(motion.notes.at(0).find("assumed"), std::string::npos);
  expect_position(motion, 0, 0, {0, 15, 0});
  expect_position(motion, 0, 2, {2, 15, 0});
  expect_position(motion, 0, 3, {2, 7, 0});
  expect_position(motion, 0, 4, {2, 0, 0});
  // The root turns by 90 degrees about y: x to -z. The thigh's y axis is -x: it swings -y to z, which the root turns to x.
  expect_position(motion, 1, 2, {0, 15, 7});
  expect_position(motion, 1, 3, {8, 15, 7});
  EXPECT_NEAR(double{rest_joints(motion)[0].position.y}, 15 * kAsfUnit, 1e-6)
      << "at rest the lowest joint is on the floor";
}

TEST(Amc, RadiansAndTheOrderOfAnglesAreTheFiles) {
  const double quarter = std::numbers::pi / 2;
  std::string skeleton = kAsfSkeleton, frames = kAmcFrames;
  skeleton.replace(skeleton.find("axis 0 0 90"), 11, "axis 0 0 " + std::to_string(quarter));
  skeleton.replace(skeleton.find("angle deg"), 9, "angle rad");
  frames.replace(frames.find(":DEGREES"), 8, ":RADIANS");
  frames.replace(frames.find("9 0 90 0"), 8, "9 0 " + std::to_string(quarter) + " 0");
  frames.replace(frames.find("lfemur 0 90"), 11, "lfemur 0 " + std::to_string(quarter));
  const Motion motion = read_pair(skeleton, frames);
  const Point3 knee = world_pose(motion, motion.clips[0].frames[1]).positions[3];
  EXPECT_LT(length(knee - kAsfUnit * Point3{8, 15, 7}), 1e-5);
}

TEST(Amc, TheSkeletonLiesBesideTheFrames) {
  const TempFolder folder;
  const std::string path = folder.write("walk.amc", kAmcFrames);
  EXPECT_ERROR(read_motion(path), "walk.amc: expected its skeleton beside it, walk.asf, found none",
               "copy the matching .asf");
  folder.write("person.asf", kAsfSkeleton);
  EXPECT_EQ(read_motion(path).joints.size(), 5u) << "the only one";
  folder.write("other.asf", "");
  EXPECT_ERROR(read_motion(path), "found 2 others");
  folder.write("walk.asf", kAsfSkeleton);
  EXPECT_EQ(read_motion(path).joints.size(), 5u);
}

TEST(Amc, WhatIsWrongIsOneLine) {
  const auto fails = [](const std::string& what, const std::string& with, const std::string& expected) {
    std::string skeleton = kAsfSkeleton, frames = kAmcFrames;
    std::string& text = skeleton.find(what) != std::string::npos ? skeleton : frames;
    const size_t at = text.find(what);
    ASSERT_NE(at, std::string::npos) << what;
    text.replace(at, what.size(), with);
    EXPECT_ERROR(read_pair(skeleton, frames), expected);
  };
  fails("length 8", "length x", "07.asf:25: expected a finite number as a length, found 'x'");
  fails("length 0.45", "length 0", "07.asf:6: expected a length above 0");
  fails("    lfemur ltibia\n", "    lfemur ltoes\n", "expected a bone of ':bonedata', found 'ltoes'");
  fails("    lfemur ltibia\n", "    lfemur lhip\n", "expected a tree of bones");
  fails("    lfemur ltibia\n", "", "expected a parent of each bone");
  fails("ltibia 90", "lfoot 90", "07_01.amc:11: expected a bone of the .asf, found 'lfoot'");
  fails("ltibia 90", "ltibia 90 1", "expected 1 numbers of ltibia, found '2 numbers'");
  EXPECT_ERROR(read_pair(kAsfSkeleton, ":DEGREES\n"), "07_01.amc: expected frames, found none");
  EXPECT_ERROR(read_pair("", kAmcFrames), "07.asf: expected an Acclaim skeleton with ':bonedata', found no bone");
  for (size_t length = 0; length < kAsfSkeleton.size(); length += 7) {
    try {
      EXPECT_EQ(read_pair(kAsfSkeleton.substr(0, length), kAmcFrames).clips.size(), 1u);
    } catch (const Error& error) {
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    }
  }
}

}  // namespace
}  // namespace sinew
