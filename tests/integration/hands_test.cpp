// SPDX-License-Identifier: MIT
// sinew_rig_details() of hands with the bundled model: what it promises of any skeleton, and what it makes of two hands.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <set>
#include <string>
#include <vector>

#include "hand_scene.hpp"
#include "open_bundled_model.hpp"
#include "rig_skeleton.hpp"
#include "sinew/sinew.hpp"

namespace {

using sinew_test::add_cube;
using sinew_test::add_limb;
using sinew_test::MeshScene;
using sinew_test::RigSkeleton;
using sinew_test::two_arms;

// As sinew_rig() would have given it: hips, and an arm of forearm, hand and end on each side.
struct Skeleton : RigSkeleton {
  explicit Skeleton(bool mirrored = true) {
    outputs.mirrored = mirrored ? 1 : 0;
    add("Hips", 0, 1, 0, -1, SINEW_CLASS_PELVIS, 0, mirrored ? 0 : -1);
    int at = 1;
    for (const float side : {1.0f, -1.0f}) {
      const std::string name = side > 0 ? "Left" : "Right";
      const int other = side > 0 ? 4 : -4;
      add(name + "Arm", side * 0.15f, 1.4f, 0, 0, SINEW_CLASS_UPPER_ARM, 0, mirrored ? at + other : -1);
      add(name + "ForeArm", side * 0.36f, 1.4f, 0, at, SINEW_CLASS_FOREARM, 0, mirrored ? at + 1 + other : -1);
      add(name + "Hand", side * 0.6f, 1.4f, 0, at + 1, SINEW_CLASS_HAND, 0, mirrored ? at + 2 + other : -1);
      add(name + "Hand_end", side * 0.76f, 1.4f, 0, at + 2, SINEW_CLASS_HAND, SINEW_JOINT_NEVER,
          mirrored ? at + 3 + other : -1);
      at += 4;
    }
  }
  uint32_t fingers() const {
    std::set<std::pair<int32_t, uint8_t>> found;
    for (uint32_t j = 0; j < outputs.joint_count; ++j) {
      if (classes[j] < SINEW_CLASS_THUMB) continue;
      int32_t hand = parents[j];
      while (classes[static_cast<size_t>(hand)] >= SINEW_CLASS_THUMB) hand = parents[static_cast<size_t>(hand)];
      found.insert({hand, classes[j]});
    }
    return static_cast<uint32_t>(found.size());
  }
};

sinew_status add_hands(const MeshScene& scene, Skeleton* skeleton,
                       sinew_rig_options options = SINEW_INIT(sinew_rig_options),
                       const sinew_model* model = bundled_hands_model(), size_t missing = 0) {
  const sinew_mesh mesh = scene.mesh_view();
  size_t bytes = 0;
  const sinew_status status = sinew_rig_details_workspace_size(model, mesh.vertex_count, mesh.face_count,
                                                               mesh.corner_count, SINEW_DETAIL_HANDS, &options, &bytes);
  if (status != SINEW_OK) return status;
  const sinew::Workspace block(bytes);
  std::memset(block.data(), 0x5A, bytes);
  return sinew_rig_details(model, &mesh, SINEW_DETAIL_HANDS, &options, block.data(), bytes - missing,
                           &skeleton->outputs);
}

TEST(HandsOfASkeleton, GetFingersOnBothSidesInMirrorImage) {
  Skeleton s;
  ASSERT_EQ(add_hands(two_arms(true), &s), SINEW_OK);
  EXPECT_GE(s.fingers(), 6u) << "of ten";
  std::set<std::string> names;
  for (uint32_t j = 0; j < s.outputs.joint_count; ++j) {
    EXPECT_TRUE(names.insert(s.name(j)).second) << s.name(j);
    EXPECT_LT(s.parents[j], static_cast<int32_t>(j));
    const uint32_t other = static_cast<uint32_t>(s.partners[j]);
    ASSERT_LT(other, s.outputs.joint_count);
    EXPECT_EQ(s.partners[other], static_cast<int32_t>(j));
    EXPECT_EQ(s.positions[3 * j], -s.positions[3 * other]) << s.name(j);
    EXPECT_EQ(s.positions[3 * j + 1], s.positions[3 * other + 1]);
    EXPECT_EQ(s.positions[3 * j + 2], s.positions[3 * other + 2]);
    if (s.classes[j] < SINEW_CLASS_THUMB) continue;
    const bool left = s.positions[3 * j] > 0;
    EXPECT_EQ(s.name(j).rfind(left ? "LeftHand" : "RightHand", 0), 0u) << s.name(j);
    EXPECT_EQ(s.flags[j] == SINEW_JOINT_NEVER, s.name(j).find("_end") != std::string::npos);
  }
  EXPECT_EQ(names.count("LeftHand_end"), 0u) << "the hand's own end goes";
}

TEST(HandsOfASkeleton, AreFoundEachByItselfWhereNothingIsMirrored) {
  Skeleton s(false);
  ASSERT_EQ(add_hands(two_arms(true), &s), SINEW_OK);
  EXPECT_GE(s.fingers(), 6u);
  for (uint32_t j = 0; j < s.outputs.joint_count; ++j) EXPECT_EQ(s.partners[j], -1);
}

TEST(HandsOfASkeleton, AreTheSameOnEveryKernel) {
  Skeleton reference, automatic;
  sinew_rig_options options = SINEW_INIT(sinew_rig_options);
  options.kernel = SINEW_KERNEL_REF;
  ASSERT_EQ(add_hands(two_arms(true), &reference, options), SINEW_OK);
  ASSERT_EQ(add_hands(two_arms(true), &automatic), SINEW_OK);
  EXPECT_TRUE(reference.same_as(automatic));
}

TEST(HandsOfASkeleton, WithoutFingersStayAsTheyAre) {
  const Skeleton before;
  MeshScene cube;
  add_cube(&cube, -0.8f, 0.8f, -0.8f, 1.6f);
  MeshScene far_away;
  add_cube(&far_away, 5, 5, 5);
  MeshScene no_faces = two_arms(true);
  no_faces.offsets = {0};
  no_faces.corners.clear();
  for (const MeshScene& scene : {two_arms(false), cube, far_away, no_faces}) {
    Skeleton s;
    ASSERT_EQ(add_hands(scene, &s), SINEW_OK);
    EXPECT_TRUE(s.same_as(before));
  }
}

TEST(HandsOfASkeleton, WithFingersAlreadyStayAsTheyAre) {
  Skeleton s;
  ASSERT_EQ(add_hands(two_arms(true), &s), SINEW_OK);
  const uint32_t count = s.outputs.joint_count;
  ASSERT_EQ(add_hands(two_arms(true), &s), SINEW_OK);
  EXPECT_EQ(s.outputs.joint_count, count);
}

TEST(HandsOfASkeleton, WhatIsWrongIsSaidAndNothingWritten) {
  const MeshScene scene = two_arms(true);
  const Skeleton before;
  const auto fails = [&](const char* what, sinew_status expected, auto change) {
    Skeleton s, untouched;
    change(s);
    change(untouched);
    EXPECT_EQ(add_hands(scene, &s), expected) << what;
    EXPECT_TRUE(s.same_as(untouched)) << what;
  };
  fails("no classes", SINEW_ERROR_ARGUMENT, [](Skeleton& s) { s.outputs.joint_classes = nullptr; });
  fails("no joint", SINEW_ERROR_COUNT, [](Skeleton& s) { s.outputs.joint_count = 0; });
  fails("too many", SINEW_ERROR_COUNT, [](Skeleton& s) { s.outputs.joint_count = SINEW_MAX_RIG_JOINTS + 1; });
  fails("a cycle", SINEW_ERROR_INDEX, [](Skeleton& s) { s.parents[2] = 3; });
  fails("a wrong partner", SINEW_ERROR_INDEX, [](Skeleton& s) { s.partners[2] = 9; });
  fails("no number", SINEW_ERROR_NOT_FINITE,
        [](Skeleton& s) { s.positions[4] = std::numeric_limits<float>::infinity(); });
  Skeleton s;
  EXPECT_EQ(add_hands(scene, &s, SINEW_INIT(sinew_rig_options), bundled_rig_model()), SINEW_ERROR_MODEL_TASK);
  EXPECT_EQ(add_hands(scene, &s, SINEW_INIT(sinew_rig_options), bundled_hands_model(), 64), SINEW_ERROR_WORKSPACE);
  sinew_rig_options options = SINEW_INIT(sinew_rig_options);
  options.progress = [](void*, uint32_t) { return 1; };
  EXPECT_EQ(add_hands(scene, &s, options), SINEW_ERROR_CANCELLED);
  EXPECT_TRUE(s.same_as(before));
  size_t bytes = 0;
  EXPECT_EQ(sinew_rig_workspace_size(bundled_hands_model(), 10, 1, 3, nullptr, &bytes), SINEW_ERROR_MODEL_TASK)
      << "bodies are not for a model of hands";
}

TEST(HandsOfASkeleton, WithoutRoomGetNone) {
  Skeleton s(false);
  while (s.outputs.joint_count < SINEW_MAX_RIG_JOINTS - 1)
    s.add("Bone" + std::to_string(s.outputs.joint_count), 0, 1, 0, 0, SINEW_CLASS_OTHER, 0, -1);
  const uint32_t count = s.outputs.joint_count;
  ASSERT_EQ(add_hands(two_arms(true), &s), SINEW_OK);
  EXPECT_EQ(s.outputs.joint_count, count);
}

sinew_status add_details(const MeshScene& scene, RigSkeleton* skeleton, uint32_t wanted,
                         const sinew_rig_options& options = SINEW_INIT(sinew_rig_options)) {
  const sinew_mesh mesh = scene.mesh_view();
  size_t bytes = 0;
  const sinew_status status = sinew_rig_details_workspace_size(
      bundled_hands_model(), mesh.vertex_count, mesh.face_count, mesh.corner_count, wanted, &options, &bytes);
  if (status != SINEW_OK) return status;
  const sinew::Workspace block(bytes);
  std::memset(block.data(), 0x5A, bytes);
  return sinew_rig_details(bundled_hands_model(), &mesh, wanted, &options, block.data(), bytes, &skeleton->outputs);
}

// A stick in one hand, beside fingers.
MeshScene armed() {
  MeshScene scene = two_arms(true);
  add_limb(&scene, {0.6, 1.38, -0.3}, {0.66, 1.44, 0.9}, 0.01, 0.01, 1);
  return scene;
}

TEST(DetailsOfASkeleton, AreThoseOfOneCallAfterAnother) {
  const MeshScene scene = armed();
  Skeleton one_by_one, together;
  for (const uint32_t wanted : {SINEW_DETAIL_HANDS, SINEW_DETAIL_FACE, SINEW_DETAIL_PROPS})
    ASSERT_EQ(add_details(scene, &one_by_one, wanted), SINEW_OK);
  ASSERT_EQ(add_details(scene, &together, SINEW_DETAIL_HANDS | SINEW_DETAIL_FACE | SINEW_DETAIL_PROPS), SINEW_OK);
  EXPECT_GE(together.fingers(), 6u);
  EXPECT_TRUE(together.same_as(one_by_one));
}

TEST(DetailsOfASkeleton, ACallThatIsStoppedInItsLastStageChangesNothing) {
  const MeshScene scene = armed();
  const Skeleton before;
  Skeleton s;
  uint32_t last = 0;
  sinew_rig_options options = SINEW_INIT(sinew_rig_options);
  options.progress = [](void* user, uint32_t permille) {
    EXPECT_GE(permille, *static_cast<uint32_t*>(user)) << "one bar for all stages";
    *static_cast<uint32_t*>(user) = permille;
    return permille > 700 ? 1 : 0;
  };
  options.progress_user = &last;
  EXPECT_EQ(add_details(scene, &s, SINEW_DETAIL_HANDS | SINEW_DETAIL_PROPS, options), SINEW_ERROR_CANCELLED);
  EXPECT_GT(last, 700u);
  EXPECT_TRUE(s.same_as(before));
  EXPECT_EQ(add_details(scene, &s, 0), SINEW_ERROR_ARGUMENT);
  EXPECT_EQ(add_details(scene, &s, 8), SINEW_ERROR_ARGUMENT);
}

TEST(OpenAModel, OfAnotherTaskSaysSo) {
  const auto file_of = [](const sinew_model* model) { return std::make_pair(model->bytes, model->size_bytes); };
  sinew_model model;
  for (const sinew_model* other : {bundled_rig_model(), bundled_hands_model()}) {
    const auto [bytes, size] = file_of(other);
    EXPECT_EQ(sinew_model_open(bytes, size, &model), SINEW_ERROR_MODEL_TASK);
  }
  const auto [bytes, size] = file_of(bundled_model());
  EXPECT_EQ(sinew_rig_model_open(bytes, size, &model), SINEW_ERROR_MODEL_TASK);
}

}  // namespace
