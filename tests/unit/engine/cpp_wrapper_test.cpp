// SPDX-License-Identifier: MIT
// sinew.hpp against sinew.h: the same bytes in every weight format, and outputs that stay as they were on failure.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstring>

#include "map_rig.hpp"
#include "mesh_scene.hpp"
#include "motion_clip.hpp"
#include "rig_scene.hpp"
#include "sinew/published.h"
#include "sinew/sinew.hpp"
#include "skeleton_of.hpp"
#include "transfer_scene.hpp"

namespace {

using sinew_test::MeshScene;

// A bar of five rings along y with two bones.
MeshScene bar() {
  MeshScene scene;
  for (int ring = 0; ring < 5; ++ring) {
    for (const auto& c : {std::array<float, 2>{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
      scene.add_vertex(c[0], static_cast<float>(ring), c[1]);
    }
  }
  for (uint32_t ring = 0; ring < 4; ++ring) {
    for (uint32_t side = 0; side < 4; ++side) {
      const uint32_t a = 4 * ring + side, b = 4 * ring + (side + 1) % 4;
      scene.add_face({a, a + 4, b + 4, b});
    }
  }
  scene.add_joint(0.5f, 0.1f, 0.5f, -1);
  scene.add_joint(0.5f, 2.0f, 0.5f, 0);
  scene.flags = {SINEW_JOINT_DEFORMS, SINEW_JOINT_DEFORMS};
  return scene;
}

template <class Weight>
void expect_the_same_bytes(uint32_t influences) {
  const MeshScene scene = bar();
  const sinew_mesh mesh = scene.mesh_view();
  const sinew_skeleton skeleton = scene.skeleton_view();
  sinew::Options options;
  options.method = SINEW_METHOD_HEAT;
  options.influence_count = influences;
  sinew::Workspace workspace;
  sinew::Skin<Weight> skin;
  ASSERT_EQ(sinew::bind(nullptr, mesh, skeleton, options, &workspace, &skin), SINEW_OK);
  const uint32_t n = influences == 0 ? 4 : influences;
  ASSERT_EQ(skin.influence_count, n);
  ASSERT_EQ(skin.joint_indices.size(), size_t{n} * mesh.vertex_count);

  options.weight_format = sinew::WeightFormat<Weight>::value;
  std::vector<uint16_t> joints(skin.joint_indices.size(), 99);
  std::vector<Weight> weights(skin.weights.size(), static_cast<Weight>(99));
  sinew_bind_outputs outputs = SINEW_INIT(sinew_bind_outputs);
  outputs.joint_indices = joints.data();
  outputs.weights = weights.data();
  ASSERT_EQ(sinew_bind(nullptr, &mesh, &skeleton, &options, workspace.data(), workspace.size(), &outputs), SINEW_OK);
  EXPECT_EQ(skin.joint_indices, joints);
  EXPECT_EQ(std::memcmp(skin.weights.data(), weights.data(), weights.size() * sizeof(Weight)), 0);
}

TEST(CppWrapper, BindsAsTheCFunctionDoes) {
  expect_the_same_bytes<uint16_t>(2);
  expect_the_same_bytes<uint8_t>(0);
  expect_the_same_bytes<float>(3);
}

TEST(CppWrapper, LeavesTheSkinAloneOnFailure) {
  const MeshScene scene = bar();
  sinew_mesh mesh = scene.mesh_view();
  const sinew_skeleton skeleton = scene.skeleton_view();
  sinew::Options options;
  options.method = SINEW_METHOD_HEAT;
  sinew::Workspace workspace;
  sinew::Skin<uint16_t> skin{1, {7}, {65535}, 0};
  mesh.face_vertices = nullptr;
  EXPECT_NE(sinew::bind(nullptr, mesh, skeleton, options, &workspace, &skin), SINEW_OK);
  options.influence_count = 13;
  EXPECT_EQ(sinew::bind(nullptr, scene.mesh_view(), skeleton, options, &workspace, &skin), SINEW_ERROR_ARGUMENT);
  EXPECT_EQ(skin.joint_indices, std::vector<uint16_t>{7});
  EXPECT_EQ(skin.weights, std::vector<uint16_t>{65535});
}

TEST(CppWrapper, KeepsLockedRowsAndWantsThem) {
  const MeshScene scene = bar();
  sinew::Options options;
  options.method = SINEW_METHOD_HEAT;
  options.influence_count = 1;
  std::vector<uint8_t> locked(scene.vertex_count(), 0);
  locked[19] = 1;  // at the far end, where the other joint would have it
  options.locked = locked.data();
  sinew::Workspace workspace;
  sinew::Skin<uint16_t> skin;
  EXPECT_EQ(sinew::bind(nullptr, scene.mesh_view(), scene.skeleton_view(), options, &workspace, &skin),
            SINEW_ERROR_ARGUMENT);
  skin = {1, std::vector<uint16_t>(scene.vertex_count(), 0), std::vector<uint16_t>(scene.vertex_count(), 65535), 0};
  ASSERT_EQ(sinew::bind(nullptr, scene.mesh_view(), scene.skeleton_view(), options, &workspace, &skin), SINEW_OK);
  EXPECT_EQ(skin.joint_indices[19], 0);
  EXPECT_EQ(skin.joint_indices[18], 1);
}

TEST(CppWrapper, AsksAndWantsAPlaceForIt) {
  const MeshScene scene = bar();
  sinew::Options options;
  options.method = SINEW_METHOD_HEAT;
  options.question_count = 5;
  sinew::Workspace workspace;
  sinew::Skin<uint16_t> skin;
  EXPECT_EQ(sinew::bind(nullptr, scene.mesh_view(), scene.skeleton_view(), options, &workspace, &skin),
            SINEW_ERROR_ARGUMENT);
  sinew::QuestionList asked;
  ASSERT_EQ(sinew::bind(nullptr, scene.mesh_view(), scene.skeleton_view(), options, &workspace, &skin, nullptr, &asked),
            SINEW_OK);
  ASSERT_EQ(asked.questions.size(), 1u);  // the bar is in one piece
  EXPECT_EQ(asked.questions[0].vertex_count, scene.vertex_count());
  EXPECT_EQ(asked.vertex_questions, std::vector<uint32_t>(scene.vertex_count(), 0));
  EXPECT_EQ(asked.vertex_parts, std::vector<uint32_t>(scene.vertex_count(), 0));
}

TEST(CppWrapper, RigsAsTheCFunctionDoesAndBindsWhatItGives) {
  const MeshScene scene = bar();
  sinew::RigSettings settings;
  settings.spine_count = 2;
  const sinew_test::RiggedScene expected(scene, settings);
  expected.expect_sound();
  sinew::Workspace workspace;
  sinew::RiggedSkeleton skeleton;
  ASSERT_EQ(sinew::rig(bundled_rig_model(), scene.mesh_view(), settings, &workspace, &skeleton), SINEW_OK);
  ASSERT_EQ(skeleton.joint_count(), expected.count);
  const auto same = [&](const auto& found, const auto& wanted, size_t each = 1) {
    return found.size() == each * expected.count && std::equal(found.begin(), found.end(), wanted.begin());
  };
  EXPECT_TRUE(same(skeleton.positions, expected.positions, 3));
  EXPECT_TRUE(same(skeleton.parents, expected.parents));
  EXPECT_TRUE(same(skeleton.partners, expected.partners));
  EXPECT_TRUE(same(skeleton.flags, expected.flags));
  EXPECT_TRUE(same(skeleton.joint_classes, expected.classes));
  EXPECT_TRUE(same(skeleton.confidence, expected.confidence));
  EXPECT_TRUE(same(skeleton.parent_confidence, expected.parent_confidence));
  ASSERT_EQ(skeleton.names.size(), expected.count);
  for (uint32_t j = 0; j < expected.count; ++j) EXPECT_EQ(skeleton.names[j].text, expected.names[j]);
  EXPECT_EQ(skeleton.mirrored, expected.outputs.mirrored != 0);
  EXPECT_EQ(skeleton.facing, expected.outputs.facing);
  EXPECT_EQ(skeleton.plane, expected.outputs.plane);
  EXPECT_EQ(skeleton.spread, expected.outputs.spread);

  sinew::Skin<uint8_t> skin;
  EXPECT_EQ(sinew::bind(bundled_model(), scene.mesh_view(), skeleton.view(), {}, &workspace, &skin), SINEW_OK);
  EXPECT_EQ(skin.influence_count, 4u);
}

TEST(CppWrapper, LeavesTheSkeletonAloneOnFailure) {
  const MeshScene scene = bar();
  sinew::Workspace workspace;
  sinew::RiggedSkeleton skeleton;
  skeleton.parents = {-1, 0};
  EXPECT_EQ(sinew::rig(bundled_model(), scene.mesh_view(), {}, &workspace, &skeleton), SINEW_ERROR_MODEL_TASK);
  sinew_mesh mesh = scene.mesh_view();
  mesh.face_vertices = nullptr;
  EXPECT_EQ(sinew::rig(bundled_rig_model(), mesh, {}, &workspace, &skeleton), SINEW_ERROR_ARGUMENT);
  EXPECT_EQ(skeleton.parents, (std::vector<int32_t>{-1, 0}));
}

TEST(CppWrapper, WorkspaceGrowsAndMoves) {
  sinew::Workspace workspace(100);
  EXPECT_EQ(workspace.size(), 100u);
  EXPECT_TRUE(workspace.reserve(10));
  EXPECT_EQ(workspace.size(), 100u);
  EXPECT_TRUE(workspace.reserve(1000));
  EXPECT_EQ(reinterpret_cast<uintptr_t>(workspace.data()) % SINEW_WORKSPACE_ALIGNMENT, 0u);
  const sinew::Workspace moved(std::move(workspace));
  EXPECT_EQ(moved.size(), 1000u);
}

TEST(CppWrapper, ARetargetPlanThatWasNotMadeRefuses) {
  const float positions[6] = {0, 0, 0, 0, 1, 0};
  const int32_t parents[2] = {-1, 0}, map[2] = {0, 1}, none[2] = {-1, -1};
  sinew_skeleton rig = sinew_test::skeleton_of(positions, parents, 2);
  const float rotations[8] = {0, 0, 0, 1, 0, 0, 0.6f, 0.8f}, translations[6] = {1, 2, 3, 0, 1, 0};
  float turned[8], moved[6], ground = 0;
  sinew::RetargetPlan plan;
  EXPECT_EQ(plan.frame(rotations, translations, 0, turned, moved), SINEW_ERROR_ARGUMENT);
  ASSERT_EQ(plan.make(rig, rig, map, nullptr), SINEW_OK);
  ASSERT_EQ(plan.ground(nullptr, 0, &ground), SINEW_OK);
  ASSERT_EQ(plan.frame(rotations, translations, ground, turned, moved), SINEW_OK);
  for (int i = 0; i < 8; ++i) EXPECT_NEAR(turned[i], rotations[i], 1e-6f);
  for (int i = 0; i < 6; ++i) EXPECT_NEAR(moved[i], translations[i], 1e-6f);
  EXPECT_EQ(plan.make(rig, rig, none, nullptr), SINEW_ERROR_NO_JOINT);
  EXPECT_EQ(plan.frame(rotations, translations, 0, turned, moved), SINEW_ERROR_ARGUMENT);
}

// Whole clips of sinew/motion_clips.h, which sinew.h includes.
TEST(CppWrapper, ARetargetPlanMendsAndMeasuresClips) {
  const sinew_test::MotionScene scene = sinew_test::body(20), other = sinew_test::body(35, 0.9);
  const sinew_test::BoxBody source_boxes(scene, 0.1), target_boxes(other, 0.16, 0.9);
  const sinew_motion_body source = source_boxes.view(), target = target_boxes.view();
  const sinew_skeleton from = scene.view(), to = other.view();
  sinew_test::Pose pose = sinew_test::rest_pose(scene), out(other.count());
  sinew::RetargetPlan plan;
  sinew::Workspace workspace;
  std::vector<sinew_limb_quality> limbs(1);
  sinew_motion_clip clip = {
      pose.rotations.data(), pose.translations.data(), out.rotations.data(), out.translations.data(), 1, 0};
  EXPECT_EQ(plan.get(), nullptr);
  EXPECT_EQ(plan.keep_range(target, clip, &workspace), SINEW_ERROR_ARGUMENT);
  EXPECT_EQ(plan.measure(&source, target, clip, {}, &workspace, &limbs), SINEW_ERROR_ARGUMENT);
  EXPECT_EQ(limbs.size(), 1u);
  ASSERT_EQ(plan.make(from, to, sinew_test::one_to_one(other.count()).data(), other.classes.data()), SINEW_OK);
  ASSERT_EQ(plan.ground(nullptr, 0, &clip.ground), SINEW_OK);
  ASSERT_EQ(plan.frame(pose.rotations.data(), pose.translations.data(), clip.ground, out.rotations.data(),
                       out.translations.data()),
            SINEW_OK);
  EXPECT_EQ(plan.keep_range(target, clip, &workspace), SINEW_OK);
  EXPECT_EQ(plan.contacts(&source, target, clip, {}, &workspace), SINEW_OK);
  EXPECT_EQ(plan.measure(&source, target, clip, {}, &workspace, &limbs), SINEW_OK);
  ASSERT_EQ(limbs.size(), 4u);
  EXPECT_EQ(limbs[0].frames, 1u);
}

TEST(CppWrapper, TransfersAsTheCFunctionDoes) {
  const MeshScene source = sinew_test::limb(9, 6, 3, 0.3), target = sinew_test::limb(12, 5, 4, 0.4);
  const sinew_test::BoundRows rows = sinew_test::painted(source, 3);
  sinew::TransferSettings settings;
  settings.method = SINEW_TRANSFER_NEAREST;
  settings.influence_count = 2;
  settings.weight_format = SINEW_WEIGHT_FLOAT;  // what the type of the weights overrules
  const sinew_mesh source_mesh = source.mesh_view();
  const sinew_skeleton skeleton = source.skeleton_view();
  const int32_t map[] = {0, 1, 2}, none[] = {-1, -1, -1};
  sinew_bound_character bound = {
      &source_mesh, &skeleton, {rows.joints.data(), rows.weights.data(), 2, SINEW_WEIGHT_UNORM16}, map};
  sinew::Workspace workspace;
  sinew::Skin<uint16_t> skin;
  sinew::TransferReport report;
  ASSERT_EQ(
      sinew::transfer(nullptr, bound, target.mesh_view(), target.skeleton_view(), settings, &workspace, &skin, &report),
      SINEW_OK);
  settings.weight_format = SINEW_WEIGHT_UNORM16;
  const sinew_test::TransferRun expected = sinew_test::run_transfer(source, rows, target, settings);
  ASSERT_EQ(expected.status, SINEW_OK);
  EXPECT_EQ(skin.influence_count, 2u);
  EXPECT_EQ(skin.joint_indices, expected.joints);
  EXPECT_EQ(skin.weights, expected.weights);
  EXPECT_EQ(report.confidence, expected.confidence);
  EXPECT_EQ(report.vertex_parts, expected.vertex_parts);
  ASSERT_EQ(report.parts.size(), expected.parts.size());
  EXPECT_EQ(report.parts[0].vertex_count, expected.parts[0].vertex_count);
  EXPECT_EQ(report.carried_q16, expected.outputs.carried_q16);
  EXPECT_EQ(report.bound_by, expected.outputs.bound_by);
  EXPECT_EQ(report.used_bytes, expected.outputs.used_bytes);

  // Failures leave both alone; locked rows are wanted in the right number.
  bound.joint_map = none;
  const std::vector<uint16_t> weights = skin.weights;
  EXPECT_EQ(
      sinew::transfer(nullptr, bound, target.mesh_view(), target.skeleton_view(), settings, &workspace, &skin, &report),
      SINEW_ERROR_RANGE);
  EXPECT_EQ(skin.weights, weights);
  EXPECT_EQ(report.parts.size(), expected.parts.size());
  bound.joint_map = map;
  const std::vector<uint8_t> locked(target.vertex_count(), 1);
  settings.locked = locked.data();
  sinew::Skin<uint16_t> empty;
  EXPECT_EQ(sinew::transfer(nullptr, bound, target.mesh_view(), target.skeleton_view(), settings, &workspace, &empty),
            SINEW_ERROR_ARGUMENT);
  sinew::Skin<uint16_t> kept{2, skin.joint_indices, skin.weights, 0};
  kept.joint_indices.assign(kept.joint_indices.size(), 0);
  kept.weights.assign(kept.weights.size(), 0);
  for (size_t v = 0; v < kept.weights.size(); v += 2) kept.weights[v] = 65535;
  const std::vector<uint16_t> painted = kept.weights;
  EXPECT_EQ(sinew::transfer(nullptr, bound, target.mesh_view(), target.skeleton_view(), settings, &workspace, &kept),
            SINEW_OK);
  EXPECT_EQ(kept.weights, painted);
}

TEST(CppWrapper, MapsAsTheCFunctionDoes) {
  const sinew_test::TestRig target = sinew_test::humanoid(3, true), source = sinew_test::humanoid(2, false);
  sinew_test::MapCall expected;
  expected.run(target, source);
  std::vector<const char*> texts;
  const sinew_skeleton to = expected.view(target, &texts), from = expected.view(source, &texts);
  sinew::Workspace workspace;
  sinew::JointMap map;
  ASSERT_EQ(sinew::map_joints(to, from, {}, &workspace, &map), SINEW_OK);
  EXPECT_EQ(map.sources, expected.sources);
  EXPECT_EQ(map.confidence, expected.confidence);
  EXPECT_EQ(map.reasons, expected.reasons);
  EXPECT_EQ(map.mapped, expected.outputs.mapped);
  EXPECT_EQ(map.certainty, expected.outputs.certainty);
  EXPECT_EQ(map.method, expected.outputs.method);
  sinew::MapSettings wrong;
  wrong.method = 9;
  EXPECT_EQ(sinew::map_joints(to, from, wrong, &workspace, &map), SINEW_ERROR_ARGUMENT);
  EXPECT_EQ(map.sources, expected.sources);
}

TEST(CppWrapper, AModelKeepsItsBytesAndMoves) {
  const char* const path = SINEW_SOURCE_DIR "/samples/data/sinew_default.sinew";
  sinew::Model model;
  EXPECT_EQ(model.get(), nullptr);
  EXPECT_EQ(model.pack(), SINEW_ERROR_ARGUMENT);
  EXPECT_EQ(model.open_file("no such file"), SINEW_ERROR_ARGUMENT);
  ASSERT_EQ(model.open_file(path), SINEW_OK);
  ASSERT_NE(model.get(), nullptr);
  ASSERT_EQ(model.pack(), SINEW_OK);
  EXPECT_EQ(model.pack(), SINEW_OK) << "once is enough";

  // Bytes from anywhere, at an address that the engine does not take.
  std::vector<uint8_t> bytes(model.get()->size_bytes + 1);
  std::memcpy(bytes.data() + 1, model.get()->bytes, model.get()->size_bytes);
  sinew::Model copied;
  ASSERT_EQ(copied.open(bytes.data() + 1, bytes.size() - 1), SINEW_OK);
  const sinew::Model moved = std::move(copied);
  EXPECT_EQ(copied.get(), nullptr);  // NOLINT: what it is after a move is a promise
  std::fill(bytes.begin(), bytes.end(), uint8_t{0});

  const MeshScene scene = bar();
  sinew::Workspace workspace;
  sinew::Skin<uint16_t> packed, plain;
  ASSERT_EQ(sinew::bind(model.get(), scene.mesh_view(), scene.skeleton_view(), {}, &workspace, &packed), SINEW_OK);
  ASSERT_EQ(sinew::bind(moved.get(), scene.mesh_view(), scene.skeleton_view(), {}, &workspace, &plain), SINEW_OK);
  EXPECT_EQ(packed.weights, plain.weights);
  EXPECT_EQ(packed.joint_indices, plain.joint_indices);

  EXPECT_EQ(model.open_rig_file(path), SINEW_ERROR_MODEL_TASK);
  EXPECT_EQ(model.get(), nullptr) << "a failure leaves no model";
  EXPECT_EQ(model.open(path, 0), SINEW_ERROR_MODEL_TRUNCATED);
  EXPECT_EQ(model.open_rig_file(SINEW_SOURCE_DIR "/samples/data/sinew_hands.sinew"), SINEW_OK);
}

}  // namespace
