// SPDX-License-Identifier: MIT
// Arms that hang against the body are cut free of it; what is free, or lies before the body, stays as it is.
#include "sinew_character/picture/free_limbs.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "sinew_character/picture/picture_mesh.hpp"

namespace sinew {
namespace {

constexpr uint32_t kSide = 200;

// A trunk of 80 pixels with an arm of 20 along its left border, a gap between them or none.
Figure figure_with_arm(uint32_t gap) {
  Figure figure;
  figure.mask = {kSide, kSide, std::vector<uint8_t>(size_t{kSide} * kSide)};
  for (uint32_t y = 20; y < 180; ++y)
    for (uint32_t x = 40; x < 140; ++x) {
      const bool in_gap = x >= 60 && x < 60 + gap && y >= 60;
      figure.mask.inside[size_t{y} * kSide + x] = y < 140 && !in_gap ? 1 : x >= 60 + gap && !in_gap ? 1 : 0;
    }
  return figure;
}

const DrawnLimb kArm = {"RightArm", {{50, 40}, {50, 80}, {50, 115}, {50, 130}}, {100, 100}};

size_t pixels(const Figure& figure) {
  return static_cast<size_t>(std::count(figure.mask.inside.begin(), figure.mask.inside.end(), uint8_t{1}));
}

// Whether one can walk inside of the figure along a row from x to the trunk.
bool joined_at(const Figure& figure, uint32_t y) {
  for (uint32_t x = 50; x < 100; ++x)
    if (!figure.mask.at(x, y)) return false;
  return true;
}

TEST(FreeLimbs, AnArmAlongTheBodyIsCutFreeFromItsFirstBoneOn) {
  Figure figure = figure_with_arm(0);
  ASSERT_EQ(free_limbs({kArm}, &figure), 1u);
  EXPECT_TRUE(joined_at(figure, 45)) << "the shoulder holds";
  for (const uint32_t y : {65u, 90u, 110u, 128u}) EXPECT_FALSE(joined_at(figure, y)) << y;
  ASSERT_EQ(figure.notes.size(), 1u);
  EXPECT_NE(figure.notes[0].find("RightArm"), std::string::npos);
  EXPECT_EQ(figure.slits.size(), 1u);
}

TEST(FreeLimbs, WhatIsFreeOrBeforeTheBodyStays) {
  Figure free = figure_with_arm(6);
  const size_t before = pixels(free);
  EXPECT_EQ(free_limbs({kArm}, &free), 0u);
  EXPECT_EQ(pixels(free), before);
  Figure folded = figure_with_arm(0);
  const DrawnLimb across = {"RightArm", {{70, 40}, {80, 80}, {120, 90}, {125, 90}}, {100, 100}};
  EXPECT_EQ(free_limbs({across}, &folded), 0u);
  EXPECT_TRUE(folded.notes.empty());
}

TEST(FreeLimbs, TheMeshHasNoGapButTwoBorders) {
  Figure figure = figure_with_arm(0);
  ASSERT_EQ(free_limbs({kArm}, &figure), 1u);
  PictureFile picture;
  picture.name = "figure";
  picture.pixels = {kSide, kSide, std::vector<uint8_t>(size_t{4} * kSide * kSide, 255)};
  Character mesh = picture_mesh(picture, figure);
  const PicturePlane plane = picture_plane(figure, mesh);
  const auto widest_gap = [&] {  // between vertices beside the slit and its line
    float widest = 0;
    for (const Vec3& v : mesh.vertices) {
      const auto at = plane.to_mask(v);
      float least = 2.2f;
      for (const auto& p : figure.slits[0]) least = std::min(least, std::hypot(p[0] - at[0], p[1] - at[1]));
      if (least < 2.2f) widest = std::max(widest, least);
    }
    return widest;
  };
  EXPECT_GT(widest_gap(), 1.0f);
  close_slits(figure, plane, &mesh);
  EXPECT_LT(widest_gap(), 0.3f);
}

}  // namespace
}  // namespace sinew
