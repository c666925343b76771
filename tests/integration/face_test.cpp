// SPDX-License-Identifier: MIT
// sinew_rig_details() of faces and props: eyes where loose balls are, the jaw behind and below them, and nothing where there are none.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include "mesh_scene.hpp"
#include "rig_skeleton.hpp"
#include "sinew/sinew.hpp"

namespace {

using sinew_test::add_cube;
using sinew_test::cube_sphere;
using sinew_test::MeshScene;
using sinew_test::RigSkeleton;

using Point = std::array<float, 3>;

// An ellipsoid; its vertices behind `cut` along z (of the unit ball) are left out with their faces.
void add_ball(MeshScene* scene, const Point& at, const Point& radius, float cut = -2) {
  const MeshScene ball = cube_sphere(6);
  const uint32_t first = scene->vertex_count();
  for (uint32_t v = 0; v < ball.vertex_count(); ++v) {
    const float* const p = &ball.positions[size_t{3} * v];
    scene->add_vertex(at[0] + radius[0] * p[0], at[1] + radius[1] * p[1], at[2] + radius[2] * std::max(p[2], cut));
  }
  for (size_t f = 0; f + 1 < ball.offsets.size(); ++f) {
    std::vector<uint32_t> face;
    bool kept = true;
    for (uint32_t c = ball.offsets[f]; c < ball.offsets[f + 1]; ++c) {
      face.push_back(first + ball.corners[c]);
      kept = kept && ball.positions[size_t{3} * ball.corners[c] + 2] >= cut;
    }
    if (kept) scene->add_face(face);
  }
}

constexpr float kEyeX = 0.032f, kEyeY = 1.69f, kEyeZ = 0.08f, kEye = 0.012f;

// A trunk from 0 to 1.5 and a head around (0, 1.66, 0), 0.2 high.
MeshScene person() {
  MeshScene scene;
  add_cube(&scene, -0.75f, 0, -0.75f, 1.5f);
  add_ball(&scene, {0, 1.65f, 0}, {0.08f, 0.13f, 0.1f});
  return scene;
}
MeshScene with_eyes(float cut = -2) {
  MeshScene scene = person();
  for (const float side : {1.0f, -1.0f}) add_ball(&scene, {side * kEyeX, kEyeY, kEyeZ}, {kEye, kEye, kEye}, cut);
  return scene;
}

struct Skeleton : RigSkeleton {
  explicit Skeleton(bool mirrored = true) {
    const auto self = [&](int j) { return mirrored ? j : -1; };
    outputs.mirrored = mirrored ? 1 : 0;
    add("Hips", 0, 1, 0, -1, SINEW_CLASS_PELVIS, 0, self(0));
    add("Neck", 0, 1.5f, 0, 0, SINEW_CLASS_NECK, 0, self(1));
    add("Head", 0, 1.6f, 0, 1, SINEW_CLASS_HEAD, 0, self(2));
    add("Head_end", 0, 1.78f, 0, 2, SINEW_CLASS_HEAD, SINEW_JOINT_NEVER, self(3));
  }
  Point at(uint32_t j) const { return {positions[3 * j], positions[3 * j + 1], positions[3 * j + 2]}; }
};

sinew_status add_face(const MeshScene& scene, RigSkeleton* skeleton,
                      sinew_rig_options options = SINEW_INIT(sinew_rig_options), size_t missing = 0,
                      uint32_t wanted = SINEW_DETAIL_FACE) {
  const sinew_mesh mesh = scene.mesh_view();
  size_t bytes = 0;
  const sinew_status status = sinew_rig_details_workspace_size(nullptr, mesh.vertex_count, mesh.face_count,
                                                               mesh.corner_count, wanted, &options, &bytes);
  if (status != SINEW_OK) return status;
  const sinew::Workspace block(bytes);
  std::memset(block.data(), 0x5A, bytes);
  return sinew_rig_details(nullptr, &mesh, wanted, &options, block.data(), missing > bytes ? 0 : bytes - missing,
                           &skeleton->outputs);
}

void expect_near(const Point& p, const Point& q, float distance, const std::string& what) {
  EXPECT_LE(std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]), distance)
      << what << " at " << p[0] << " " << p[1] << " " << p[2];
}

