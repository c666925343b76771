// SPDX-License-Identifier: MIT
// A figure's border as lines, and lines as a figure.
#include <gtest/gtest.h>

#include <cmath>

#include "expect_error.hpp"
#include "sinew_character/picture/figure.hpp"
#include "small_pictures.hpp"

namespace sinew::test {
namespace {

bool in_ring(int x, int y) { return in_disc(x, y, 100, 90, 70) && !in_disc(x, y, 100, 90, 30); }
PictureFile ring(int scale) {
  const auto side = static_cast<uint32_t>(200 * scale);
  return picture_of(side, side, [scale](int x, int y) { return in_ring(x / scale, y / scale) ? kRed : kClear; });
}

TEST(Outline, ThereAndBack) {
  const PictureFile picture = ring(1);
  const Outline outline = outline_of(find_figure(picture));
  ASSERT_EQ(outline.size(), 2u) << "the border and the hole's";
  EXPECT_LT(outline[0].size(), 120u) << "few enough to be dragged";
  for (const auto& point : outline[0]) EXPECT_NEAR(std::hypot(point[0] - 100.5f, point[1] - 90.5f), 70, 1.5);
  for (const auto& point : outline[1]) EXPECT_NEAR(std::hypot(point[0] - 100.5f, point[1] - 90.5f), 30, 1.5);
  const Figure back = figure_of_outline(picture, outline);
  EXPECT_EQ(back.source, FigureSource::kMask);
  EXPECT_GT(overlap(back.mask, in_ring), 0.98);
}

// Outlines are found in a smaller picture; their points are those of the whole one.
TEST(Outline, OfALargePictureIsInItsPixels) {
  const PictureFile picture = ring(8);
  const Figure figure = find_figure(picture);
  ASSERT_EQ(figure.step, 2u);
  const Outline outline = outline_of(figure);
  for (const auto& point : outline[0]) EXPECT_NEAR(std::hypot(point[0] - 804, point[1] - 724), 560, 8);
  const auto half_size = [](int x, int y) { return in_ring(x / 4, y / 4); };
  EXPECT_GT(overlap(figure_of_outline(picture, outline).mask, half_size), 0.98);
}

TEST(Outline, MayLeaveThePicture) {
  const Outline square = {{{-50, -50}, {100, -50}, {100, 300}, {-50, 300}}};
  EXPECT_GT(overlap(figure_of_outline(ring(1), square).mask, [](int x, int) { return x < 100; }), 0.999);
}

TEST(Outline, WhatIsNoneIsALine) {
  const PictureFile picture = ring(1);
  EXPECT_ERROR(figure_of_outline(picture, {{{0, 0}, {9, 9}}}),
               "line 0 of the outline: expected three places or more, found 2");
  EXPECT_ERROR(figure_of_outline(picture, {{{0, 0}, {90, 0}, {90, NAN}}}), "a place is not finite");
  EXPECT_ERROR(figure_of_outline(picture, {{{300, 300}, {400, 300}, {400, 400}}}), "no figure found");
}

}  // namespace
}  // namespace sinew::test
