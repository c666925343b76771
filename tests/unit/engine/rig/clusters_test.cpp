// SPDX-License-Identifier: MIT
// Folded joints from votes: one for every position that a class gathers at, none twice, and those that no class explains.
#include "rig/clusters.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "rig_votes.hpp"

namespace sinew::rigging {
namespace {

using sinew_test::Block;
using sinew_test::grid_point;
using sinew_test::units;
using sinew_test::VoteScene;

std::vector<FoldedJoint> joints_of(const VoteScene& scene) {
  const Votes votes = scene.votes();
  std::vector<FoldedJoint> joints(kMaxFoldedJoints);
  uint32_t count = 0;
  const auto find = [&](Arena& arena) {
    VotePool pool;
    if (!pool.build(votes, votes.folded, arena)) return SINEW_ERROR_WORKSPACE;
    return find_folded_joints(pool, arena, joints.data(), &count);
  };
  Arena measuring;
  EXPECT_EQ(find(measuring), SINEW_OK);
  Block block(measuring.high_water());
  EXPECT_EQ(find(block.arena), SINEW_OK);
  joints.resize(count);
  return joints;
}

// `count` points that own themselves: start and end at one position, give or take 0.003.
void gather(VoteScene* scene, Vec3i at, uint32_t joint_class, uint32_t count, double share = 0.9) {
  test::Random random(joint_class + 100 * count);
  for (uint32_t i = 0; i < count; ++i) {
    const Vec3i off = {random.between(-3000, 3000), random.between(-3000, 3000), random.between(-3000, 3000)};
    scene->add(at + off, joint_class, at + off, joint_class, 0.02, share);
  }
}

TEST(FoldedJoints, OneForEveryGatheringByFallingMass) {
  VoteScene scene;
  gather(&scene, grid_point(0, 0.5, 0), kClassPelvis, 100);
  gather(&scene, grid_point(0.1, 0.4, 0), kClassThigh, 90);
  gather(&scene, grid_point(0, 0.6, 0), kClassSpine, 80);
  gather(&scene, grid_point(0, 0.7, 0), kClassSpine, 70);
  const std::vector<FoldedJoint> joints = joints_of(scene);
  ASSERT_EQ(joints.size(), 4u);
  const FoldedJoint wanted[] = {{grid_point(0, 0.5, 0), kClassPelvis, 0},
                                {grid_point(0.1, 0.4, 0), kClassThigh, 0},
                                {grid_point(0, 0.6, 0), kClassSpine, 0},
                                {grid_point(0, 0.7, 0), kClassSpine, 0}};
  for (size_t j = 0; j < 4; ++j) {
    EXPECT_EQ(joints[j].joint_class, wanted[j].joint_class);
    EXPECT_LT(square_distance(joints[j].at, wanted[j].at), square(units(0.002))) << j;
    if (j > 0) {
      EXPECT_LT(joints[j].mass, joints[j - 1].mass);
    }
  }
}

TEST(FoldedJoints, VotesOfBothSidesAreOne) {
  VoteScene scene;
  gather(&scene, grid_point(0.2, 0.5, 0), kClassHand, 50);
  gather(&scene, grid_point(-0.2, 0.5, 0), kClassHand, 50);
  const std::vector<FoldedJoint> folded = joints_of(scene);
  ASSERT_EQ(folded.size(), 1u);
  EXPECT_GT(folded[0].at.x, 0);
  scene.folded = false;
  EXPECT_EQ(joints_of(scene).size(), 2u);
}

TEST(FoldedJoints, NearThePlaneMeansOnItUnlessTheClassComesInPairs) {
  VoteScene scene;
  gather(&scene, grid_point(0.012, 0.9, 0), kClassHead, 50);
  gather(&scene, grid_point(0.012, 0.7, 0), kClassClavicle, 50);
  gather(&scene, grid_point(0.003, 0.2, 0), kClassThigh, 50);
  std::vector<FoldedJoint> joints = joints_of(scene);
  ASSERT_EQ(joints.size(), 3u);
  for (const FoldedJoint& joint : joints) {
    EXPECT_EQ(joint.at.x == 0, joint.joint_class != kClassClavicle) << int{joint.joint_class};
  }
  scene.folded = false;
  for (const FoldedJoint& joint : joints_of(scene)) EXPECT_NE(joint.at.x, 0);
}

TEST(FoldedJoints, DuplicatesGo) {
  VoteScene scene;
  gather(&scene, grid_point(0.2, 0.5, 0), kClassHand, 50);
  gather(&scene, grid_point(0.21, 0.51, 0), kClassFoot, 40);  // another class, closer than 0.022
  gather(&scene, grid_point(0.5, 0.5, 0), kClassHand, 12);    // the same class, below 0.35 of the heaviest
  uint32_t hands = 0;
  for (const FoldedJoint& joint : joints_of(scene)) {
    EXPECT_NE(joint.joint_class, kClassFoot);
    hands += joint.joint_class == kClassHand ? 1 : 0;
  }
  EXPECT_EQ(hands, 2u);  // the light one comes back: no joint explains its votes
}

TEST(FoldedJoints, ChainsStandCloserThanOtherClasses) {
  for (const uint32_t joint_class : {kClassTail, kClassHand}) {
    VoteScene scene;  // two modes, 0.046 apart: the kernel draws them together
    gather(&scene, grid_point(0.2, 0.5, 0), joint_class, 50);
    gather(&scene, grid_point(0.2, 0.563, 0), joint_class, 48);
    EXPECT_EQ(joints_of(scene).size(), joint_class == kClassTail ? 2u : 1u) << joint_class;
  }
}

TEST(FoldedJoints, WhatNoClassExplainsIsAJointOfMostOfIt) {
  VoteScene scene;
  gather(&scene, grid_point(0, 0.5, 0), kClassPelvis, 100);
  // A tenth for every class: no class has votes, but the position has.
  gather(&scene, grid_point(0, 0.9, 0), kClassTail, 40, 0.06);
  const std::vector<FoldedJoint> joints = joints_of(scene);
  ASSERT_EQ(joints.size(), 2u);
  EXPECT_EQ(joints[1].joint_class, kClassTail);
  EXPECT_LT(square_distance(joints[1].at, grid_point(0, 0.9, 0)), square(units(0.004)));
}

TEST(FoldedJoints, NoneOfTooFewVotesNoneBeyondTheLimit) {
  VoteScene scene;
  EXPECT_TRUE(joints_of(scene).empty());
  for (uint32_t i = 0; i < 80; ++i) {
    const double x = 0.1 * (i % 4) + 0.06, y = 0.1 * (i / 4 % 5) + 0.06, z = 0.2 * (i / 20) + 0.06;
    gather(&scene, grid_point(x, y, z), i % 2 == 0 ? kClassTail : kClassHair, 20);
  }
  const std::vector<FoldedJoint> joints = joints_of(scene);
  EXPECT_EQ(joints.size(), kMaxFoldedJoints);
  for (size_t a = 0; a < joints.size(); ++a) {
    for (size_t b = 0; b < a; ++b) EXPECT_GE(square_distance(joints[a].at, joints[b].at), square(units(0.022)));
  }
}

TEST(FoldedJoints, TrustFallsWithSpread) {
  EXPECT_NEAR(trust_in(1), 32768, 30);
  EXPECT_NEAR(trust_in(3277), 8192, 3);  // a quarter at 0.05
  for (uint32_t spread = 1; spread < 65535; ++spread) ASSERT_GE(trust_in(spread), trust_in(spread + 1));
  EXPECT_NEAR(trust_in(65535), 74, 1);  // 1 / 21^2
}

}  // namespace
}  // namespace sinew::rigging
