// SPDX-License-Identifier: MIT
// sinew_rig_details() of faces: eyes where loose balls are, the jaw behind and below them, and nothing without eyes.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include "ball_scene.hpp"

namespace sinew::rigging {
namespace {

using sinew_test::add_ball;
using sinew_test::add_cube;
using sinew_test::MeshScene;
using sinew_test::RigSkeleton;

using Point = std::array<float, 3>;

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

struct HeadSkeleton : RigSkeleton {
  explicit HeadSkeleton(bool mirrored = true) {
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
                      sinew_rig_options options = SINEW_INIT(sinew_rig_options), size_t missing = 0) {
  return add_details(scene, SINEW_DETAIL_FACE, skeleton, options, missing);
}

void expect_near(const Point& p, const Point& q, float distance, const std::string& what) {
  EXPECT_LE(std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]), distance)
      << what << " at " << p[0] << " " << p[1] << " " << p[2];
}

TEST(FaceOfASkeleton, GetsEyesInTheirBallsAndAJawBehind) {
  HeadSkeleton s;
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
    HeadSkeleton s(false);
    ASSERT_EQ(add_face(with_eyes(cut), &s), SINEW_OK);
    ASSERT_EQ(s.outputs.joint_count, 8u) << cut;
    expect_near(s.at(4), {kEyeX, kEyeY, kEyeZ}, 0.2f * kEye, "left eye");
    expect_near(s.at(5), {-kEyeX, kEyeY, kEyeZ}, 0.2f * kEye, "right eye");
    EXPECT_EQ(s.partners[4], -1) << "nothing is mirrored";
  }
}