TEST(FaceOfASkeleton, GetsEyesInTheirBallsAndAJawBehind) {
  Skeleton s;
  ASSERT_EQ(add_face(with_eyes(), &s), SINEW_OK);
  ASSERT_EQ(s.outputs.joint_count, 8u);
  EXPECT_EQ(s.name(4), "LeftEye");
  EXPECT_EQ(s.name(5), "RightEye");
  EXPECT_EQ(s.name(6), "Jaw");
  EXPECT_EQ(s.name(7), "Jaw_end");
  expect_near(s.at(4), {kEyeX, kEyeY, kEyeZ}, 1e-4f, "left eye");
  EXPECT_EQ(s.at(5), (Point{-s.at(4)[0], s.at(4)[1], s.at(4)[2]})) << "exactly mirrored";
  EXPECT_EQ(s.at(6)[0], 0);
  EXPECT_LT(s.at(6)[1], kEyeY - 0.03f);
  EXPECT_LT(s.at(6)[2], kEyeZ - 0.04f);
  EXPECT_EQ(s.at(7)[0], 0);
  EXPECT_LT(s.at(7)[1], s.at(6)[1]) << "the chin is lower";
  EXPECT_GT(s.at(7)[2], s.at(6)[2]) << "and further in front";
  const std::vector<int32_t> parents(s.parents.begin() + 4, s.parents.begin() + 8);
  const std::vector<int32_t> partners(s.partners.begin() + 4, s.partners.begin() + 8);
  EXPECT_EQ(parents, (std::vector<int32_t>{2, 2, 2, 6}));
  EXPECT_EQ(partners, (std::vector<int32_t>{5, 4, 6, 7}));
  EXPECT_EQ(s.flags[6], 0);
  EXPECT_EQ(s.flags[7], SINEW_JOINT_NEVER);
  EXPECT_EQ(s.classes[4], SINEW_CLASS_EYE);
  EXPECT_EQ(s.classes[7], SINEW_CLASS_JAW);
  EXPECT_GT(s.confidence[4], s.confidence[6]);
}

TEST(FaceOfASkeleton, TakesABallWithoutItsBackForAWholeOne) {
  for (const float cut : {0.1f, -0.1f, 0.5f}) {
    Skeleton s(false);
    ASSERT_EQ(add_face(with_eyes(cut), &s), SINEW_OK);
    ASSERT_EQ(s.outputs.joint_count, 8u) << cut;
    expect_near(s.at(4), {kEyeX, kEyeY, kEyeZ}, 0.2f * kEye, "left eye");
    expect_near(s.at(5), {-kEyeX, kEyeY, kEyeZ}, 0.2f * kEye, "right eye");
    EXPECT_EQ(s.partners[4], -1) << "nothing is mirrored";
  }
}

TEST(FaceOfASkeleton, IsTheSameWhereverItFacesAndWhateverPointsUp) {
  Skeleton first;
  ASSERT_EQ(add_face(with_eyes(), &first), SINEW_OK);
  const auto expect_same = [&](const char* what, uint32_t quarters, uint32_t up, auto turn) {
    MeshScene scene = with_eyes();
    Skeleton s;
    for (size_t v = 0; v < scene.positions.size(); v += 3) turn(&scene.positions[v]);
    for (uint32_t j = 0; j < s.outputs.joint_count; ++j) turn(&s.positions[size_t{3} * j]);
    s.outputs.facing = quarters;
    sinew_rig_options options = SINEW_INIT(sinew_rig_options);
    options.up = up;
    ASSERT_EQ(add_face(scene, &s, options), SINEW_OK) << what;
    ASSERT_EQ(s.outputs.joint_count, 8u) << what;
    for (uint32_t j = 4; j < 8; ++j) {
      Point expected = first.at(j);
      turn(expected.data());
      expect_near(s.at(j), expected, 1e-4f, what + (" " + s.name(j)));
    }
  };
  expect_same("facing +x", 1, SINEW_UP_AUTO, [](float* p) {
    const float x = p[0];
    p[0] = p[2];
    p[2] = -x;
  });
  expect_same("facing -z", 2, SINEW_UP_AUTO, [](float* p) {
    p[0] = -p[0];
    p[2] = -p[2];
  });
  expect_same("Z up", 0, SINEW_UP_Z, [](float* p) {
    const float y = p[1];
    p[1] = -p[2];
    p[2] = y;
  });
}

