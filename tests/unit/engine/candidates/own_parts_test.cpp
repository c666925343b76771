// SPDX-License-Identifier: MIT
// Eyes and the like: leaf joints in the middle of small parts own them.
#include "candidates/own_parts.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "mesh_scene.hpp"

namespace {

using sinew::kNoJoint;
using sinew_test::add_cube;
using sinew_test::MeshRun;
using sinew_test::MeshScene;

constexpr float kEye = 0.02f;  // side of a cube for an eye

// A head of side 1 with one eye in its front; joints: root, head, eye.
MeshScene head_with_eye(float eye_side = kEye, float off = 0, float head_offset = 4) {
  MeshScene scene;
  add_cube(&scene, 0, 0, 0);
  add_cube(&scene, 0.5f, 0.5f, 0.9f, eye_side);
  const float x = 0.5f + eye_side / 2, y = x, z = 0.9f + eye_side / 2;
  scene.add_joint(0.5f, 0.1f, 0.5f, -1);
  scene.add_joint(x, y, z - head_offset * eye_side, 0);
  scene.add_joint(x + off * eye_side, y, z, 1);
  return scene;
}

struct Owned {
  std::vector<uint16_t> owners;  // of the parts, the largest first
  std::vector<uint8_t> usable;
};

Owned own(const MeshScene& scene) {
  MeshRun run(scene);
  EXPECT_EQ(run.status, SINEW_OK);
  Owned owned;
  owned.owners.resize(run.mesh.part_count);
  sinew::Workspace block(64 * 1024);
  sinew::Arena arena(block.data(), 64 * 1024);
  EXPECT_EQ(sinew::find_own_parts(run.mesh, run.counts, arena, &run.skeleton, owned.owners.data()), SINEW_OK);
  owned.usable.assign(run.skeleton.usable, run.skeleton.usable + run.skeleton.joint_count);
  return owned;
}

constexpr uint16_t kEyeJoint = 2;

bool fires(const MeshScene& scene) {
  const Owned owned = own(scene);
  EXPECT_EQ(owned.owners[0], kNoJoint);
  EXPECT_EQ(owned.owners[1] == kEyeJoint, owned.usable[kEyeJoint] == 0);
  return owned.owners[1] == kEyeJoint;
}

TEST(OwnParts, AnEyesJointOwnsTheEyeAndNothingElse) {
  const Owned owned = own(head_with_eye());
  EXPECT_EQ(owned.owners, (std::vector<uint16_t>{kNoJoint, kEyeJoint}));
  EXPECT_EQ(owned.usable, (std::vector<uint8_t>{1, 1, 0}));
}

TEST(OwnParts, ALensBeforeTheEyeIsItsToo) {
  MeshScene scene = head_with_eye();
  const uint32_t first = scene.vertex_count();
  for (int i = 0; i < 4; ++i)
    scene.add_vertex(0.505f + 0.01f * static_cast<float>(i & 1), 0.505f + 0.01f * static_cast<float>(i >> 1), 0.921f);
  scene.add_face({first, first + 1, first + 3, first + 2});
  EXPECT_EQ(own(scene).owners, (std::vector<uint16_t>{kNoJoint, kEyeJoint, kEyeJoint}));
}

TEST(OwnParts, OtherLeavesStayAsTheyAre) {
  EXPECT_TRUE(fires(head_with_eye(0.03f)));
  EXPECT_FALSE(fires(head_with_eye(0.04f)));        // too large
  EXPECT_TRUE(fires(head_with_eye(kEye, 0.29f)));   // at the back of half a ball
  EXPECT_FALSE(fires(head_with_eye(kEye, 0.32f)));  // beside it
  EXPECT_FALSE(fires(head_with_eye(kEye, 0, 1.9f)));
  EXPECT_TRUE(fires(head_with_eye(kEye, 0, 2.1f)));
  EXPECT_TRUE(fires(head_with_eye(kEye, 0, 5.9f)));
  EXPECT_FALSE(fires(head_with_eye(kEye, 0, 6.2f)));  // a hinge far from its parent
}

TEST(OwnParts, JointsThatShareAPartOwnNothing) {
  MeshScene scene = head_with_eye();
  scene.add_joint(0.51f, 0.515f, 0.91f, 1);  // an eyelid's
  EXPECT_FALSE(fires(scene));
  scene = head_with_eye();
  scene.add_joint(0.51f, 0.51f, 0.93f, 2);  // the eye is no leaf
  EXPECT_FALSE(fires(scene));
}

TEST(OwnParts, WhatMayNotDeformOwnsNothing) {
  MeshScene scene = head_with_eye();
  scene.flags = {0, 0, SINEW_JOINT_NEVER};
  EXPECT_EQ(own(scene).owners[1], kNoJoint);
  scene.flags = {0, SINEW_JOINT_NEVER, 0};  // it would be the only one, or its parent's weight would have nowhere to go
  EXPECT_EQ(own(scene).owners[1], kNoJoint);
}

TEST(OwnParts, AStrandIsNoEye) {
  MeshScene scene = head_with_eye();
  for (uint32_t v = 8; v < 16; ++v) scene.positions[3 * v] = 0.51f + (scene.positions[3 * v] - 0.51f) * 0.35f;
  EXPECT_FALSE(fires(scene));
}

}  // namespace
