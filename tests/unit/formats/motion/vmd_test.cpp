// SPDX-License-Identifier: MIT
// VMD: standard bones by their Shift-JIS names, curves between keys, what is left out is told.
#include <gtest/gtest.h>

#include <cmath>

#include "expect_error.hpp"
#include "sinew_formats/base/point.hpp"
#include "sinew_formats/motion.hpp"
#include "temp_folder.hpp"
#include "vmd_bytes.hpp"

namespace sinew {
namespace {

using test::vmd_of;
using test::VmdKey;

const std::string kCenter = "\x83\x5a\x83\x93\x83\x5e\x81\x5b", kLeftKnee = "\x8d\xb6\x82\xd0\x82\xb4",
                  kRightElbow = "\x89\x45\x82\xd0\x82\xb6", kRightLegIk = "\x89\x45\x91\xab\x82\x68\x82\x6a",
                  kFinger = "\x8d\xb6\x90\x6c\x8e\x77\x82\x50", kSkirt = "\x83\x58\x83\x4a\x81\x5b\x83\x67";

Motion read(const std::string& bytes) {
  const TempFolder folder;
  return read_motion(folder.write("dance.vmd", bytes));
}
size_t find_joint(const Motion& motion, const std::string& name) {
  for (size_t j = 0; j < motion.joints.size(); ++j)
    if (motion.joints[j].name == name) return j;
  return motion.joints.size();
}

TEST(Vmd, ReadsStandardBones) {
  const Motion motion = read(vmd_of({{kLeftKnee, 10, {}, {std::sin(0.5f), 0, 0, std::cos(0.5f)}},
                                     {kLeftKnee, 0},
                                     {kCenter, 0},
                                     {kCenter, 10, {5, -2, 10}},
                                     {kRightElbow, 4, {}, {0, 0, std::sin(0.25f), std::cos(0.25f)}},
                                     {kRightLegIk, 0},
                                     {kSkirt, 0}}));
  EXPECT_EQ(motion.name, "dance");
  ASSERT_EQ(motion.clips[0].frames.size(), 11u);
  EXPECT_DOUBLE_EQ(motion.clips[0].frame_time, 1.0 / 30);
  const size_t knee = find_joint(motion, "leftLowerLeg"), center = find_joint(motion, "center"),
               elbow = find_joint(motion, "rightLowerArm");
  ASSERT_LT(elbow, motion.joints.size());
  EXPECT_EQ(motion.joints[knee].parent, static_cast<int>(find_joint(motion, "leftUpperLeg")));
  EXPECT_EQ(find_joint(motion, "leftIndexProximal"), motion.joints.size()) << "no finger has keys";
  // From a left-handed world: z and turns about x and y the other way.
  const MotionFrame &last = motion.clips[0].frames[10], &middle = motion.clips[0].frames[5];
  EXPECT_NEAR(std::abs(dot(last.rotations[knee], axis_rotation(0, -1))), 1, 1e-6);
  EXPECT_NEAR(std::abs(dot(last.rotations[elbow], axis_rotation(2, 0.5))), 1, 1e-6);
  EXPECT_NEAR(std::abs(dot(motion.clips[0].frames[0].rotations[elbow], axis_rotation(2, 0.5))), 1, 1e-6)
      << "before its first key";
  const Point3 moved = last.translations[center] - motion.joints[center].offset;
  EXPECT_NEAR(moved[0], 0.4, 1e-6);
  EXPECT_NEAR(moved[1], -0.16, 1e-6);
  EXPECT_NEAR(moved[2], -0.8, 1e-6);
  EXPECT_NEAR(std::abs(dot(middle.rotations[knee], axis_rotation(0, -0.5))), 1, 1e-6) << "a straight curve";
  ASSERT_EQ(motion.notes.size(), 2u);
  EXPECT_EQ(motion.notes[0], "1 IK bones were left out");
  EXPECT_EQ(motion.notes[1], "1 bones without a standard name were left out");
  // A person with arms lowered, left at +x, facing +z.
  const std::vector<Joint> rest = rest_joints(motion);
  EXPECT_GT(rest[find_joint(motion, "leftHand")].position.x, 0.4f);
  EXPECT_LT(rest[find_joint(motion, "leftHand")].position.y,
            rest[find_joint(motion, "leftUpperArm")].position.y - 0.2f);
  EXPECT_GT(rest[find_joint(motion, "leftToes")].position.z, 0.05f);
  EXPECT_NEAR(double{rest[find_joint(motion, "hips")].position.y}, 0.95, 1e-6);
}

TEST(Vmd, CurvesSayHowAKeyIsReached) {
  const auto at = [](std::array<uint8_t, 4> curve) {
    const Motion motion = read(vmd_of({{kCenter, 0}, {kCenter, 10, {10, 0, 0}, {0, 0, 0, 1}, curve}}));
    return motion.clips[0].frames[5].translations[find_joint(motion, "center")][0] / 0.8;
  };
  EXPECT_NEAR(at({20, 20, 107, 107}), 0.5, 1e-9);
  EXPECT_NEAR(at({127, 0, 127, 0}), 0.00878, 1e-5) << "late";
  EXPECT_NEAR(at({0, 127, 0, 127}), 1 - 0.00878, 1e-5) << "early";
  EXPECT_NEAR(at({64, 0, 64, 127}), 0.5, 1e-2) << "slow at both ends";
}

TEST(Vmd, FingersComeWhereTheyHaveKeys) {
  const Motion motion = read(vmd_of({{kFinger, 0}, {kRightLegIk, 0}}));
  const size_t finger = find_joint(motion, "leftIndexProximal");
  ASSERT_LT(finger, motion.joints.size());
  EXPECT_EQ(motion.joints[finger].parent, static_cast<int>(find_joint(motion, "leftHand")));
  EXPECT_LT(find_joint(motion, "rightIndexProximal"), motion.joints.size()) << "of both sides";
  EXPECT_EQ(motion.notes[0], "1 IK bones were left out, and nothing else moves the legs; bake IK into bones first");
}

TEST(Vmd, WhatIsWrongIsOneLine) {
  EXPECT_ERROR(read(""), "dance.vmd", "truncated VMD, expected 30 bytes");
  EXPECT_ERROR(read(std::string(200, 'x')), "expected a VMD");
  EXPECT_ERROR(read(vmd_of({})), "expected keys of bones, found none");
  EXPECT_ERROR(read(vmd_of({{kSkirt, 0}})), "expected bones with standard names, found 1 bones with others");
  EXPECT_ERROR(read(vmd_of({{kCenter, 0, {NAN, 0, 0}}})), "expected finite numbers in key 0");
  EXPECT_ERROR(read(vmd_of({{kCenter, 0xffffffff}})), "expected at most", "a key at frame 4294967295");
  const std::string whole = vmd_of({{kCenter, 0}, {kLeftKnee, 3}});
  for (size_t length = 0; length < whole.size() - 8; ++length)
    EXPECT_ERROR(read(whole.substr(0, length)), "dance.vmd", "VMD");
}

}  // namespace
}  // namespace sinew