TEST(FaceOfASkeleton, IsTheSameWhereverItFacesAndWhateverPointsUp) {
  HeadSkeleton first;
  ASSERT_EQ(add_face(with_eyes(), &first), SINEW_OK);
  const auto expect_same = [&](const char* what, uint32_t quarters, uint32_t up, auto turn) {
    MeshScene scene = with_eyes();
    HeadSkeleton s;
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
  const HeadSkeleton before;
  const auto expect_none = [&](const char* what, const MeshScene& scene) {
    HeadSkeleton s;
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
  HeadSkeleton headless;
  headless.classes[2] = headless.classes[3] = SINEW_CLASS_SPINE;
  ASSERT_EQ(add_face(with_eyes(), &headless), SINEW_OK);
  EXPECT_EQ(headless.outputs.joint_count, 4u);
}

// A chin is looked for in the surface in front of the jaw, where a head that stands has one.
TEST(FaceOfASkeleton, HasNoJawWhereThereIsNoChin) {
  MeshScene chinless;
  add_cube(&chinless, -0.75f, 0, -0.75f, 1.5f);
  add_ball(&chinless, {0, 1.75f, 0}, {0.08f, 0.07f, 0.1f});  // ends above where a chin would be
  for (const float side : {1.0f, -1.0f}) add_ball(&chinless, {side * kEyeX, 1.72f, kEyeZ}, {kEye, kEye, kEye});
  HeadSkeleton s;
  ASSERT_EQ(add_face(chinless, &s), SINEW_OK);
  ASSERT_EQ(s.outputs.joint_count, 6u);
  EXPECT_EQ(s.classes[5], SINEW_CLASS_EYE);
  // An animal's, whose neck goes forwards.
  HeadSkeleton lying;
  lying.positions[4] = 1.6f;
  lying.positions[5] = -0.3f;
  ASSERT_EQ(add_face(with_eyes(), &lying), SINEW_OK);
  ASSERT_EQ(lying.outputs.joint_count, 6u);
  EXPECT_EQ(lying.classes[5], SINEW_CLASS_EYE);
}

TEST(FaceOfASkeleton, OfTwoPairsTheOneInFrontAreTheEyes) {
  for (const bool front_first : {false, true}) {
    MeshScene scene = person();
    for (const bool front : {front_first, !front_first})
      for (const float side : {1.0f, -1.0f})  // the others are ears' rings, say
        add_ball(&scene, {side * (front ? kEyeX : 0.045f), kEyeY, front ? kEyeZ : 0.03f}, {kEye, kEye, kEye});
    HeadSkeleton s;
    ASSERT_EQ(add_face(scene, &s), SINEW_OK);
    ASSERT_GE(s.outputs.joint_count, 6u);
    expect_near(s.at(4), {kEyeX, kEyeY, kEyeZ}, 1e-4f, front_first ? "front first" : "front last");
  }
}

TEST(FaceOfASkeleton, IsOneForEachHead) {
  MeshScene scene;
  HeadSkeleton s(false);
  s.outputs.joint_count = 0;
  s.add("Hips", 0, 1, 0, -1, SINEW_CLASS_PELVIS, 0, -1);
  add_cube(&scene, -0.75f, 0, -0.75f, 1.5f);
  for (const float x : {0.3f, -0.3f}) {
    add_ball(&scene, {x, 1.65f, 0}, {0.08f, 0.13f, 0.1f});
    for (const float side : {1.0f, -1.0f}) add_ball(&scene, {x + side * kEyeX, kEyeY, kEyeZ}, {kEye, kEye, kEye});
    const int neck = static_cast<int>(s.outputs.joint_count);
    s.add("Neck", x, 1.5f, 0, 0, SINEW_CLASS_NECK, 0, -1);
    s.add("Head", x, 1.6f, 0, neck, SINEW_CLASS_HEAD, 0, -1);
    s.add("Head_end", x, 1.78f, 0, neck + 1, SINEW_CLASS_HEAD, SINEW_JOINT_NEVER, -1);
  }
  ASSERT_EQ(add_face(scene, &s), SINEW_OK);
  ASSERT_EQ(s.outputs.joint_count, 15u);
  expect_near(s.at(7), {0.3f + kEyeX, kEyeY, kEyeZ}, 1e-4f, "the first head's left eye");
  expect_near(s.at(11), {-0.3f + kEyeX, kEyeY, kEyeZ}, 1e-4f, "the second one's");
  EXPECT_EQ(s.parents[7], 2);
  EXPECT_EQ(s.parents[11], 5);
  EXPECT_NE(s.name(7), s.name(11));
}

TEST(FaceOfASkeleton, IsAddedOnceAndNamedAnew) {
  HeadSkeleton s;
  std::strcpy(s.outputs.names[1], "LeftEye");
  ASSERT_EQ(add_face(with_eyes(), &s), SINEW_OK);
  EXPECT_EQ(s.name(4), "LeftEye1");
  ASSERT_EQ(s.outputs.joint_count, 8u);
  ASSERT_EQ(add_face(with_eyes(), &s), SINEW_OK);
  EXPECT_EQ(s.outputs.joint_count, 8u);
  HeadSkeleton full;
  while (full.outputs.joint_count < SINEW_MAX_RIG_JOINTS - 3)
    full.add("Bone" + std::to_string(full.outputs.joint_count), 0, 1, 0, 0, SINEW_CLASS_OTHER, 0, -1);
  ASSERT_EQ(add_face(with_eyes(), &full), SINEW_OK);
  EXPECT_EQ(full.outputs.joint_count, SINEW_MAX_RIG_JOINTS - 3) << "no room";
}

TEST(FaceOfASkeleton, WhatIsWrongIsSaidAndNothingWritten) {
  const MeshScene scene = with_eyes();
  const auto fails = [&](const char* what, sinew_status expected, auto change) {
    HeadSkeleton s, untouched;
    change(s);
    change(untouched);
    EXPECT_EQ(add_face(scene, &s), expected) << what;
    EXPECT_TRUE(s.same_as(untouched)) << what;
  };
  fails("no classes", SINEW_ERROR_ARGUMENT, [](HeadSkeleton& s) { s.outputs.joint_classes = nullptr; });
  fails("no joint", SINEW_ERROR_COUNT, [](HeadSkeleton& s) { s.outputs.joint_count = 0; });
  fails("a cycle", SINEW_ERROR_INDEX, [](HeadSkeleton& s) { s.parents[1] = 2; });
  fails("a wrong partner", SINEW_ERROR_INDEX, [](HeadSkeleton& s) { s.partners[2] = 9; });
  fails("no number", SINEW_ERROR_NOT_FINITE,
        [](HeadSkeleton& s) { s.positions[4] = std::numeric_limits<float>::infinity(); });
  const HeadSkeleton before;
  HeadSkeleton s;
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

}  // namespace
}  // namespace sinew::rigging
