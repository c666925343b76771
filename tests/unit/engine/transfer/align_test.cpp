// SPDX-License-Identifier: MIT
// Skeletons laid over each other: bones land on their counterparts, whatever their size, turn and pose.
#include "transfer/align.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <vector>

#include "mesh_scene.hpp"

namespace sinew::transferring {
namespace {

using sinew_test::MeshRun;
using sinew_test::MeshScene;

// A trunk with two arms in a box that fixes the grid; arms at an angle, all of it turned by quarters about y and scaled.
MeshScene body(double arm_rise, int quarters, double scale) {
  MeshScene scene;
  const auto turned = [&](double x, double y, double z, auto add) {
    for (int i = 0; i < quarters; ++i) {
      const double old = x;
      x = z;
      z = -old;
    }
    add(scale * x, scale * y, scale * z);
  };
  for (int i = 0; i < 8; ++i)
    turned(i & 1 ? 1 : -1, i & 2 ? 2 : 0, i & 4 ? 1 : -1,
           [&](double x, double y, double z) { scene.add_vertex(x, y, z); });
  scene.add_face({0, 1, 3, 2});
  scene.add_face({4, 6, 7, 5});
  const auto joint = [&](double x, double y, double z, int32_t parent) {
    turned(x, y, z, [&](double a, double b, double c) { scene.add_joint(a, b, c, parent); });
  };
  joint(0, 1, 0, -1);
  joint(0, 1.5, 0.1, 0);
  for (const double side : {1.0, -1.0}) {
    const int32_t shoulder = static_cast<int32_t>(scene.joint_count());
    joint(0.2 * side, 1.5, 0, 1);
    joint(0.5 * side, 1.5 + arm_rise, 0, shoulder);
  }
  return scene;
}

struct Aligned {
  MeshRun source, target;
  std::vector<Similarity> joints;
  std::vector<int32_t> same;
  Alignment alignment;

  Aligned(const MeshScene& from, const MeshScene& to) : source(from), target(to), joints(from.joint_count()) {
    same.resize(from.joint_count());
    std::iota(same.begin(), same.end(), 0);
  }
  void find() {
    JointCounterparts map;
    map.same = same.data();
    std::vector<uint32_t> scratch(3 * same.size() + 1);
    alignment.joints = joints.data();
    alignment.find(map, source.skeleton, target.skeleton, scratch.data());
  }
  // How far joint j's similarity puts joint k from its counterpart, longest sides of the target.
  double off(size_t j, size_t k) const {
    return length(joints[j](position_of(source.skeleton.positions[k])) - position_of(target.skeleton.positions[k]));
  }
};

TEST(Alignment, TheSameSkeletonStaysWhereItIs) {
  Aligned a(body(0, 0, 1), body(0, 0, 1));
  a.find();
  EXPECT_NEAR(a.alignment.scale, 1, 1e-12);
  for (size_t j = 0; j < 6; ++j)
    for (size_t k = 0; k < 6; ++k) EXPECT_NEAR(a.off(j, k), 0, 1e-9) << j << " " << k;
}

TEST(Alignment, EveryBoneLandsOnItsCounterpart) {
  for (const int quarters : {0, 1, 2, 3}) {
    Aligned a(body(0.3, 0, 1), body(-0.3, quarters, 100));
    a.find();
    for (size_t j = 0; j < 6; ++j) EXPECT_NEAR(a.off(j, j), 0, 1e-9) << quarters << " " << j;
    EXPECT_NEAR(a.off(2, 3), 0, 1e-6) << quarters;  // arms turned from 45 degrees above to as much below
    EXPECT_NEAR(a.off(4, 5), 0, 1e-6) << quarters;
  }
}

TEST(Alignment, UnmappedJointsGoWithTheirParents) {
  Aligned a(body(0.3, 0, 1), body(0, 0, 1));
  a.same[3] = -1;
  a.find();
  for (int e = 0; e < 9; ++e) EXPECT_EQ(a.joints[3].rotation.m[e], a.joints[2].rotation.m[e]);
  EXPECT_EQ(a.joints[3].shift.x, a.joints[2].shift.x);
}

TEST(Alignment, WithoutAnyMappedJointNothingMoves) {
  Aligned a(body(0.3, 0, 1), body(0, 1, 3));
  for (int32_t& same : a.same) same = -1;
  a.find();
  for (size_t j = 0; j < 6; ++j) {
    const Vec3d p = {0.1, 0.2, 0.3};
    EXPECT_NEAR(length(a.joints[j](p) - p), 0, 1e-12);
  }
}

TEST(Alignment, WarpsByTheWeightsOfARow) {
  Aligned a(body(0.3, 0, 1), body(-0.3, 0, 1));
  a.find();
  uint16_t joints[kRowSlots];
  uint32_t weights[kRowSlots] = {};
  for (uint16_t& joint : joints) joint = kNoJoint;
  const Vec3d p = {0.2, 0.7, 0.1};
  EXPECT_NEAR(length(a.alignment.warp(p, joints, weights) - a.joints[0](p)), 0, 1e-12)
      << "no weight: as the first joint";
  joints[0] = 2;
  joints[1] = 4;
  weights[0] = 3;
  weights[1] = 1;
  const Vec3d expected = 0.75 * a.joints[2](p) + 0.25 * a.joints[4](p);
  EXPECT_NEAR(length(a.alignment.warp(p, joints, weights) - expected), 0, 1e-12);
}

}  // namespace
}  // namespace sinew::transferring
