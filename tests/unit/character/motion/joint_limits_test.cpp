// SPDX-License-Identifier: MIT
// Limits from text, from a robot's URDF and of a human body: no joint ever goes over.
#include "sinew_character/motion/joint_limits.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "expect_error.hpp"
#include "sinew_formats/base/point.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_formats/motion.hpp"
#include "temp_folder.hpp"
#include "walking_motion.hpp"

namespace sinew {
namespace {

constexpr double kDegree = 3.14159265358979323846 / 180;

// Two links with z up: the second turns about the first one's y, which is the world's -x.
constexpr const char* kRobot = R"(<?xml version="1.0"?>
<!-- <joint name="none"/> -->
<robot name="arm">
  <link name="base"/><link name="lower"><visual><origin xyz="9 9 9"/></visual></link>
  <joint name="shoulder" type="revolute">
    <parent link="base"/><child link="lower"/>
    <origin xyz="0 0 1" rpy="0 0 1.5707963267948966"/>
    <axis xyz='0 1 0'/><limit lower="-0.5" upper="1.0" effort="1"/>
  </joint>
  <joint name="elbow" type="fixed"><parent link="lower"/><child link="upper"/><origin xyz="0 2 1"/></joint>
  <transmission name="t"><joint name="shoulder"/></transmission>
</robot>)";

MapRig robot_rig() {  // y up: (x, y, z) of the URDF is (x, z, -y) here
  MapRig rig;
  rig.name = "arm.glb";
  rig.joints = {{"base", {0, 0, 0}, -1}, {"lower", {0, 1, 0}, 0}, {"upper", {-2, 2, 0}, 1}};
  return rig;
}

MotionFrame random_pose(const Motion& motion, std::mt19937* random) {
  MotionFrame frame;
  for (const MotionJoint& joint : motion.joints) {
    Quaternion q{};
    for (double& x : q) x = static_cast<double>(static_cast<int>((*random)() % 2001) - 1000);
    frame.rotations.push_back(normalized(q));
    frame.translations.push_back(joint.offset);
  }
  return frame;
}

void hold(const std::vector<sinew_joint_limit>& limits, MotionFrame* frame) {
  std::vector<float> rotations;
  for (const Quaternion& q : frame->rotations)
    for (const double x : q) rotations.push_back(static_cast<float>(x));
  const uint32_t joints = static_cast<uint32_t>(frame->rotations.size());
  ASSERT_EQ(sinew_keep_joint_limits(limits.data(), static_cast<uint32_t>(limits.size()), joints, 1, rotations.data()),
            SINEW_OK);
  for (size_t j = 0; j < joints; ++j)
    for (size_t i = 0; i < 4; ++i) frame->rotations[j][i] = static_cast<double>(rotations[4 * j + i]);
}

TEST(JointLimits, OfText) {
  const TempFolder folder;
  const MapRig rig = robot_rig();
  const std::string path = folder.write(
      "arm.limits",
      "# arm\nhinge lower 0 0 2 -10 20.5 # a hinge\n\nball upper 0 1 0  1 0 0  -5 5  -30 40  0 12\nfixed base\n");
  const std::vector<sinew_joint_limit> limits = joint_limits(path, rig, {});
  ASSERT_EQ(limits.size(), 3u);
  EXPECT_EQ(limits[0].joint, 1u);
  EXPECT_EQ(limits[0].kind, SINEW_LIMIT_HINGE);
  EXPECT_EQ(limits[0].most[0], 20.5f);
  EXPECT_EQ(limits[1].kind, SINEW_LIMIT_BALL);
  EXPECT_EQ(limits[1].side[0], 1);
  EXPECT_EQ(limits[1].least[1], -30);
  EXPECT_EQ(limits[1].most[2], 12);
  EXPECT_EQ(limits[2].least[0], limits[2].most[0]);
  EXPECT_ERROR((void)joint_limits(folder.write("a.limits", "\nhinge knee 0 0 1 0 1\n"), rig, {}), "a.limits:2",
               "a joint of arm.glb", "'knee'");
  EXPECT_ERROR((void)joint_limits(folder.write("b.limits", "hinge lower 0 0 1 5 -5\n"), rig, {}), "b.limits:1",
               "the minimum first");
  EXPECT_ERROR((void)joint_limits(folder.write("c.limits", "hinge lower 0 0 0 -5 5\n"), rig, {}), "not 0 0 0");
  EXPECT_ERROR((void)joint_limits(folder.write("d.limits", "slide lower 0 0 1 -5 5\n"), rig, {}), "'hinge JOINT");
  EXPECT_ERROR((void)joint_limits(folder.write("e.limits", "# none\n"), rig, {}), "e.limits", "found none");
}

TEST(JointLimits, ARobotStaysWithinItsUrdf) {
  const TempFolder folder;
  const MapRig rig = robot_rig();
  const std::vector<sinew_joint_limit> limits = joint_limits(folder.write("arm.urdf", kRobot), rig, {});
  ASSERT_EQ(limits.size(), 2u) << "the base has no joint";
  EXPECT_EQ(limits[0].joint, 1u);
  EXPECT_NEAR(static_cast<double>(limits[0].axis[0]), -1, 1e-6) << "y of the joint is -x of the world";
  EXPECT_NEAR(static_cast<double>(limits[0].least[0]), -0.5 / kDegree, 1e-4);
  EXPECT_NEAR(static_cast<double>(limits[0].most[0]), 1.0 / kDegree, 1e-4);
  EXPECT_EQ(limits[1].most[0], 0) << "fixed";
  const Motion motion = motion_of(rig.joints);
  std::mt19937 random(3);
  for (int i = 0; i < 500; ++i) {
    MotionFrame frame = random_pose(motion, &random);
    hold(limits, &frame);
    const Quaternion q = frame.rotations[1];
    const double angle = -2 * std::atan2(q[0], q[3]);
    EXPECT_NEAR(q[1], 0, 1e-6);
    EXPECT_NEAR(q[2], 0, 1e-6);
    EXPECT_GE(angle, -0.5001);
    EXPECT_LE(angle, 1.0001);
    EXPECT_NEAR(frame.rotations[2][3], 1, 1e-6);
  }
}

TEST(JointLimits, WrongUrdfsAreOneLine) {
  const TempFolder folder;
  const MapRig rig = robot_rig();
  const std::string text = kRobot;
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string other = text;
    other.replace(other.find(from), from.size(), to);
    return folder.write("bad.urdf", other);
  };
  EXPECT_ERROR((void)joint_limits(with("<limit lower=\"-0.5\" upper=\"1.0\" effort=\"1\"/>", ""), rig, {}),
               "bad.urdf:5", "'shoulder'");
  EXPECT_ERROR((void)joint_limits(with("lower=\"-0.5\"", "lower=\"x\""), rig, {}), "bad.urdf:8", "a number");
  EXPECT_ERROR((void)joint_limits(with("<axis xyz='0 1 0'/>", "<axis xyz='0 1"), rig, {}), "bad.urdf");
  EXPECT_ERROR((void)joint_limits(with("</joint>", "</link>"), rig, {}), "bad.urdf:9", "</joint>");
  EXPECT_ERROR((void)joint_limits(with("<transmission", "<xacro:macro"), rig, {}), "bad.urdf:11", "xacro FILE");
  EXPECT_ERROR((void)joint_limits(with("xyz=\"0 2 1\"", "xyz=\"2 2 2\""), rig, {}), "are at other positions");
  MapRig other = rig;
  for (Joint& joint : other.joints) joint.name += "_x";
  EXPECT_ERROR((void)joint_limits(folder.write("arm.urdf", text), other, {}), "none of its 2 joints");
}

