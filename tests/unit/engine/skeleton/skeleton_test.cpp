// SPDX-License-Identifier: MIT
// Joint hierarchy: checks, order, bones and usable joints.
#include <gtest/gtest.h>

#include <vector>

#include "mesh_scene.hpp"

namespace {

using sinew::Vec3i;
using sinew_test::add_cube;
using sinew_test::MeshRun;
using sinew_test::MeshScene;

constexpr double kTenth = sinew::kSide / 10.0;

// Ten units tall, so that a unit is a tenth of the side; x and z are centered on 0 on the grid.
MeshScene tall_box() {
  MeshScene scene;
  add_cube(&scene, -5, 0, -5, 10);
  return scene;
}
// Within the rounding of the joints and of the bone, in the scene's units.
void expect_at(Vec3i a, double x, double y, double z) {
  EXPECT_NEAR(a.x, x * kTenth, 2);
  EXPECT_NEAR(a.y, y * kTenth, 2);
  EXPECT_NEAR(a.z, z * kTenth, 2);
}

TEST(Skeleton, ParentsComeFirst) {
  MeshScene scene = tall_box();
  const int32_t parents[] = {3, 0, 1, -1, 3, -1, 5};
  for (const int32_t p : parents) scene.add_joint(0, 1, 0, p);
  const MeshRun run(scene);
  ASSERT_EQ(run.status, SINEW_OK);
  const sinew::Skeleton& s = run.skeleton;
  std::vector<int> rank(7, -1);
  for (int i = 0; i < 7; ++i) rank[s.order[i]] = i;
  for (int j = 0; j < 7; ++j) {
    EXPECT_GE(rank[j], 0);
    if (parents[j] >= 0) {
      EXPECT_LT(rank[parents[j]], rank[j]);
    }
  }
  EXPECT_EQ(std::vector<uint16_t>(s.depth, s.depth + 7), (std::vector<uint16_t>{1, 2, 3, 0, 1, 0, 1}));
  EXPECT_EQ(std::vector<uint16_t>(s.child_count, s.child_count + 7), (std::vector<uint16_t>{1, 1, 0, 2, 0, 1, 0}));
}

TEST(Skeleton, BonesEndAtTheMeanOfTheChildren) {
  MeshScene scene = tall_box();
  scene.add_joint(0, 2, 0, -1);
  scene.add_joint(1, 4, 0, 0);
  scene.add_joint(-3, 4, 2, 0);
  scene.add_joint(1, 4.5f, 0, 1);  // a leaf: a quarter of a unit on
  scene.add_joint(-3, 4, 3, 2);    // a leaf: half a unit on
  scene.add_joint(4, 4, 4, -1);    // alone
  scene.add_joint(4, 4, 3, 5);     // its child on ...
  scene.add_joint(4, 4, 3, 6);     // ... a leaf without direction
  const MeshRun run(scene);
  ASSERT_EQ(run.status, SINEW_OK);
  const Vec3i* tail = run.skeleton.bone_tail;
  expect_at(tail[0], -1, 4, 1);
  expect_at(tail[3], 1, 4.75, 0);
  expect_at(tail[4], -3, 4, 3.5);
  EXPECT_EQ(tail[7], run.skeleton.positions[7]);
}

TEST(Skeleton, LeafBonesAreAtMostATenthOfTheSkeleton) {
  MeshScene scene = tall_box();
  scene.add_joint(0, 2, 0, -1);
  scene.add_joint(0, 6, 0, 0);
  scene.add_joint(3, 2, 0, -1);
  scene.add_joint(0, 2, 1.2f, 0);
  const MeshRun run(scene);
  ASSERT_EQ(run.status, SINEW_OK);
  expect_at(run.skeleton.bone_tail[1], 0, 6.4, 0);                  // half its bone would be 2
  expect_at(run.skeleton.bone_tail[3], 0, 2, 1.6);                  // half its bone would be 0.6
  EXPECT_EQ(run.skeleton.bone_tail[2], run.skeleton.positions[2]);  // a lone joint
}

TEST(Skeleton, JointsFarOutsideAreClamped) {
  MeshScene scene = tall_box();
  scene.add_joint(1e9f, -1e9f, 1e30f, -1);
  scene.add_joint(0, 1, 0, 0);
  const MeshRun run(scene);
  ASSERT_EQ(run.status, SINEW_OK);
  EXPECT_EQ(run.skeleton.positions[0], (Vec3i{1 << 22, -(1 << 22), 1 << 22}));
}

TEST(Skeleton, FlagsSayWhatIsUsable) {
  MeshScene scene = tall_box();
  for (int i = 0; i < 4; ++i) scene.add_joint(0, static_cast<float>(1 + i), 0, i - 1);
  const auto usable = [&](std::vector<uint8_t> flags, bool known) {
    scene.flags = std::move(flags);
    const MeshRun run(scene);
    EXPECT_EQ(run.status, SINEW_OK);
    EXPECT_EQ(run.skeleton.deform_known, known);
    return std::vector<int>(run.skeleton.usable, run.skeleton.usable + 4);
  };
  EXPECT_EQ(usable({0, 0, 0, 0}, false), (std::vector<int>{1, 1, 1, 1}));
  EXPECT_EQ(usable({0, 1, 0, 1}, false), (std::vector<int>{1, 0, 1, 0}));
  EXPECT_EQ(usable({0, 2, 3, 1}, true), (std::vector<int>{0, 1, 0, 0}));
  scene.flags = {1, 1, 1, 1};
  EXPECT_EQ(MeshRun(scene).status, SINEW_ERROR_NO_JOINT);
  scene.flags = {0, 3, 0, 0};
  EXPECT_EQ(MeshRun(scene).status, SINEW_ERROR_NO_JOINT);
}

TEST(Skeleton, RefusesBrokenHierarchies) {
  const auto status = [](const std::vector<int32_t>& parents) {
    MeshScene scene = tall_box();
    for (const int32_t p : parents) scene.add_joint(0, 1, 0, p);
    return MeshRun(scene).status;
  };
  EXPECT_EQ(status({-1, 0, 1}), SINEW_OK);
  EXPECT_EQ(status({0}), SINEW_ERROR_HIERARCHY);
  EXPECT_EQ(status({-1, 2, 1}), SINEW_ERROR_HIERARCHY);
  EXPECT_EQ(status({2, 0, 1}), SINEW_ERROR_HIERARCHY);
  EXPECT_EQ(status({-1, 0, 3, 4, 2}), SINEW_ERROR_HIERARCHY);
  EXPECT_EQ(status({-1, 3, 0}), SINEW_ERROR_INDEX);
  EXPECT_EQ(status({-2}), SINEW_ERROR_INDEX);
  MeshScene scene = tall_box();
  scene.add_joint(0, INFINITY, 0, -1);
  EXPECT_EQ(MeshRun(scene).status, SINEW_ERROR_NOT_FINITE);
}

TEST(Skeleton, AChainOf4096JointsIsFine) {
  MeshScene scene = tall_box();
  for (int32_t j = 0; j < 4096; ++j) scene.add_joint(0, static_cast<float>(j) / 410, 0, j + 1 < 4096 ? j + 1 : -1);
  const MeshRun run(scene);
  ASSERT_EQ(run.status, SINEW_OK);
  EXPECT_EQ(run.skeleton.depth[0], 4095);
  EXPECT_EQ(run.skeleton.order[0], 4095u);
  EXPECT_EQ(run.used, run.measured);
}

}  // namespace