TEST(FaceOfASkeleton, WithoutEyesStaysAsItIs) {
  const Skeleton before;
  const auto expect_none = [&](const char* what, const MeshScene& scene) {
    Skeleton s;
    ASSERT_EQ(add_face(scene, &s), SINEW_OK) << what;
    EXPECT_TRUE(s.same_as(before)) << what;
  };
  expect_none("no parts", person());
  MeshScene one = person();
  add_ball(&one, {kEyeX, kEyeY, kEyeZ}, {kEye, kEye, kEye});
  expect_none("one ball", one);
  MeshScene glasses = person(), two_sizes = one, behind = person(), buttons = person(), skew = one;
  for (const float side : {1.0f, -1.0f}) {
    add_ball(&glasses, {side * kEyeX, kEyeY, 0.12f}, {0.02f, 0.02f, 0.002f});
    add_ball(&behind, {side * kEyeX, kEyeY, -0.1f}, {kEye, kEye, kEye});
    add_ball(&buttons, {side * kEyeX, 1.2f, 0.75f}, {kEye, kEye, kEye});
  }
  add_ball(&two_sizes, {-kEyeX, kEyeY, kEyeZ}, {0.02f, 0.02f, 0.02f});
  add_ball(&skew, {-kEyeX, kEyeY + 0.02f, kEyeZ}, {kEye, kEye, kEye});
  expect_none("glasses", glasses);
  expect_none("two sizes", two_sizes);
  expect_none("beads behind", behind);
  expect_none("buttons", buttons);
  expect_none("one higher", skew);
  MeshScene points = with_eyes();
  points.offsets = {0};
  points.corners.clear();
  expect_none("no faces", points);
  Skeleton headless;
  headless.classes[2] = headless.classes[3] = SINEW_CLASS_SPINE;
  ASSERT_EQ(add_face(with_eyes(), &headless), SINEW_OK);
  EXPECT_EQ(headless.outputs.joint_count, 4u);
}

TEST(FaceOfASkeleton, IsAddedOnceAndNamedAnew) {
  Skeleton s;
  std::strcpy(s.outputs.names[1], "LeftEye");
  ASSERT_EQ(add_face(with_eyes(), &s), SINEW_OK);
  EXPECT_EQ(s.name(4), "LeftEye1");
  ASSERT_EQ(s.outputs.joint_count, 8u);
  ASSERT_EQ(add_face(with_eyes(), &s), SINEW_OK);
  EXPECT_EQ(s.outputs.joint_count, 8u);
  Skeleton full;
  while (full.outputs.joint_count < SINEW_MAX_RIG_JOINTS - 3)
    full.add("Bone" + std::to_string(full.outputs.joint_count), 0, 1, 0, 0, SINEW_CLASS_OTHER, 0, -1);
  ASSERT_EQ(add_face(with_eyes(), &full), SINEW_OK);
  EXPECT_EQ(full.outputs.joint_count, SINEW_MAX_RIG_JOINTS - 3) << "no room";
}

TEST(FaceOfASkeleton, WhatIsWrongIsSaidAndNothingWritten) {
  const MeshScene scene = with_eyes();
  const auto fails = [&](const char* what, sinew_status expected, auto change) {
    Skeleton s, untouched;
    change(s);
    change(untouched);
    EXPECT_EQ(add_face(scene, &s), expected) << what;
    EXPECT_TRUE(s.same_as(untouched)) << what;
  };
  fails("no classes", SINEW_ERROR_ARGUMENT, [](Skeleton& s) { s.outputs.joint_classes = nullptr; });
  fails("no joint", SINEW_ERROR_COUNT, [](Skeleton& s) { s.outputs.joint_count = 0; });
  fails("a cycle", SINEW_ERROR_INDEX, [](Skeleton& s) { s.parents[1] = 2; });
  fails("a wrong partner", SINEW_ERROR_INDEX, [](Skeleton& s) { s.partners[2] = 9; });
  fails("no number", SINEW_ERROR_NOT_FINITE,
        [](Skeleton& s) { s.positions[4] = std::numeric_limits<float>::infinity(); });
  const Skeleton before;
  Skeleton s;
  EXPECT_EQ(add_face(scene, &s, SINEW_INIT(sinew_rig_options), 64), SINEW_ERROR_WORKSPACE);
  sinew_rig_options options = SINEW_INIT(sinew_rig_options);
  options.progress = [](void*, uint32_t) { return 1; };
  EXPECT_EQ(add_face(scene, &s, options), SINEW_ERROR_CANCELLED);
  options = SINEW_INIT(sinew_rig_options);
  options.up = SINEW_UP_X;
  EXPECT_EQ(add_face(scene, &s, options), SINEW_ERROR_ARGUMENT);
  MeshScene broken = scene;
  broken.positions[7] = std::numeric_limits<float>::infinity();
  EXPECT_EQ(add_face(broken, &s), SINEW_ERROR_NOT_FINITE);
  EXPECT_TRUE(s.same_as(before));
  size_t bytes = 1;
  EXPECT_EQ(sinew_rig_details_workspace_size(nullptr, 0, 0, 0, SINEW_DETAIL_FACE, nullptr, &bytes), SINEW_ERROR_COUNT);
  EXPECT_EQ(bytes, 0u);
}

// An arm of one part along x from 0.2: the wrist is at 0.6, the hand ends at 0.72.
MeshScene arm() {
  MeshScene scene;
  add_ball(&scene, {0.46f, 1.4f, 0}, {0.26f, 0.04f, 0.04f});
  return scene;
}

