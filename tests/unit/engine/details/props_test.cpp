// SPDX-License-Identifier: MIT
// sinew_rig_details() of props: joints of what a hand holds, and nothing where it holds nothing.
#include <gtest/gtest.h>

#include <cstdint>
#include <string>

#include "ball_scene.hpp"

namespace sinew::rigging {
namespace {

using sinew_test::add_ball;
using sinew_test::MeshScene;
using sinew_test::RigSkeleton;

// An arm of one part along x from 0.2: the wrist is at 0.6, the hand ends at 0.72.
MeshScene arm() {
  MeshScene scene;
  add_ball(&scene, {0.46f, 1.4f, 0}, {0.26f, 0.04f, 0.04f});
  return scene;
}

struct ArmSkeleton : RigSkeleton {
  ArmSkeleton() {
    add("Hips", 0, 1, 0, -1, SINEW_CLASS_PELVIS, 0, -1);
    add("LeftForeArm", 0.35f, 1.4f, 0, 0, SINEW_CLASS_FOREARM, 0, -1);
    add("LeftHand", 0.6f, 1.4f, 0, 1, SINEW_CLASS_HAND, 0, -1);
    add("LeftHand_end", 0.72f, 1.4f, 0, 2, SINEW_CLASS_HAND, SINEW_JOINT_NEVER, -1);
  }
};

sinew_status add_props(const MeshScene& scene, RigSkeleton* skeleton,
                       sinew_rig_options options = SINEW_INIT(sinew_rig_options), size_t missing = 0) {
  return add_details(scene, SINEW_DETAIL_PROPS, skeleton, options, missing);
}

TEST(PropsOfASkeleton, AreJointsOfWhatAHandHolds) {
  MeshScene scene = arm();
  add_ball(&scene, {0.66f, 1.4f, 0.15f}, {0.012f, 0.012f, 0.2f});  // a stick
  add_ball(&scene, {0.66f, 1.4f, 0.4f}, {0.03f, 0.005f, 0.1f});    // and its blade, too far away for itself
  ArmSkeleton s;
  ASSERT_EQ(add_props(scene, &s), SINEW_OK);
  ASSERT_EQ(s.outputs.joint_count, 6u);
  EXPECT_EQ(s.name(4), "LeftHandProp");
  EXPECT_EQ(s.name(5), "LeftHandProp_end");
  EXPECT_EQ(s.parents[4], 2);
  EXPECT_EQ(s.parents[5], 4);
  EXPECT_EQ(s.flags[4], 0);
  EXPECT_EQ(s.flags[5], SINEW_JOINT_NEVER);
  EXPECT_EQ(s.classes[5], SINEW_CLASS_PROP);
  EXPECT_EQ(s.partners[4], -1);
  EXPECT_NEAR(s.positions[12], 0.66f, 0.02f);
  EXPECT_NEAR(s.positions[14], 0, 0.06f) << "where the hand grips it";
  EXPECT_NEAR(s.positions[17], 0.35f, 0.01f) << "where it ends";
  ASSERT_EQ(add_props(scene, &s), SINEW_OK);
  EXPECT_EQ(s.outputs.joint_count, 6u) << "once";
}

TEST(PropsOfASkeleton, AreNoSleevesGlovesOrFingers) {
  const ArmSkeleton before;
  const auto expect_none = [&](const char* what, const MeshScene& scene) {
    ArmSkeleton s;
    ASSERT_EQ(add_props(scene, &s), SINEW_OK) << what;
    EXPECT_TRUE(s.same_as(before)) << what;
  };
  MeshScene bare = arm(), sleeve = arm(), glove = arm(), belt = arm(), fingers = arm(), claw;
  expect_none("bare", bare);
  add_ball(&sleeve, {0.45f, 1.4f, 0}, {0.27f, 0.06f, 0.06f});
  expect_none("sleeve", sleeve);
  add_ball(&glove, {0.66f, 1.4f, 0}, {0.07f, 0.05f, 0.05f});
  expect_none("glove", glove);
  add_ball(&belt, {0, 1, 0}, {0.2f, 0.02f, 0.2f});
  expect_none("belt", belt);
  for (int f = 0; f < 4; ++f)
    add_ball(&fingers, {0.8f, 1.4f, 0.03f * static_cast<float>(f) - 0.045f}, {0.15f, 0.01f, 0.01f});
  expect_none("fingers", fingers);
  add_ball(&claw, {0.3f, 1.4f, 0}, {0.25f, 0.04f, 0.04f});  // ends before the wrist: the other part is the hand
  add_ball(&claw, {0.75f, 1.4f, 0}, {0.14f, 0.03f, 0.03f});
  expect_none("a hand that is a part itself", claw);
}

TEST(PropsOfASkeleton, WhatIsWrongIsSaidAndNothingWritten) {
  MeshScene scene = arm();
  add_ball(&scene, {0.66f, 1.4f, 0.15f}, {0.012f, 0.012f, 0.2f});
  const ArmSkeleton before;
  ArmSkeleton s;
  EXPECT_EQ(add_props(scene, &s, SINEW_INIT(sinew_rig_options), SIZE_MAX), SINEW_ERROR_WORKSPACE);
  sinew_rig_options options = SINEW_INIT(sinew_rig_options);
  options.progress = [](void*, uint32_t) { return 1; };
  EXPECT_EQ(add_props(scene, &s, options), SINEW_ERROR_CANCELLED);
  EXPECT_TRUE(s.same_as(before));
  s.outputs.joint_count = SINEW_MAX_RIG_JOINTS + 1;
  EXPECT_EQ(add_props(scene, &s), SINEW_ERROR_COUNT);
}

}  // namespace
}  // namespace sinew::rigging
