// SPDX-License-Identifier: MIT
// Joints beside a figure go into its middle; others stay.
#include "picture/joints_inside.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "sinew/rig.h"
#include "sinew_character/picture/picture_mesh.hpp"
#include "small_pictures.hpp"

namespace sinew {
namespace {

// A trunk of radius 50 with an arm, 20 wide, to the right; y runs down in pictures, up in meshes.
bool in_body(int x, int y) { return test::in_disc(x, y, 80, 100, 50) || (x >= 100 && x < 250 && y >= 90 && y < 110); }

TEST(JointsInside, WhatLiesBesideTheFigureGoesIn) {
  const PictureFile picture =
      test::picture_of(270, 200, [](int x, int y) { return in_body(x, y) ? test::kRed : test::kClear; });
  PictureMeshOptions options;
  options.pixels = true;
  const Character mesh = picture_mesh(picture, find_figure(picture), options);
  PredictedSkeleton skeleton;
  skeleton.joints = {{"Hips", {80, 100, 1}, -1, {}},
                     {"Elbow", {180, 118, 2}, 0, {}},
                     {"Hand", {256, 96, 2}, 1, {}},
                     {"Tail", {18, 100, 0}, 0, {}},
                     {"Shoulder", {150, 93, 0}, 0, {}}};
  move_joints_inside(mesh, &skeleton);
  const auto at = [&](size_t j) { return skeleton.joints[j].position; };
  EXPECT_EQ(at(0).x, 80);
  EXPECT_EQ(at(4).y, 93) << "it is inside";
  EXPECT_NEAR(at(1).x, 180, 8);
  EXPECT_NEAR(at(1).y, 100, 4) << "the middle of the arm";
  EXPECT_EQ(at(1).z, 2);
  EXPECT_LT(at(2).x, 250);
  EXPECT_GT(at(2).x, 225);
  EXPECT_NEAR(at(3).x, 80, 12) << "the middle of the trunk";
  EXPECT_NEAR(at(3).y, 100, 12);
}

// Two legs that are seen beside each other get the left and the right joint.

// A card with both sides, of rectangles {left, bottom, right, top} that touch at nothing.
Character cards(const std::vector<std::array<float, 4>>& rectangles) {
  Character mesh;
  for (const auto& [left, bottom, right, top] : rectangles) {
    const auto first = static_cast<uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), {{left, bottom, 0}, {right, bottom, 0}, {right, top, 0}, {left, top, 0}});
    for (const std::array<uint32_t, 4>& face :
         {std::array<uint32_t, 4>{0, 1, 2, 3}, std::array<uint32_t, 4>{3, 2, 1, 0}}) {
      for (const uint32_t corner : face) mesh.face_vertices.push_back(first + corner);
      mesh.face_offsets.push_back(static_cast<uint32_t>(mesh.face_vertices.size()));
    }
  }
  return mesh;
}

PredictedSkeleton feet(float x) {
  PredictedSkeleton out;
  out.joints = {{"LeftFoot", {x, 0.1f, 0}, -1, {}}, {"RightFoot", {x, 0.1f, 0}, -1, {}}};
  out.classes = {SINEW_CLASS_FOOT, SINEW_CLASS_FOOT};
  out.ends = {0, 0};
  return out;
}

TEST(SideLimbs, EachLegHasItsJoint) {
  const Character mesh =
      cards({{0, 0.5f, 1, 1}, {0.1f, 0, 0.15f, 0.4f}, {0.2f, 0, 0.25f, 0.4f}, {0.8f, 0, 0.85f, 0.4f}});
  PredictedSkeleton two = feet(0.17f);
  part_side_limbs(mesh, &two);
  EXPECT_FLOAT_EQ(two.joints[0].position.x, 0.125f);
  EXPECT_FLOAT_EQ(two.joints[1].position.x, 0.225f);
  PredictedSkeleton one = feet(0.82f);
  part_side_limbs(mesh, &one);
  EXPECT_FLOAT_EQ(one.joints[0].position.x, 0.82f);
  EXPECT_FLOAT_EQ(one.joints[1].position.x, 0.82f);
}

TEST(SideLimbs, ALegDoesNotFork) {
  PredictedSkeleton forked;
  forked.joints = {{"Hips", {}, -1, {}},    {"LeftUpLeg", {}, 0, {}},    {"LeftLeg", {}, 1, {}},
                   {"LeftFoot", {}, 2, {}}, {"LeftFoot_end", {}, 3, {}}, {"LeftLeg1", {}, 2, {}},
                   {"Tail", {}, 0, {}}};
  forked.classes = {SINEW_CLASS_PELVIS, SINEW_CLASS_THIGH, SINEW_CLASS_CALF, SINEW_CLASS_FOOT,
                    SINEW_CLASS_FOOT,   SINEW_CLASS_CALF,  SINEW_CLASS_TAIL};
  forked.ends = {0, 0, 0, 0, 1, 0, 0};
  forked.partners = {0, -1, -1, -1, -1, -1, 6};
  forked.confidence = forked.parent_confidence = std::vector<float>(7, 1.0f);
  take_forks_off(&forked);
  ASSERT_EQ(forked.joints.size(), 6u);
  EXPECT_EQ(forked.joints[3].name, "LeftFoot");
  EXPECT_EQ(forked.joints[5].name, "Tail");
  EXPECT_EQ(forked.joints[5].parent, 0);
  EXPECT_EQ(forked.partners[5], 5);
}

}  // namespace
}  // namespace sinew
