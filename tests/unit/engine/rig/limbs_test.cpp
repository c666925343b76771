// SPDX-License-Identifier: MIT
// Limbs: chains of their own on one side, of one kind.
#include "rig/limbs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "rig_votes.hpp"

namespace sinew::rigging {
namespace {

using sinew_test::FoundRig;
using sinew_test::grid_point;
using sinew_test::KnownJoint;
using sinew_test::units;
using sinew_test::votes_for;
using sinew_test::VoteScene;

// Both sides as they stand, nothing is mirrored: `joints` says where each joint is.
VoteScene standing(const std::vector<KnownJoint>& joints, uint32_t each) {
  VoteScene scene;
  test::Random random(3);
  for (const KnownJoint& end : joints) {
    if (end.parent < 0) continue;
    const KnownJoint& start = joints[static_cast<size_t>(end.parent)];
    const auto vote = [&](const KnownJoint& j) {
      return grid_point(j.x + 0.003 * random.normal(), j.y + 0.003 * random.normal(), j.z + 0.003 * random.normal());
    };
    for (uint32_t i = 0; i < each; ++i) {
      const Vec3i from = vote(start);
      scene.add(from, start.joint_class, vote(end), end.joint_class);
    }
  }
  scene.folded = false;
  return scene;
}

// A walker whose left foot is under its right knee: {pelvis, spine, left leg 2 to 4, right leg 5 to 7}.
std::vector<KnownJoint> walker() {
  return {{0, .6, 0, kClassPelvis, -1},   {0, .8, 0, kClassSpine, 0},      {.04, .55, 0, kClassThigh, 0},
          {.04, .3, .1, kClassCalf, 2},   {.03, .05, -.08, kClassFoot, 3}, {-.04, .55, 0, kClassThigh, 0},
          {-.04, .3, -.1, kClassCalf, 5}, {-.03, .05, .08, kClassFoot, 6}};
}

TEST(Limbs, NoneCrossesToTheOtherSide) {
  VoteScene scene = standing(walker(), 60);
  const auto joints = walker();
  for (uint32_t i = 0; i < 90; ++i) {  // votes say that each foot hangs on the other knee
    for (const auto& [knee, foot] : {std::pair(3, 7), std::pair(6, 4)}) {
      const KnownJoint &a = joints[static_cast<size_t>(knee)], &b = joints[static_cast<size_t>(foot)];
      scene.add(grid_point(a.x, a.y, a.z), kClassCalf, grid_point(b.x, b.y, b.z), kClassFoot);
    }
  }
  const FoundRig found(scene);
  size_t limbs = 0;
  for (const RigJoint& joint : found.joints) {
    if (joint.parent < 0 || joint.tip != 0 || !is_paired_class(joint.joint_class)) continue;
    const RigJoint& parent = found.joints[static_cast<size_t>(joint.parent)];
    EXPECT_EQ(joint.side, joint.position.x > 0 ? 1 : -1);
    if (!is_paired_class(parent.joint_class)) continue;
    ++limbs;
    EXPECT_EQ(joint.position.x > 0, parent.position.x > 0) << joint.position.y;
  }
  EXPECT_EQ(limbs, 4u);
}

TEST(Limbs, AJointNearThePlaneIsOnTheSideOfItsLimb) {
  std::vector<KnownJoint> joints = walker();
  joints[4].x = -0.004;
  const FoundRig found(standing(joints, 60));
  int feet = 0;
  for (const RigJoint& joint : found.joints) {
    if (joint.joint_class != kClassFoot || joint.position.z > 0) continue;
    ++feet;
    EXPECT_LT(joint.position.x, 0);
    EXPECT_EQ(joint.side, 1);
  }
  EXPECT_EQ(feet, 1);
}

// Pelvis, chest, a clavicle that both arms fork from, left arm 3 to 5, right arm 6 to 8; `beside` is where the trunk stands.
std::vector<KnownJoint> one_clavicle(double beside) {
  return {{beside, .5, 0, kClassPelvis, -1},        {beside, .8, 0, kClassSpine, 0},
          {beside + .02, .8, 0, kClassClavicle, 1}, {beside + .1, .78, 0, kClassUpperArm, 2},
          {beside + .2, .75, 0, kClassForearm, 3},  {beside + .3, .75, 0, kClassHand, 4},
          {beside - .1, .78, 0, kClassUpperArm, 2}, {beside - .2, .75, 0, kClassForearm, 6},
          {beside - .3, .75, 0, kClassHand, 7}};
}

TEST(Limbs, OfTwoArmsThatForkOneHangsOnTheTrunk) {
  const FoundRig found(standing(one_clavicle(0), 60));
  int arms = 0;
  for (const RigJoint& joint : found.joints) {
    if (joint.joint_class != kClassUpperArm) continue;
    ++arms;
    EXPECT_EQ(joint.side, joint.position.x > 0 ? 1 : -1);
    const uint8_t above = found.joints[static_cast<size_t>(joint.parent)].joint_class;
    EXPECT_EQ(above == kClassClavicle, joint.position.x > 0);
    EXPECT_TRUE(above == kClassClavicle || !is_paired_class(above));
  }
  EXPECT_EQ(arms, 2);
}

TEST(Limbs, OneOfTwoArmsIsLeftWhereverTheTrunkStands) {
  const FoundRig found(standing(one_clavicle(-.36), 60));
  int sides = 0, hands = 0;
  for (const RigJoint& joint : found.joints) {
    if (joint.joint_class != kClassHand) continue;
    ++hands;
    sides += joint.side;
    EXPECT_LT(joint.position.x, 0);
  }
  EXPECT_EQ(hands, 2);
  EXPECT_EQ(sides, 0);
}

TEST(Limbs, AFootAtTheEndOfAnArmIsAHand) {
  std::vector<KnownJoint> joints = {{0, .5, 0, kClassPelvis, -1},      {0, .5, .4, kClassSpine, 0},
                                    {.08, .45, .4, kClassUpperArm, 1}, {.08, .25, .4, kClassForearm, 2},
                                    {.08, .05, .4, kClassFoot, 3},     {.08, .45, 0, kClassThigh, 0},
                                    {.08, .25, 0, kClassCalf, 5},      {.08, .05, 0, kClassFoot, 6}};
  const FoundRig found(votes_for(joints, 60, 0.003, 1));
  EXPECT_EQ(found.count_of(kClassHand), 2u);
  EXPECT_EQ(found.count_of(kClassFoot), 2u);
  joints[2].joint_class = joints[3].joint_class = joints[4].joint_class = kClassEar;
  joints[4].joint_class = kClassHair;
  const FoundRig eared(votes_for(joints, 60, 0.003, 1));
  EXPECT_EQ(eared.count_of(kClassHair), 0u) << "most of it is an ear";
  EXPECT_EQ(eared.count_of(kClassEar), 6u);
}

TEST(Limbs, ASecondArmIsALimbOfItsOwn) {
  const std::vector<KnownJoint> joints = {{0, .5, 0, kClassPelvis, -1},   {0, .7, 0, kClassSpine, 0},
                                          {.1, .7, 0, kClassUpperArm, 1}, {.25, .7, 0, kClassForearm, 2},
                                          {.4, .7, 0, kClassHand, 3},     {.15, .85, 0, kClassUpperArm, 1},
                                          {.3, .95, 0, kClassForearm, 5}};
  VoteScene scene = votes_for(joints, 60, 0.003, 1);
  for (uint32_t i = 0; i < 150; ++i)
    scene.add(grid_point(.1, .7, 0), kClassUpperArm, grid_point(.15, .85, 0), kClassUpperArm);
  const FoundRig found(scene);
  size_t arms = 0;
  for (const RigJoint& joint : found.joints) {
    if (joint.joint_class != kClassUpperArm || joint.tip != 0) continue;
    ++arms;
    EXPECT_EQ(found.joints[static_cast<size_t>(joint.parent)].joint_class, kClassSpine) << joint.position.y;
  }
  EXPECT_EQ(arms, 4u);
}

// Pelvis, chest, head, on either side an arm of four joints and at `beside` the head a limb of two.
std::vector<KnownJoint> toy(double up) {
  return {{0, .3, 0, kClassPelvis, -1},    {0, .5, 0, kClassSpine, 0},      {0, .7, 0, kClassHead, 1},
          {.1, .48, 0, kClassUpperArm, 1}, {.2, .42, 0, kClassForearm, 3},  {.28, .38, 0, kClassHand, 4},
          {.2, up, 0, kClassUpperArm, 2},  {.3, up + .02, 0, kClassHand, 6}};
}

TEST(Limbs, AnArmAboveTheHeadThatItHangsOnIsAnEar) {
  const FoundRig eared(votes_for(toy(.75), 60, 0.003, 1));
  EXPECT_EQ(eared.count_of(kClassEar), 4u);
  EXPECT_EQ(eared.count_of(kClassHand), 2u) << "arms of the chest are arms";
  const FoundRig four_armed(votes_for(toy(.65), 60, 0.003, 1));
  EXPECT_EQ(four_armed.count_of(kClassEar), 0u) << "a trunk that is taken for a head";
  EXPECT_EQ(four_armed.count_of(kClassHand), 4u);
}

TEST(Limbs, WhatForksFromAnArmAboveTheHeadIsAnEar) {
  const auto forked = [](double up) {
    std::vector<KnownJoint> joints = toy(up);
    joints[6].joint_class = kClassForearm;
    joints[6].parent = 3;
    return votes_for(joints, 60, 0.003, 1);
  };
  const FoundRig eared(forked(.75));
  EXPECT_EQ(eared.count_of(kClassEar), 4u);
  EXPECT_EQ(eared.count_of(kClassHand), 2u);
  for (const RigJoint& joint : eared.joints) {
    if (joint.joint_class != kClassEar || joint.tip != 0) continue;
    const uint8_t above = eared.joints[static_cast<size_t>(joint.parent)].joint_class;
    EXPECT_TRUE(above == kClassHead || above == kClassEar) << "hangs on class " << unsigned{above};
  }
  const FoundRig below(forked(.6));
  EXPECT_EQ(below.count_of(kClassEar), 0u);
  EXPECT_EQ(below.count_of(kClassHand), 4u);
}

// One arm hangs down, the other is raised: in a mirrored tree both are there once.
TEST(Limbs, WhatIsOnOneSideOnlyHasNoImage) {
  const std::vector<KnownJoint> joints = {{0, .4, 0, kClassPelvis, -1},   {0, .6, 0, kClassSpine, 0},
                                          {.1, .6, 0, kClassUpperArm, 1}, {.25, .45, 0, kClassForearm, 2},
                                          {.3, .3, 0, kClassHand, 3},     {.25, .75, 0, kClassForearm, 2},
                                          {.3, .9, 0, kClassHand, 5}};
  VoteScene scene = votes_for(joints, 60, 0.003, 1);
  EXPECT_EQ(FoundRig(scene).count_of(kClassHand), 4u) << "where nobody knows the sides of points";
  for (size_t p = 0; p < scene.starts.size(); ++p) {
    const double y = .5 * (scene.starts[p].y + scene.ends[p].y) / kSide;
    const bool arm = scene.ends[p].x > units(.2) || scene.ends[p].x < units(-.2);
    const double side = !arm ? (p % 2 == 0 ? 1 : -1) : y > .6 ? -1 : 1;
    scene.starts[p].x = std::abs(scene.starts[p].x);  // folded, as a network's are
    scene.ends[p].x = std::abs(scene.ends[p].x);
    scene.inside.push_back(grid_point(.2 * side, y, 0));
  }
  const FoundRig found(scene);
  EXPECT_EQ(found.count_of(kClassHand), 2u);
  EXPECT_EQ(found.count_of(kClassForearm), 2u);
  for (const RigJoint& joint : found.joints) {
    if (joint.joint_class != kClassHand) continue;
    EXPECT_EQ(joint.position.x > 0, joint.position.y < units(.6)) << "the left one hangs";
    EXPECT_EQ(joint.partner, -1);
  }
}

TEST(Limbs, WhichClassesAreWhichLimb) {
  EXPECT_EQ(limb_of(kClassClavicle), LimbClass::kArm);
  EXPECT_EQ(limb_of(kClassToe), LimbClass::kLeg);
  EXPECT_EQ(limb_of(kClassWing), LimbClass::kNone) << "a wing begins as an arm";
  EXPECT_EQ(limb_of(kClassSpine), LimbClass::kNone);
  EXPECT_TRUE(continues_limb(kClassCalf, kClassFoot));
  EXPECT_TRUE(continues_limb(kClassThigh, kClassThigh)) << "a leg of more joints";
  EXPECT_FALSE(continues_limb(kClassFoot, kClassToe)) << "a foot has many toes";
  EXPECT_FALSE(continues_limb(kClassForearm, kClassFoot));
  EXPECT_TRUE(leaves_limb(kClassTail, kClassFoot));
  EXPECT_TRUE(leaves_limb(kClassForearm, kClassEar));
  EXPECT_FALSE(leaves_limb(kClassEar, kClassEar));
  EXPECT_FALSE(leaves_limb(kClassPelvis, kClassFoot));
  EXPECT_FALSE(leaves_limb(kClassForearm, kClassFoot)) << "spiders' legs are of both kinds";
}

// A trunk along z with two pairs of limbs that both vote for legs, as of a dog that is taken for something else.
std::vector<KnownJoint> four_legs() {
  return {{0, .5, 0, kClassPelvis, -1},  {0, .5, .4, kClassSpine, 0},   {.08, .45, .4, kClassThigh, 1},
          {.08, .25, .4, kClassCalf, 2}, {.08, .05, .4, kClassFoot, 3}, {.08, .45, 0, kClassThigh, 0},
          {.08, .25, 0, kClassCalf, 5},  {.08, .05, 0, kClassFoot, 6}};
}

TEST(Limbs, TheFrontPairOfFourLegsAreArms) {
  for (const BodyKind kind : {BodyKind::kAny, BodyKind::kQuadruped}) {
    RigOptions options;
    options.kind = kind;
    for (const bool folded : {true, false}) {
      VoteScene scene = votes_for(four_legs(), 60, 0.003, 1);
      scene.folded = folded;
      const FoundRig found(scene, options);
      EXPECT_EQ(found.count_of(kClassFoot), 2u);
      EXPECT_EQ(found.count_of(kClassHand), 2u);
      EXPECT_EQ(found.count_of(kClassUpperArm), 2u);
      for (const RigJoint& joint : found.joints) EXPECT_TRUE(joint.joint_class != kClassHand || joint.position.z > 0);
    }
  }
}

TEST(Limbs, FourLegsOfWhatIsNoQuadrupedStayLegs) {
  std::vector<KnownJoint> joints = four_legs();
  joints[2].parent = 0;
  EXPECT_EQ(FoundRig(votes_for(joints, 60, 0.003, 1)).count_of(kClassFoot), 4u) << "both on the pelvis";
  joints = four_legs();
  joints[1].joint_class = kClassHead;
  EXPECT_EQ(FoundRig(votes_for(joints, 60, 0.003, 1)).count_of(kClassFoot), 4u) << "on a head, as of a spider";
  joints = four_legs();
  joints.push_back({.2, .45, .2, kClassThigh, 0});
  joints.push_back({.3, .05, .2, kClassFoot, 8});
  EXPECT_EQ(FoundRig(votes_for(joints, 60, 0.003, 1)).count_of(kClassFoot), 6u) << "six legs";
}

TEST(Limbs, TheLowestPairOfABipedAreLegs) {
  std::vector<KnownJoint> joints = {{0, .5, 0, kClassPelvis, -1},    {0, .8, 0, kClassSpine, 0},
                                    {.1, .8, 0, kClassThigh, 1},     {.25, .75, 0, kClassCalf, 2},
                                    {.4, .7, 0, kClassFoot, 3},      {.08, .45, 0, kClassUpperArm, 0},
                                    {.08, .25, 0, kClassForearm, 5}, {.08, .05, 0, kClassHand, 6}};
  RigOptions options;
  options.kind = BodyKind::kBiped;
  const FoundRig found(votes_for(joints, 60, 0.003, 1), options);
  for (const RigJoint& joint : found.joints) {
    EXPECT_TRUE(joint.joint_class != kClassHand || joint.position.y > side_share(6000));
    EXPECT_TRUE(joint.joint_class != kClassFoot || joint.position.y < side_share(1000));
  }
  EXPECT_EQ(found.count_of(kClassHand), 2u);
  EXPECT_EQ(found.count_of(kClassFoot), 2u);
}

TEST(Limbs, OnePairAloneIsWhatItsVotesSay) {
  std::vector<KnownJoint> joints = four_legs();
  joints.resize(5);
  RigOptions options;
  options.kind = BodyKind::kQuadruped;
  EXPECT_EQ(FoundRig(votes_for(joints, 60, 0.003, 1), options).count_of(kClassFoot), 2u);
}

}  // namespace
}  // namespace sinew::rigging
