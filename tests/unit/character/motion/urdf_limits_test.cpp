// SPDX-License-Identifier: MIT
// Joints of a robot's URDF of every type, its frames and names. joint_limits_test.cpp asks whether poses stay within.
#include <gtest/gtest.h>

#include <string>

#include "expect_error.hpp"
#include "sinew_character/motion/joint_limits.hpp"
#include "temp_folder.hpp"

namespace sinew {
namespace {

// A chain along the URDF's x: base, one, two, each a unit from the one before. `one` and `two` are what joints hold.
std::string chain_urdf(const std::string& one, const std::string& two) {
  return "<robot name=\"chain\">\n<joint name=\"j1\" " + one +
         "<parent link=\"base\"/><child link=\"one\"/><origin xyz=\"1 0 0\"/></joint>\n<joint name=\"j2\" " + two +
         "<parent link=\"one\"/><child link=\"two\"/><origin xyz=\"1 0 0\"/></joint>\n</robot>\n";
}

MapRig chain_rig(Vec3 step = {1, 0, 0}) {
  MapRig rig;
  rig.name = "chain.glb";
  rig.joints = {{"base", {0, 0, 0}, -1}, {"one", step, 0}, {"two", {2 * step.x, 2 * step.y, 2 * step.z}, 1}};
  return rig;
}

std::vector<sinew_joint_limit> limits_of(const std::string& text, const MapRig& rig) {
  const TempFolder folder;
  return urdf_joint_limits(folder.write("chain.urdf", text), rig);
}

void expect_axis(const sinew_joint_limit& limit, const Vec3& axis) {
  EXPECT_NEAR(limit.axis[0], axis.x, 1e-5f);
  EXPECT_NEAR(limit.axis[1], axis.y, 1e-5f);
  EXPECT_NEAR(limit.axis[2], axis.z, 1e-5f);
}

TEST(UrdfLimits, AContinuousJointTurnsAllTheWayAndAFixedOneNotAtAll) {
  const auto limits = limits_of(chain_urdf("type='continuous'>", "type='fixed'>"), chain_rig());
  ASSERT_EQ(limits.size(), 2u);
  EXPECT_EQ(limits[0].joint, 1u);
  EXPECT_EQ(limits[0].kind, SINEW_LIMIT_HINGE);
  EXPECT_EQ(limits[0].least[0], -180);
  EXPECT_EQ(limits[0].most[0], 180);
  EXPECT_EQ(limits[1].joint, 2u);
  EXPECT_EQ(limits[1].least[0], 0);
  EXPECT_EQ(limits[1].most[0], 0);
}

TEST(UrdfLimits, FreeJointsHaveNone) {
  for (const char* const free : {"type='floating'>", "type='planar'>"}) {
    const auto limits = limits_of(chain_urdf(free, "type='continuous'>"), chain_rig());
    ASSERT_EQ(limits.size(), 1u) << free;
    EXPECT_EQ(limits[0].joint, 2u);
    EXPECT_ERROR((void)limits_of(chain_urdf(free, free), chain_rig()), "chain.urdf", "found none", "chain.glb");
  }
}

TEST(UrdfLimits, RadiansBecomeDegreesOfOneTurnAtMost) {
  const auto limits = limits_of(chain_urdf("type='revolute'><limit lower='-0.7853981633974483' upper='9.5'/>",
                                           "type='revolute'><limit upper='1.5707963267948966'/>"),
                                chain_rig());
  ASSERT_EQ(limits.size(), 2u);
  EXPECT_NEAR(limits[0].least[0], -45, 1e-4f);
  EXPECT_EQ(limits[0].most[0], 180);
  EXPECT_EQ(limits[1].least[0], 0) << "an end that is not there is 0";
  EXPECT_NEAR(limits[1].most[0], 90, 1e-4f);
}

TEST(UrdfLimits, TheAxisIsXWhereNoneIsGivenAndHasLengthOne) {
  const auto limits = limits_of(chain_urdf("type='continuous'>", "type='continuous'><axis xyz='0 3 4'/>"), chain_rig());
  ASSERT_EQ(limits.size(), 2u);
  expect_axis(limits[0], {1, 0, 0});
  expect_axis(limits[1], {0, 0.6f, 0.8f});
}

// A quarter about z of the first frame turns the second joint's axis and the way to it.
TEST(UrdfLimits, FramesTurnWhatHangsOnThem) {
  const std::string text =
      "<robot name='chain'><joint name='j2' type='continuous'><parent link='one'/><child link='two'/>"
      "<origin xyz='1 0 0'/><axis xyz='1 0 0'/></joint>"
      "<joint name='j1' type='fixed'><parent link='base'/><child link='one'/>"
      "<origin xyz='1 0 0' rpy='0 0 1.5707963267948966'/></joint></robot>";  // the lower one comes first
  MapRig rig = chain_rig();
  rig.joints[2].position = {1, 1, 0};
  const auto limits = limits_of(text, rig);
  ASSERT_EQ(limits.size(), 2u);
  EXPECT_EQ(limits[0].joint, 2u) << "in the order of the file";
  expect_axis(limits[0], {0, 1, 0});
}

// The same robot in a world of y up and of another size, and one that is turned about the up axis.
TEST(UrdfLimits, TheTargetsWorldMayBeTurnedAndScaled) {
  const std::string text =
      "<robot name='chain'><joint name='j1' type='continuous'><parent link='base'/><child link='one'/>"
      "<origin xyz='1 0 0'/><axis xyz='0 0 1'/></joint>"
      "<joint name='j2' type='continuous'><parent link='one'/><child link='two'/><origin xyz='0 1 3'/></joint>"
      "<joint name='j3' type='fixed'><parent link='two'/><child link='three'/><origin xyz='1 0 0'/></joint></robot>";
  MapRig same;
  same.name = "robot.glb";
  same.joints = {{"one", {1, 0, 0}, -1}, {"two", {1, 1, 3}, 0}, {"three", {2, 1, 3}, 1}};
  expect_axis(limits_of(text, same)[0], {0, 0, 1});
  MapRig y_up = same, turned = same;
  for (Joint& joint : y_up.joints)
    joint.position = {100 * joint.position.x, 100 * joint.position.z, -100 * joint.position.y};
  const auto limits = limits_of(text, y_up);
  expect_axis(limits[0], {0, 1, 0});
  expect_axis(limits[1], {1, 0, 0});
  for (Joint& joint : turned.joints) joint.position = {-joint.position.y + 5, joint.position.x, joint.position.z};
  expect_axis(limits_of(text, turned)[0], {0, 0, 1});
  expect_axis(limits_of(text, turned)[1], {0, 1, 0});
}

TEST(UrdfLimits, AJointIsFoundByItsLinkOrByItsOwnName) {
  MapRig rig = chain_rig();
  rig.joints[1].name = "j1";
  const auto limits = limits_of(chain_urdf("type='continuous'>", "type='continuous'>"), rig);
  ASSERT_EQ(limits.size(), 2u);
  EXPECT_EQ(limits[0].joint, 1u);
  EXPECT_EQ(limits[1].joint, 2u);
  rig.joints[1].name = "another";
  const auto rest = limits_of(chain_urdf("type='continuous'>", "type='continuous'>"), rig);
  ASSERT_EQ(rest.size(), 1u) << "what the target does not have is passed over";
  EXPECT_EQ(rest[0].joint, 2u);
}

TEST(UrdfLimits, MarkupThatIsNoTagIsPassedOver) {
  const std::string plain = chain_urdf("type='continuous'>", "type='fixed'>");
  const std::string marked =
      "<?xml version='1.0'?>\n<!DOCTYPE robot>\n<!-- <joint> \n -->" +
      chain_urdf("type='continuous'><![CDATA[<limit lower='x'/>]]><!-- <axis/> -->", "type='fixed'>");
  const auto a = limits_of(plain, chain_rig()), b = limits_of(marked, chain_rig());
  ASSERT_EQ(a.size(), b.size());
  for (size_t i = 0; i < a.size(); ++i) EXPECT_EQ(a[i].most[0], b[i].most[0]);
}

TEST(UrdfLimits, LinksInACircleEnd) {
  const std::string text =
      "<robot name='chain'><joint name='j1' type='continuous'><parent link='two'/><child link='one'/></joint>"
      "<joint name='j2' type='continuous'><parent link='one'/><child link='two'/></joint></robot>";
  EXPECT_EQ(limits_of(text, chain_rig()).size(), 2u);
}

TEST(UrdfLimits, WhatIsWrongIsOneLineWithItsPosition) {
  const MapRig rig = chain_rig();
  EXPECT_ERROR((void)limits_of("<model/>", rig), "chain.urdf:1", "<robot>", "'model'");
  EXPECT_ERROR((void)limits_of("<robot name='r'>\n<joint type='fixed'/></robot>", rig), "chain.urdf:2", "name=");
  EXPECT_ERROR((void)limits_of("<robot name='r'>\n<joint name='j'/></robot>", rig), "chain.urdf:2", "type=");
  EXPECT_ERROR((void)limits_of("<robot name='r'>\n\n<!-- never ends", rig), "chain.urdf:3", "-->");
  EXPECT_ERROR((void)limits_of("<robot name='r' name>", rig), "chain.urdf:1", "NAME=\"VALUE\"");
  EXPECT_ERROR((void)limits_of(chain_urdf("type='fixed'>\n<axis xyz='1 0'/>", "type='fixed'>"), rig), "chain.urdf:3",
               "three numbers");
  EXPECT_ERROR((void)limits_of(chain_urdf("type='fixed'>\n<axis xyz='1 0 inf'/>", "type='fixed'>"), rig),
               "chain.urdf:3", "a number");
  EXPECT_ERROR((void)limits_of(chain_urdf("type='revolute'><limit lower='1' upper='-1'/>", "type='fixed'>"), rig),
               "chain.urdf:2", "'j1'", "a lower limit above the upper one");
  EXPECT_ERROR((void)limits_of("</robot>", rig), "chain.urdf:1", "no closing tag");
  EXPECT_ERROR((void)limits_of("", rig), "chain.urdf", "none of its 0 joints");
}

}  // namespace
}  // namespace sinew
