// SPDX-License-Identifier: MIT
// Maps of joints completed: weight of joints without a counterpart goes up, else down; joints that only the target has know their
// head.
#include "transfer/joint_counterparts.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "mesh_scene.hpp"

namespace sinew::transferring {
namespace {

using sinew_test::MeshRun;
using sinew_test::MeshScene;

// A skeleton of these parents around a cube.
MeshScene scene_of(const std::vector<int32_t>& parents) {
  MeshScene scene;
  sinew_test::add_cube(&scene, 0, 0, 0);
  for (size_t j = 0; j < parents.size(); ++j) scene.add_joint(0.5, 0.1 * static_cast<double>(j), 0.5, parents[j]);
  return scene;
}

struct Completed {
  MeshRun source, target;
  std::vector<int32_t> same, target_of, head;
  std::vector<uint8_t> is_new;
  JointCounterparts map;

  Completed(const MeshScene& from, const MeshScene& to, const std::vector<int32_t>& counterparts)
      : source(from), target(to) {
    const size_t sources = from.joint_count(), targets = to.joint_count();
    same.resize(sources);
    target_of.resize(sources);
    head.resize(targets);
    is_new.resize(targets);
    map.same = same.data();
    map.target_of = target_of.data();
    map.head = head.data();
    map.is_new = is_new.data();
    std::vector<uint32_t> scratch(2 * sources);
    map.complete(counterparts.data(), source.skeleton, target.skeleton, scratch.data());
  }
};

using Joints = std::vector<int32_t>;

TEST(JointCounterparts, WeightWithoutACounterpartGoesUpElseDown) {
  // 0 - 1 - 2 - 3 and 1 - 4; nothing stands for 0, 2 and 4.
  const MeshScene source = scene_of({-1, 0, 1, 2, 1}), target = scene_of({-1, 0});
  const Completed c(source, target, {-1, 0, -1, 1, -1});
  EXPECT_EQ(c.same, (Joints{-1, 0, -1, 1, -1}));
  EXPECT_EQ(c.target_of, (Joints{0, 0, 0, 1, 0}));
  EXPECT_EQ(c.is_new, (std::vector<uint8_t>{0, 0}));
}

TEST(JointCounterparts, TheNearestBelowOfSeveralIsTheOneOfLowestNumber) {
  const MeshScene source = scene_of({-1, 0, 0, 1}), target = scene_of({-1, 0, 0});
  EXPECT_EQ(Completed(source, target, {-1, -1, 2, 1}).target_of, (Joints{2, 1, 2, 1}));
  EXPECT_EQ(Completed(source, target, {-1, 1, 2, 0}).target_of, (Joints{1, 1, 2, 0}));
}

TEST(JointCounterparts, AJointThatMustGetNoWeightTakesNone) {
  const MeshScene source = scene_of({-1, 0});
  MeshScene target = scene_of({-1, 0});
  target.flags = {0, SINEW_JOINT_NEVER};
  const Completed c(source, target, {0, 1});
  EXPECT_EQ(c.same, (Joints{0, 1}));
  EXPECT_EQ(c.target_of, (Joints{0, 0}));
}

TEST(JointCounterparts, JointsThatOnlyTheTargetHasShareTheirHeads) {
  // Target: 0 - 1 - 2 - 3, and a root 4 that nobody stands for.
  const MeshScene source = scene_of({-1, 0}), target = scene_of({-1, 0, 1, 2, -1});
  const Completed c(source, target, {0, 2});
  EXPECT_EQ(c.head, (Joints{0, 0, 2, 2, 4}));
  EXPECT_EQ(c.is_new, (std::vector<uint8_t>{0, 1, 0, 1, 1}));
}

}  // namespace
}  // namespace sinew::transferring
