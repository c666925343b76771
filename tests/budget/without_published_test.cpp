// SPDX-License-Identifier: MIT
// The engine without SINEW_PUBLISHED_METHODS: it links, is smaller, says so where one is asked for, and does the rest.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>

#include "sinew/published.h"
#include "sinew/sinew.hpp"
#include "skeleton_of.hpp"

namespace {

const float kPositions[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
const uint32_t kCorners[] = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
const float kJoints[] = {0.1f, 0.1f, 0.1f, 0.5f, 0.1f, 0.1f};
const int32_t kParents[] = {-1, 0};
const sinew_mesh kMesh = {kPositions, 4, nullptr, kCorners, 4, 12};
sinew_skeleton skeleton() { return sinew_test::skeleton_of(kJoints, kParents, 2); }

TEST(WithoutPublishedMethods, TheyAreNotBuilt) {
  sinew::Workspace workspace(size_t{1} << 24);
  const sinew_skeleton joints = skeleton();
  size_t bytes = 7;

  sinew::Options bind;
  bind.method = SINEW_METHOD_DISTANCE;
  sinew::Skin<uint16_t> skin;
  EXPECT_EQ(sinew::bind(nullptr, kMesh, joints, bind, &workspace, &skin), SINEW_ERROR_NOT_BUILT);
  bind.method = SINEW_METHOD_HEAT;
  ASSERT_EQ(sinew::bind(nullptr, kMesh, joints, bind, &workspace, &skin), SINEW_OK);

  sinew::RigSettings rig;
  rig.method = SINEW_RIG_REGIONS;
  EXPECT_EQ(sinew_rig_workspace_size(nullptr, 4, 4, 12, &rig, &bytes), SINEW_ERROR_NOT_BUILT);
  rig.method = SINEW_RIG_SLOTS;
  EXPECT_EQ(sinew_rig_workspace_size(nullptr, 4, 4, 12, &rig, &bytes), SINEW_ERROR_NOT_BUILT);
  EXPECT_EQ(bytes, 0u);

  sinew::MapSettings map;
  sinew::JointMap mapped;
  map.method = SINEW_MAP_BRANCHES;
  EXPECT_EQ(sinew::map_joints(joints, joints, map, &workspace, &mapped), SINEW_ERROR_NOT_BUILT);
  map.method = SINEW_MAP_AUTO;
  ASSERT_EQ(sinew::map_joints(joints, joints, map, &workspace, &mapped), SINEW_OK);
  EXPECT_EQ(mapped.method, uint32_t{SINEW_MAP_SINEW});

  const sinew_skin rows = {skin.joint_indices.data(), skin.weights.data(), 4, SINEW_WEIGHT_UNORM16};
  sinew::Deformer deformer;
  sinew::DeformOptions deform;
  deform.method = SINEW_DEFORM_XPBD;
  EXPECT_EQ(deformer.create(kMesh, joints, rows, deform), SINEW_ERROR_NOT_BUILT);
  deform.method = SINEW_DEFORM_VOLUME;
  EXPECT_EQ(deformer.create(kMesh, joints, rows, deform), SINEW_OK);

  const int32_t same[] = {0, 1};
  const sinew_bound_character bound = {&kMesh, &joints, rows, same};
  sinew::TransferSettings transfer;
  transfer.method = SINEW_TRANSFER_BIHARMONIC;
  sinew::Skin<uint16_t> carried;
  EXPECT_EQ(sinew::transfer(nullptr, bound, kMesh, joints, transfer, &workspace, &carried), SINEW_ERROR_NOT_BUILT);
  transfer.method = SINEW_TRANSFER_NEAREST;
  EXPECT_EQ(sinew::transfer(nullptr, bound, kMesh, joints, transfer, &workspace, &carried), SINEW_OK);

  uint32_t vertices[12] = {};
  float shares[12] = {};
  EXPECT_EQ(sinew_corresponding_points_workspace_size(&bound, &kMesh, &joints, &bytes), SINEW_ERROR_NOT_BUILT);
  EXPECT_EQ(sinew_corresponding_points(&bound, &kMesh, &joints, workspace.data(), workspace.size(), vertices, shares),
            SINEW_ERROR_NOT_BUILT);

  sinew::RetargetPlan plan;
  ASSERT_EQ(plan.make(joints, joints, same, nullptr), SINEW_OK);
  const sinew_motion_body body = {kPositions, kCorners, rows, 4, 4};
  EXPECT_EQ(sinew_retarget_reference_points_workspace_size(plan.get(), &body, &bytes), SINEW_ERROR_NOT_BUILT);
  float rotations[] = {0, 0, 0, 1, 0, 0, 0, 1}, translations[6] = {};
  const sinew_motion_clip clip = {rotations, translations, rotations, translations, 1, 0};
  EXPECT_EQ(
      sinew_retarget_reference_points(plan.get(), &body, &body, &clip, nullptr, workspace.data(), workspace.size()),
      SINEW_ERROR_NOT_BUILT);
}

// Names that the stub does not define, in two parts: whole ones would be found in this file's own strings.
TEST(WithoutPublishedMethods, TheyAreNotLinked) {
  std::ifstream file(SINEW_TEST_PROGRAM, std::ios::binary);
  const std::string program((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  const auto is_linked = [&](const std::string& begin, const std::string& end) {
    return program.find(begin + end) != std::string::npos;
  };
  EXPECT_TRUE(is_linked("run_tran", "sfer")) << "the program has no names";
  EXPECT_FALSE(is_linked("Oriented", "Box"));
  EXPECT_FALSE(is_linked("join_slo", "ts"));
  EXPECT_FALSE(is_linked("solve_x", "pbd"));
  EXPECT_FALSE(is_linked("Refer", "ences4find"));
  EXPECT_FALSE(is_linked("Capsule", "Bodies"));
  EXPECT_FALSE(is_linked("Bran", "ches"));
}

}  // namespace