struct ArmSkeleton : RigSkeleton {
  ArmSkeleton() {
    add("Hips", 0, 1, 0, -1, SINEW_CLASS_PELVIS, 0, -1);
    add("LeftForeArm", 0.35f, 1.4f, 0, 0, SINEW_CLASS_FOREARM, 0, -1);
    add("LeftHand", 0.6f, 1.4f, 0, 1, SINEW_CLASS_HAND, 0, -1);
    add("LeftHand_end", 0.72f, 1.4f, 0, 2, SINEW_CLASS_HAND, SINEW_JOINT_NEVER, -1);
  }
};

sinew_status add_props(const MeshScene& scene, RigSkeleton* skeleton,
                       sinew_rig_options options = SINEW_INIT(sinew_rig_options), size_t missing = 0) {
  return add_face(scene, skeleton, options, missing, SINEW_DETAIL_PROPS);
}

TEST(PropsOfASkeleton, AreJointsOfWhatAHandHolds) {
  MeshScene scene = arm();
  add_ball(&scene, {0.66f, 1.4f, 0.15f}, {0.012f, 0.012f, 0.2f});  // a stick
  add_ball(&scene, {0.66f, 1.4f, 0.4f}, {0.03f, 0.005f, 0.1f});    // and its blade, too far away for itself
  ArmSkeleton s;
  ASSERT_EQ(add_props(scene, &s), SINEW_OK);
  ASSERT_EQ(s.outputs.joint_count, 6u);
  EXPECT_EQ(s.name(4), "LeftHandProp");
  EXPECT_EQ(s.name(5), "LeftHandProp_end");
  EXPECT_EQ(s.parents[4], 2);
  EXPECT_EQ(s.parents[5], 4);
  EXPECT_EQ(s.flags[4], 0);
  EXPECT_EQ(s.flags[5], SINEW_JOINT_NEVER);
  EXPECT_EQ(s.classes[5], SINEW_CLASS_PROP);
  EXPECT_EQ(s.partners[4], -1);
  EXPECT_NEAR(s.positions[12], 0.66f, 0.02f);
  EXPECT_NEAR(s.positions[14], 0, 0.06f) << "where the hand grips it";
  EXPECT_NEAR(s.positions[17], 0.35f, 0.01f) << "where it ends";
  ASSERT_EQ(add_props(scene, &s), SINEW_OK);
  EXPECT_EQ(s.outputs.joint_count, 6u) << "once";
}

TEST(PropsOfASkeleton, AreNoSleevesGlovesOrFingers) {
  const ArmSkeleton before;
  const auto expect_none = [&](const char* what, const MeshScene& scene) {
    ArmSkeleton s;
    ASSERT_EQ(add_props(scene, &s), SINEW_OK) << what;
    EXPECT_TRUE(s.same_as(before)) << what;
  };
  MeshScene bare = arm(), sleeve = arm(), glove = arm(), belt = arm(), fingers = arm(), claw;
  expect_none("bare", bare);
  add_ball(&sleeve, {0.45f, 1.4f, 0}, {0.27f, 0.06f, 0.06f});
  expect_none("sleeve", sleeve);
  add_ball(&glove, {0.66f, 1.4f, 0}, {0.07f, 0.05f, 0.05f});
  expect_none("glove", glove);
  add_ball(&belt, {0, 1, 0}, {0.2f, 0.02f, 0.2f});
  expect_none("belt", belt);
  for (int f = 0; f < 4; ++f)
    add_ball(&fingers, {0.8f, 1.4f, 0.03f * static_cast<float>(f) - 0.045f}, {0.15f, 0.01f, 0.01f});
  expect_none("fingers", fingers);
  add_ball(&claw, {0.3f, 1.4f, 0}, {0.25f, 0.04f, 0.04f});  // ends before the wrist: the other part is the hand
  add_ball(&claw, {0.75f, 1.4f, 0}, {0.14f, 0.03f, 0.03f});
  expect_none("a hand that is a part itself", claw);
}

TEST(PropsOfASkeleton, WhatIsWrongIsSaidAndNothingWritten) {
  MeshScene scene = arm();
  add_ball(&scene, {0.66f, 1.4f, 0.15f}, {0.012f, 0.012f, 0.2f});
  const ArmSkeleton before;
  ArmSkeleton s;
  EXPECT_EQ(add_props(scene, &s, SINEW_INIT(sinew_rig_options), SIZE_MAX), SINEW_ERROR_WORKSPACE);
  sinew_rig_options options = SINEW_INIT(sinew_rig_options);
  options.progress = [](void*, uint32_t) { return 1; };
  EXPECT_EQ(add_props(scene, &s, options), SINEW_ERROR_CANCELLED);
  EXPECT_TRUE(s.same_as(before));
  s.outputs.joint_count = SINEW_MAX_RIG_JOINTS + 1;
  EXPECT_EQ(add_props(scene, &s), SINEW_ERROR_COUNT);
}

}  // namespace
