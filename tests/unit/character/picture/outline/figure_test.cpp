// SPDX-License-Identifier: MIT
// Figures on every kind of background, and pictures without one.
#include "sinew_character/picture/figure.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "expect_error.hpp"
#include "picture/outline/figure_parts.hpp"
#include "small_pictures.hpp"

namespace sinew::test {
namespace {

constexpr int kSide = 200;
bool in_figure(int x, int y) { return in_disc(x, y, 100, 60, 30) || (x >= 80 && x < 120 && y >= 60 && y < 170); }
bool in_rim(int x, int y) {
  for (int dy = -2; dy <= 2; ++dy)
    for (int dx = -2; dx <= 2; ++dx)
      if (!in_figure(x + dx, y + dy)) return in_figure(x, y);
  return false;
}
Rgba body_color(int x, int y) { return in_rim(x, y) ? kInk : kRed; }

TEST(FindFigure, OnAFlatColor) {
  const auto color = [](int x, int y) { return in_figure(x, y) ? body_color(x, y) : Rgba{120, 190, 230, 255}; };
  EXPECT_GT(overlap(find_figure(picture_of(kSide, kSide, color)).mask, in_figure), 0.999);
}

TEST(FindFigure, ByAlpha) {
  const auto color = [](int x, int y) { return in_figure(x, y) ? kWhite : kClear; };
  const Figure figure = find_figure(picture_of(kSide, kSide, color));
  EXPECT_EQ(figure.source, FigureSource::kAlpha);
  EXPECT_GT(overlap(figure.mask, in_figure), 0.999);
}

// Darker towards a corner, grain, a ruled line every 17 rows, a soft shadow below.
TEST(FindFigure, OnPaper) {
  uint32_t state = 1;
  const auto color = [&state](int x, int y) {
    if (in_figure(x, y)) return body_color(x, y);
    state = state * 1664525u + 1013904223u;
    double light = 240 - 0.08 * (x + y) + static_cast<double>(state >> 24) / 255 * 8 - 4;
    const double shadow = std::hypot(std::max(0, std::abs(x - 108) - 20), std::max(0, std::abs(y - 125) - 50));
    light -= 26 * std::exp(-shadow * shadow / 200);
    const double line = y % 17 == 0 ? 30 : 0;
    return Rgba{static_cast<uint8_t>(light - line), static_cast<uint8_t>(light - 0.6 * line),
                static_cast<uint8_t>(0.96 * light), 255};
  };
  EXPECT_GT(overlap(find_figure(picture_of(kSide, kSide, color)).mask, in_figure), 0.97);
}

TEST(FindFigure, BeforeSeveralColors) {
  const auto color = [](int x, int y) {
    if (in_figure(x, y)) return body_color(x, y);
    return y < 110 ? Rgba{150, 200, 250, 255} : Rgba{90, 160, 70, 255};
  };
  EXPECT_GT(overlap(find_figure(picture_of(kSide, kSide, color)).mask, in_figure), 0.99);
}

TEST(FindFigure, HolesStayOpen) {
  const auto ring = [](int x, int y) { return in_disc(x, y, 100, 100, 70) && !in_disc(x, y, 100, 100, 30); };
  const auto color = [&](int x, int y) { return ring(x, y) ? kRed : kWhite; };
  EXPECT_GT(overlap(find_figure(picture_of(kSide, kSide, color)).mask, ring), 0.999);
}

// A white face with eyes in a red body is no hole.
TEST(FindFigure, FacesAreClosed) {
  const auto color = [](int x, int y) {
    if (in_disc(x, y, 90, 60, 3) || in_disc(x, y, 110, 60, 3)) return kInk;
    if (in_disc(x, y, 100, 60, 22)) return kWhite;
    return in_figure(x, y) || in_disc(x, y, 100, 140, 50) ? kRed : kWhite;
  };
  const auto whole = [](int x, int y) { return in_figure(x, y) || in_disc(x, y, 100, 140, 50); };
  EXPECT_GT(overlap(find_figure(picture_of(kSide, kSide, color)).mask, whole), 0.999);
}

// An outline of ink on white is what it encloses, also with a gap in it.
TEST(FindFigure, OutlinesAreFilled) {
  for (const int gap : {0, 2}) {
    const auto color = [gap](int x, int y) {
      return in_rim(x, y) && !(x > 110 && y >= 120 && y < 120 + gap) ? kInk : kWhite;
    };
    EXPECT_GT(overlap(find_figure(picture_of(kSide, kSide, color)).mask, in_figure), 0.97) << gap;
  }
}

TEST(FindFigure, OnASheetOnATable) {
  const auto color = [](int x, int y) {
    if (in_figure(x, y)) return body_color(x, y);
    return x > 30 && x < 175 && y > 12 && y < 190 ? Rgba{244, 242, 236, 255} : Rgba{120, 84, 50, 255};
  };
  const Figure figure = find_figure(picture_of(kSide, kSide, color));
  EXPECT_GT(overlap(figure.mask, in_figure), 0.99);
  ASSERT_FALSE(figure.notes.empty());
  EXPECT_NE(figure.notes[0].find("sheet"), std::string::npos);
}

// An outline drawing beside other strokes, whose ink is more than it encloses.
TEST(FindFigure, OutlinesAreFilledBesideScribbles) {
  const auto ring = [](int x, int y) { return in_disc(x, y, 60, 100, 40) && !in_disc(x, y, 60, 100, 37); };
  const auto color = [&](int x, int y) {
    return ring(x, y) || (x > 110 && x < 195 && y > 20 && y < 180 && y % 10 < 5) ? kInk : kWhite;
  };
  EXPECT_GT(overlap(find_figure(picture_of(kSide, kSide, color)).mask,
                    [](int x, int y) { return in_disc(x, y, 60, 100, 40); }),
            0.97);
}

// Its edges torn: what fills so much of a picture is no figure.
TEST(FindFigure, ATornSheetIsOne) {
  const auto torn = [](uint32_t right) {
    Mask mask = {200, 200, std::vector<uint8_t>(200 * 200, 0)};
    for (uint32_t y = 5; y < 195; ++y)
      for (uint32_t x = 8 + y * 37 % 61; x < right; ++x) mask.inside[y * 200 + x] = 1;
    return mask;
  };
  EXPECT_TRUE(picture::sheet_of(torn(190)));
  EXPECT_FALSE(picture::sheet_of(torn(120)));
}

// A closed head, and a trunk whose line has a wider gap.
TEST(FindFigure, AnOutlineIsClosedPartByPart) {
  const auto ring = [](int x, int y, int cy, int r) {
    return in_disc(x, y, 200, cy, r) && !in_disc(x, y, 200, cy, r - 3);
  };
  const auto color = [&](int x, int y) {
    const bool gap = x > 250 && std::abs(y - 260) < 3;
    return ring(x, y, 90, 50) || (ring(x, y, 250, 112) && !gap) ? kInk : kWhite;
  };
  const auto body = [](int x, int y) { return in_disc(x, y, 200, 90, 50) || in_disc(x, y, 200, 250, 112); };
  EXPECT_GT(overlap(find_figure(picture_of(400, 400, color)).mask, body), 0.97);
}

TEST(FindFigure, OneOfTwo) {
  const auto left = [](int x, int y) { return in_disc(x, y, 50, 100, 30); };
  const auto right = [](int x, int y) { return in_disc(x, y, 150, 100, 40); };
  const PictureFile picture =
      picture_of(kSide, kSide, [&](int x, int y) { return left(x, y) || right(x, y) ? kRed : kWhite; });
  const Figure largest = find_figure(picture);
  EXPECT_GT(overlap(largest.mask, right), 0.99);
  EXPECT_EQ(largest.count, 2u);
  EXPECT_EQ(largest.number, 2u);
  ASSERT_EQ(largest.notes.size(), 1u);
  FigureOptions first;
  first.number = 1;
  EXPECT_GT(overlap(find_figure(picture, first).mask, left), 0.99);
  first.number = 3;
  EXPECT_ERROR(find_figure(picture, first), "picture: no figure 3", "found 2");
}

TEST(FindFigure, NothingThereIsALine) {
  EXPECT_ERROR(find_figure(picture_of(1, 1, [](int, int) { return kWhite; })), "picture: no figure found");
  EXPECT_ERROR(find_figure(picture_of(kSide, kSide, [](int, int) { return kRed; })), "picture: no figure found");
  const auto letters = [](int x, int y) {
    return x % 20 > 4 && x % 20 < 12 && y % 24 > 6 && y % 24 < 18 && x > 20 && x < 180 && y > 20 && y < 180 ? kInk
                                                                                                            : kWhite;
  };
  EXPECT_ERROR(find_figure(picture_of(kSide, kSide, letters)), "picture: no figure found", "--mask");
}

TEST(FigureOfMask, AsDrawn) {
  const PictureFile picture = picture_of(kSide, kSide, [](int, int) { return kRed; });
  const PictureFile mask =
      picture_of(kSide / 2, kSide / 2, [](int x, int y) { return in_figure(2 * x, 2 * y) ? kWhite : kInk; });
  const Figure figure = figure_of_mask(picture, mask);
  EXPECT_EQ(figure.source, FigureSource::kMask);
  EXPECT_GT(overlap(figure.mask, in_figure), 0.97);
  EXPECT_ERROR(figure_of_mask(picture, picture_of(50, 100, [](int, int) { return kWhite; })),
               "expected a mask with the size", "50 x 100");
}

// A figure's border as lines, and lines as a figure.

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
               "line 0 of the outline: expected at least three positions, found 2");
  EXPECT_ERROR(figure_of_outline(picture, {{{0, 0}, {90, 0}, {90, NAN}}}), "a position is not finite");
  EXPECT_ERROR(figure_of_outline(picture, {{{300, 300}, {400, 300}, {400, 400}}}), "no figure found");
}

}  // namespace
}  // namespace sinew::test
