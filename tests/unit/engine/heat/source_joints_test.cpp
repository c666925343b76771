// SPDX-License-Identifier: MIT
// Which joints may be heat sources: every usable one but a root on the floor.
#include <gtest/gtest.h>

#include <vector>

#include "heat/heat.hpp"
#include "mesh_scene.hpp"

namespace {

using sinew_test::add_cube;
using sinew_test::MeshRun;
using sinew_test::MeshScene;

// Ten units tall.
MeshScene tall_box() {
  MeshScene scene;
  add_cube(&scene, -5, 0, -5, 10);
  return scene;
}

std::vector<uint8_t> source_joints(const MeshScene& scene) {
  const MeshRun run(scene);
  EXPECT_EQ(run.status, SINEW_OK);
  std::vector<uint8_t> sources(run.skeleton.joint_count);
  sinew::choose_source_joints(run.mesh, run.skeleton, sources.data());
  return sources;
}

TEST(SourceJoints, ARootOnTheFloorIsNone) {
  const auto root = [](float height, int children, uint8_t flag) {
    MeshScene scene = tall_box();
    scene.add_joint(0, height, 0, -1);
    for (int i = 0; i < children; ++i) scene.add_joint(0, 5, static_cast<float>(i), 0);
    if (children == 0) scene.add_joint(0, 5, 0, -1);
    scene.add_joint(0, 8, 0, 1);  // no child of it
    if (flag != 0) scene.flags.assign(scene.parents.size(), flag);
    const std::vector<uint8_t> sources = source_joints(scene);
    EXPECT_EQ(sources[1], 1);
    return sources[0];
  };
  EXPECT_EQ(root(0.29f, 1, 0), 0);
  EXPECT_EQ(root(-4.0f, 4, 0), 0);
  EXPECT_EQ(root(0.31f, 1, 0), 1);  // above the lowest 3 %
  EXPECT_EQ(root(0.0f, 0, 0), 1);   // no children
  EXPECT_EQ(root(0.0f, 5, 0), 1);   // more than four
  EXPECT_EQ(root(0.0f, 2, SINEW_JOINT_DEFORMS), 1);
}

TEST(SourceJoints, OneOfTwoJointsIsAlwaysOne) {
  MeshScene scene = tall_box();
  scene.add_joint(0, 0, 0, -1);
  scene.add_joint(0, 5, 0, 0);
  EXPECT_EQ(source_joints(scene), (std::vector<uint8_t>{1, 1}));
}

TEST(SourceJoints, TheLastUsableJointStaysOne) {
  MeshScene scene = tall_box();
  scene.add_joint(0, 0, 0, -1);
  scene.add_joint(0, 5, 0, 0);
  scene.add_joint(0, 9, 0, 1);
  scene.flags = {0, SINEW_JOINT_NEVER, SINEW_JOINT_NEVER};
  EXPECT_EQ(source_joints(scene), (std::vector<uint8_t>{1, 0, 0}));
}

}  // namespace
