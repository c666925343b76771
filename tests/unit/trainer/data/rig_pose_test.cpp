// SPDX-License-Identifier: MIT
// Poses that skeletons are learned from: mirrored where they say so, arms and legs as they are told to be.
#include "data/rig_pose.hpp"

#include <gtest/gtest.h>

namespace sinew {
namespace {

using namespace rigging;

using Eigen::Vector3d;

// Arms to the side, legs down; with `four`, arms that reach the floor.
PoseBody body(bool four) {
  PoseBody body;
  const auto add = [&](JointClass c, int parent, const Vector3d& p) {
    TargetJoint joint;
    joint.joint_class = c;
    joint.parent = parent;
    body.target.joints.push_back(joint);
    body.joints.push_back({p.x(), p.y(), p.z()});
    return static_cast<int>(body.joints.size()) - 1;
  };
  const int hips = add(kClassPelvis, -1, {0, 0.5, 0}), chest = add(kClassSpine, hips, {0, 0.7, 0});
  add(kClassHead, chest, {0, 0.9, 0});
  for (const double side : {1.0, -1.0}) {
    const int arm = add(kClassUpperArm, chest, {0.1 * side, 0.7, 0});
    const int elbow = add(kClassForearm, arm, four ? Vector3d(0.1 * side, 0.3, 0) : Vector3d(0.3 * side, 0.7, 0));
    add(kClassHand, elbow, four ? Vector3d(0.1 * side, 0.02, 0) : Vector3d(0.5 * side, 0.7, 0));
    const int leg = add(kClassThigh, hips, {0.1 * side, 0.5, 0}), knee = add(kClassCalf, leg, {0.1 * side, 0.25, 0});
    add(kClassFoot, knee, {0.1 * side, 0.02, 0});
  }
  const size_t count = body.joints.size();
  body.kids.resize(count);
  body.partner = {0, 1, 2};
  for (size_t i = 3; i < count; ++i) body.partner.push_back(static_cast<int>(i < 9 ? i + 6 : i - 6));
  for (uint32_t i = 1; i < count; ++i) body.kids[static_cast<size_t>(body.target.joints[i].parent)].push_back(i);
  return body;
}

bool mirrored(const PoseBody& body, const RigPose& pose) {
  for (size_t i = 0; i < body.bones(); ++i) {
    const size_t p = static_cast<size_t>(body.partner[i]);
    if ((pose.turn[i] - pose.turn[p].cwiseProduct(Vector3d(1, -1, -1))).norm() > 1e-12) return false;
    if ((pose.aim[i] - pose.aim[p].cwiseProduct(Vector3d(-1, 1, 1))).norm() > 1e-12) return false;
    if (pose.stretch[i] != pose.stretch[p]) return false;
  }
  return true;
}

TEST(RigPose, SymmetricOnesAreTheirOwnMirrorImage) {
  for (const bool four : {false, true}) {
    const PoseBody b = body(four);
    int symmetric[2] = {}, odd = 0;
    for (uint64_t seed = 0; seed < 200; ++seed) {
      Random first(seed), second(seed);
      const RigPose mild = mild_pose(b, 1, &first), wide = wide_pose(b, 1, &second);
      EXPECT_TRUE(!mild.symmetric || mirrored(b, mild)) << seed;
      EXPECT_TRUE(!wide.symmetric || mirrored(b, wide)) << seed;
      symmetric[0] += mild.symmetric ? 1 : 0;
      symmetric[1] += wide.symmetric ? 1 : 0;
      odd += wide.symmetric || mirrored(b, wide) ? 0 : 1;
    }
    EXPECT_NEAR(symmetric[0], 140, 20);
    EXPECT_NEAR(symmetric[1], 50, 20);
    EXPECT_EQ(odd, 200 - symmetric[1]);
  }
}

TEST(RigPose, ArmsThatStandOutHangDownOrAreHeld) {
  const PoseBody person = body(false);
  int lowered = 0, held = 0;
  for (uint64_t seed = 0; seed < 400; ++seed) {
    Random random(seed);
    const RigPose pose = wide_pose(person, 1, &random);
    const bool holds = pose.aim[4].norm() > 0;  // a forearm
    held += holds ? 1 : 0;
    for (size_t i = 0; i < person.bones(); ++i) {
      if (pose.aim[i].norm() == 0) continue;
      const JointClass c = person.target.joints[i].joint_class;
      EXPECT_TRUE(c == kClassUpperArm || (holds && c == kClassForearm));
      if (holds) continue;
      EXPECT_TRUE(pose.aim[i].y() == -1 && pose.aim[i].x() * person.joints[i][0] >= 0) << seed;
      ++lowered;
    }
    if (!holds) continue;
    EXPECT_GT(pose.aim[3].x(), -0.5) << "upper arms stay on their side";
    EXPECT_LT(pose.aim[4].x(), 0.3) << "forearms come back to the body";
  }
  EXPECT_NEAR(lowered, 280, 60);
  EXPECT_NEAR(held, 48, 20);
}

TEST(RigPose, AnimalsSitAndLie) {
  const PoseBody animal = body(true);
  int sitting = 0, lying = 0;
  for (uint64_t seed = 0; seed < 400; ++seed) {
    Random random(seed);
    const RigPose pose = wide_pose(animal, 1, &random);
    if (pose.aim[7].norm() == 0) continue;  // a calf
    EXPECT_LT(pose.aim[7].z(), 0) << "knees are in front";
    EXPECT_GT(pose.aim[6].z(), 0);
    (pose.turn[0].x() < -0.4 ? sitting : lying) += 1;
  }
  EXPECT_NEAR(sitting, 50, 20);
  EXPECT_NEAR(lying, 50, 20);
}

// Two wings of two joints on a spine, a tail of three.
TEST(RigPose, WingsFoldAndTailsCurl) {
  PoseBody b;
  const auto add = [&](JointClass c, int parent, const Vector3d& p) {
    TargetJoint joint;
    joint.joint_class = c;
    joint.parent = parent;
    b.target.joints.push_back(joint);
    b.joints.push_back({p.x(), p.y(), p.z()});
  };
  add(kClassPelvis, -1, {0, 0.5, 0});
  add(kClassWing, 0, {0.1, 0.6, 0});
  add(kClassWing, 1, {0.3, 0.6, 0});
  add(kClassWing, 2, {0.5, 0.6, 0});
  add(kClassTail, 0, {0, 0.5, -0.1});
  add(kClassTail, 4, {0, 0.5, -0.2});
  b.kids = {{1, 4}, {2}, {3}, {}, {5}, {}};
  b.partner = {0, -1, -1, -1, 4, 5};
  int folded = 0, curled = 0;
  for (uint64_t seed = 0; seed < 400; ++seed) {
    Random random(seed);
    const RigPose pose = wide_pose(b, 1, &random);
    if (pose.aim[1].norm() > 0) {
      ++folded;
      EXPECT_LT(pose.aim[1].z(), 0) << "the first bone goes backward";
      EXPECT_GT(pose.aim[1].x(), 0) << "outside the body";
    }
    const bool winds = pose.turn[4].norm() > 0 && pose.turn[4] == pose.turn[5];
    curled += winds ? 1 : 0;
  }
  EXPECT_NEAR(folded, 140, 40);
  EXPECT_NEAR(curled, 100, 40);
}

TEST(RigPose, LegsWalkAndSit) {
  const PoseBody b = body(false);
  int walking = 0, sitting = 0;
  for (uint64_t seed = 0; seed < 200; ++seed) {
    Random random(seed);
    const RigPose pose = wide_pose(b, 1, &random);
    const double left = pose.turn[6].x(), right = pose.turn[12].x();
    walking += left == -right && left != 0 && !pose.symmetric ? 1 : 0;
    sitting += left < -0.75 && right < -0.75 && pose.turn[7].x() > 0.2 ? 1 : 0;
  }
  EXPECT_NEAR(walking, 36, 18);
  EXPECT_NEAR(sitting, 32, 18);
}

TEST(RigPose, OneSeedOnePose) {
  const PoseBody b = body(false);
  Random first(7), second(7), third(8);
  const RigPose one = wide_pose(b, 1, &first), same = wide_pose(b, 1, &second), other = wide_pose(b, 1, &third);
  for (size_t i = 0; i < b.bones(); ++i) EXPECT_EQ(one.turn[i], same.turn[i]);
  EXPECT_NE(one.turn[1], other.turn[1]);
}

}  // namespace
}  // namespace sinew
