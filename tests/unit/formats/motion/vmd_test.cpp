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
                  kLeftLegIk = "\x8d\xb6\x91\xab\x82\x68\x82\x6a", kFinger = "\x8d\xb6\x90\x6c\x8e\x77\x82\x50",
                  kSkirt = "\x83\x58\x83\x4a\x81\x5b\x83\x67";

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
  ASSERT_EQ(motion.notes.size(), 1u);
  EXPECT_EQ(motion.notes[0], "1 bones without a standard name were left out");
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
}

struct Leg {
  Point3 hip, knee, ankle;
  Quaternion thigh, foot;
};
Leg leg_of(const Motion& motion, size_t frame, const std::string& side = "left") {
  const WorldPose pose = world_pose(motion, motion.clips[0].frames[frame]);
  const size_t upper = find_joint(motion, side + "UpperLeg"), lower = find_joint(motion, side + "LowerLeg"),
               foot = find_joint(motion, side + "Foot");
  return {pose.positions[upper], pose.positions[lower], pose.positions[foot], pose.rotations[upper],
          pose.rotations[foot]};
}
// By how much the knee stands before the line from hip to ankle.
double knee_before_leg(const Leg& leg) {
  return dot(across(leg.knee - leg.hip, unit(leg.ankle - leg.hip)), rotate(leg.thigh, {0, 0, 1}));
}

// A dance as MMD has it: the center goes down, feet are led by their IK bones, legs have hardly any keys.
TEST(Vmd, FeetGoWhereTheirIkBonesAreAndKneesBendForward) {
  const std::array<float, 4> turned = {0, std::sin(0.3f), 0, std::cos(0.3f)};
  const Motion motion = read(vmd_of({{kCenter, 0},
                                     {kCenter, 10, {0, -3, 0}},
                                     {kCenter, 20, {0, 0, 0}, {0, 1, 0, 0}},
                                     {kLeftLegIk, 0},
                                     {kLeftLegIk, 10, {1, 2, -3}, turned},
                                     {kLeftLegIk, 20},
                                     {kRightLegIk, 0},
                                     {kRightLegIk, 10},
                                     {kRightLegIk, 20, {20, 0, 0}}}));
  EXPECT_TRUE(motion.notes.empty());
  EXPECT_EQ(find_joint(motion, "leftFootIk"), motion.joints.size()) << "no joint of its own";
  const Point3 left_rest = leg_of(motion, 0).ankle, right_rest = leg_of(motion, 0, "right").ankle;
  const std::vector<Joint> rest = rest_joints(motion);
  EXPECT_LT(length(left_rest - point(rest[find_joint(motion, "leftFoot")].position)), 1e-6) << "at rest";
  const Leg left = leg_of(motion, 10), right = leg_of(motion, 10, "right");
  EXPECT_LT(length(left.ankle - (left_rest + 0.08 * Point3{1, 2, 3})), 1e-6);
  EXPECT_NEAR(std::abs(dot(left.foot, axis_rotation(1, -0.6))), 1, 1e-6) << "the foot turns as its IK bone";
  EXPECT_LT(length(right.ankle - right_rest), 1e-6) << "stays while the center goes down";
  EXPECT_GT(knee_before_leg(left), 0.1);
  EXPECT_GT(knee_before_leg(right), 0.1);
  EXPECT_NEAR(length(left.knee - left.hip), length(leg_of(motion, 0).knee - leg_of(motion, 0).hip), 1e-6);
  const size_t right_knee = find_joint(motion, "rightLowerLeg");
  EXPECT_NEAR(std::abs(motion.clips[0].frames[20].rotations[right_knee][3]), 1, 1e-9) << "never bends backward";
  const Leg far = leg_of(motion, 20, "right");
  EXPECT_GT(dot(unit(far.ankle - far.hip), unit(right_rest + Point3{1.6, 0, 0} - far.hip)), 1 - 1e-6) << "out of reach";
}

TEST(Vmd, IkThatIsSwitchedOffOrBakedLeavesLegsToTheirKeys) {
  const std::vector<VmdKey> keys = {{kLeftKnee, 0, {}, {std::sin(0.5f), 0, 0, std::cos(0.5f)}},
                                    {kLeftLegIk, 0, {0, 5, 0}},
                                    {kLeftLegIk, 10, {0, 5, 0}}};
  const auto bend = [](const Motion& motion, size_t frame) {
    return std::abs(
        dot(motion.clips[0].frames[frame].rotations[find_joint(motion, "leftLowerLeg")], axis_rotation(0, -1)));
  };
  EXPECT_LT(bend(read(vmd_of(keys)), 0), 0.99);
  const Motion switched = read(vmd_of(keys, {{4, kLeftLegIk, false}, {8, kLeftLegIk, true}}));
  EXPECT_LT(bend(switched, 3), 0.99);
  EXPECT_NEAR(bend(switched, 5), 1, 1e-6);
  EXPECT_LT(bend(switched, 8), 0.99);
  const Motion baked = read(vmd_of({keys[0], {kLeftLegIk, 0}}));
  EXPECT_NEAR(bend(baked, 0), 1, 1e-6);
}

TEST(Vmd, OtherIkIsToldWhereItMoves) {
  const std::string toe_ik = "\x8d\xb6\x82\xc2\x82\xdc\x90\xe6\x82\x68\x82\x6a";
  EXPECT_TRUE(read(vmd_of({{kCenter, 0}, {toe_ik, 0}})).notes.empty());
  EXPECT_EQ(read(vmd_of({{kCenter, 0}, {toe_ik, 0, {0, 1, 0}}})).notes.at(0),
            "1 IK bones other than feet were left out");
}

TEST(Vmd, ReadsEnglishBones) {
  const auto about = [](float x, float y, float z) {
    return std::array<float, 4>{std::sin(x / 2), std::sin(y / 2), std::sin(z / 2), std::cos((x + y + z) / 2)};
  };
  const Motion motion = read(vmd_of({{"Center", 0, {0, 5, 0}},
                                     {"Arm1-L[Y]", 0, {}, about(0, 0.5f, 0)},
                                     {"Ankle-L[Y]", 0, {}, about(0, 0.5f, 0)},
                                     {"Ankle-L[X]", 0, {}, about(0.25f, 0, 0)},
                                     {"elbow_R", 0, {}, about(0, 0, 0.5f)},
                                     {"Left knee", 0, {}, about(-0.5f, 0, 0)},
                                     {"Finger2-1R[XYZ]", 0},
                                     {"thumb0_L", 0},
                                     {"Blade-R", 0}}));
  const MotionFrame& frame = motion.clips[0].frames[0];
  const auto same = [&](const char* joint, const Quaternion& rotation) {
    const size_t at = find_joint(motion, joint);
    ASSERT_LT(at, motion.joints.size()) << joint;
    EXPECT_NEAR(std::abs(dot(frame.rotations[at], rotation)), 1, 1e-6) << joint;
  };
  same("leftUpperArm", axis_rotation(1, -0.5));
  same("leftFoot", multiply(axis_rotation(1, -0.5), axis_rotation(0, -0.25)));
  same("rightLowerArm", axis_rotation(2, 0.5));
  same("leftLowerLeg", axis_rotation(0, 0.5));
  same("rightIndexProximal", kNoRotation4);
  same("leftThumbMetacarpal", kNoRotation4);
  EXPECT_NEAR(frame.translations[find_joint(motion, "center")][1], 0.95 + 0.4, 1e-6);
  ASSERT_EQ(motion.notes.size(), 1u);
  EXPECT_EQ(motion.notes[0], "1 bones without a standard name were left out");
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
