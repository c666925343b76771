// SPDX-License-Identifier: MIT
// Which segments are bones: a joint's to its children, in their order, and a leaf's to its tip.
#include "skeleton/bones.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "mesh_scene.hpp"

namespace {

using sinew::Vec3i;
using sinew_test::MeshRun;
using sinew_test::MeshScene;

TEST(Bones, OneToEachChildAndALeafsToItsTip) {
  MeshScene scene;
  sinew_test::add_cube(&scene, -5, 0, -5, 10);
  const std::vector<int32_t> parents = {2, -1, 1, 1, -1};  // 1 has the children 2 and 3, 2 has 0; 4 is alone
  for (size_t j = 0; j < parents.size(); ++j) scene.add_joint(0, static_cast<float>(j), 0, parents[j]);
  const MeshRun run(scene);
  ASSERT_EQ(run.status, SINEW_OK);
  const sinew::Skeleton& s = run.skeleton;
  const std::vector<Vec3i> tips = {{1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}, {5, 0, 0}};

  std::vector<uint32_t> count(parents.size(), 0);
  sinew::each_bone(s, tips.data(), [&](uint32_t joint, Vec3i head, Vec3i tail) {
    EXPECT_EQ(head, s.positions[joint]);
    const bool leaf = joint == 0 || joint == 3 || joint == 4;
    const uint32_t child = joint == 2 ? 0 : 2 + count[joint];
    EXPECT_EQ(tail, leaf ? tips[joint] : s.positions[child]) << joint;
    ++count[joint];
  });
  for (uint32_t j = 0; j < parents.size(); ++j) EXPECT_EQ(count[j], sinew::bone_count(s, j)) << j;
  EXPECT_EQ(count, (std::vector<uint32_t>{1, 2, 1, 1, 1}));
}

}  // namespace