TEST(JointLimits, NoKneeBendsForwardAndNoHeadTurnsRound) {
  const Motion person = walking_person();
  const MapRig rig = map_rig_of(person);
  const std::vector<sinew_joint_limit> limits = joint_limits("human", rig, {});
  EXPECT_GE(limits.size(), 10u);
  const auto number = [&](const std::string& name) {
    for (size_t j = 0; j < rig.joints.size(); ++j)
      if (rig.joints[j].name == name) return j;
    ADD_FAILURE() << name;
    return size_t{0};
  };
  std::mt19937 random(11);
  for (int i = 0; i < 500; ++i) {
    MotionFrame frame = random_pose(person, &random);
    hold(limits, &frame);
    const Point3 down = {0, -1, 0};
    const Point3 calf = rotate(frame.rotations[number("LeftLeg")], down),
                 thigh = rotate(frame.rotations[number("LeftUpLeg")], down);
    EXPECT_LT(calf[2], std::sin(12 * kDegree)) << "a knee bends back";
    EXPECT_GT(thigh[2], -std::sin(90 * kDegree));
    EXPECT_LT(std::abs(calf[0]), std::sin(25 * kDegree));
    const Point3 face = rotate(frame.rotations[number("Head")], {0, 0, 1});
    EXPECT_GT(face[2], -0.99);
    MotionFrame again = frame;
    hold(limits, &again);
    for (size_t j = 0; j < rig.joints.size(); ++j)
      EXPECT_GT(std::abs(dot(again.rotations[j], frame.rotations[j])), 1 - 1e-6);
  }
  MotionFrame walk = person.clips[0].frames[0];
  const MotionFrame before = walk;
  hold(limits, &walk);
  for (size_t j = 0; j < rig.joints.size(); ++j)
    EXPECT_GT(std::abs(dot(walk.rotations[j], before.rotations[j])), 1 - 1e-6)
        << rig.joints[j].name << ": people walk so";
  MapRig chain = robot_rig();
  EXPECT_ERROR((void)joint_limits("human", chain, {}), "arm.glb", "human limits need a human body");
}

}  // namespace
}  // namespace sinew
