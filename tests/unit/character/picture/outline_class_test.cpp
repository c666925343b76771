// SPDX-License-Identifier: MIT
// Outlines of bodies are told apart, in any size and facing either way.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "sinew_character/picture/body_class.hpp"

namespace sinew {
namespace {

// x to the right, y down, both 0..1.
using Shape = std::function<bool(double, double)>;

Mask drawn(const Shape& inside, uint32_t size = 200) {
  Mask mask = {size, size, std::vector<uint8_t>(size_t{size} * size)};
  for (uint32_t y = 0; y < size; ++y)
    for (uint32_t x = 0; x < size; ++x)
      mask.inside[size_t{y} * size + x] = inside((x + 0.5) / size, (y + 0.5) / size) ? 1 : 0;
  return mask;
}

bool in_disc(double x, double y, double cx, double cy, double rx, double ry) {
  return (x - cx) * (x - cx) / (rx * rx) + (y - cy) * (y - cy) / (ry * ry) < 1;
}

// Within r of the line from a to b.
bool in_limb(double x, double y, double ax, double ay, double bx, double by, double r) {
  const double dx = bx - ax, dy = by - ay;
  const double t = std::clamp(((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy), 0.0, 1.0);
  return std::hypot(x - ax - t * dx, y - ay - t * dy) < r;
}

bool person(double x, double y) {
  return in_disc(x, y, 0.5, 0.13, 0.08, 0.1) || in_limb(x, y, 0.5, 0.25, 0.5, 0.55, 0.09) ||
         in_limb(x, y, 0.5, 0.28, 0.18, 0.42, 0.035) || in_limb(x, y, 0.5, 0.28, 0.82, 0.42, 0.035) ||
         in_limb(x, y, 0.46, 0.55, 0.38, 0.93, 0.05) || in_limb(x, y, 0.54, 0.55, 0.62, 0.93, 0.05);
}

bool horse(double x, double y) {
  return in_disc(x, y, 0.45, 0.45, 0.27, 0.12) || in_limb(x, y, 0.68, 0.42, 0.82, 0.2, 0.055) ||
         in_limb(x, y, 0.82, 0.2, 0.95, 0.28, 0.045) || in_limb(x, y, 0.25, 0.5, 0.24, 0.85, 0.03) ||
         in_limb(x, y, 0.33, 0.5, 0.36, 0.85, 0.03) || in_limb(x, y, 0.58, 0.5, 0.58, 0.85, 0.03) ||
         in_limb(x, y, 0.66, 0.5, 0.7, 0.85, 0.03) || in_limb(x, y, 0.2, 0.42, 0.08, 0.6, 0.025);
}

bool fish(double x, double y) {
  const double tail = 0.25 - x;  // spreads to the left
  return in_disc(x, y, 0.6, 0.5, 0.36, 0.16) || (x > 0.04 && tail > -0.06 && std::abs(y - 0.5) < 0.03 + 0.75 * tail);
}

bool spider(double x, double y) {
  bool in = in_disc(x, y, 0.5, 0.5, 0.13, 0.13) || in_disc(x, y, 0.5, 0.66, 0.15, 0.15);
  for (const double side : {-1.0, 1.0})
    for (const double down : {-0.42, -0.15, 0.12, 0.4})
      in = in || in_limb(x, y, 0.5, 0.52, 0.5 + side * 0.26, 0.47 + down * 0.6, 0.018) ||
           in_limb(x, y, 0.5 + side * 0.26, 0.47 + down * 0.6, 0.5 + side * 0.46, 0.52 + down, 0.018);
  return in;
}

TEST(OutlineClass, BodiesAreToldApart) {
  EXPECT_EQ(class_of_outline(drawn(person)).body, BodyClass::kBiped);
  EXPECT_EQ(class_of_outline(drawn(horse)).body, BodyClass::kQuadruped);
  EXPECT_EQ(class_of_outline(drawn(fish)).body, BodyClass::kFish);
  EXPECT_EQ(class_of_outline(drawn(spider)).body, BodyClass::kManyLegged);
  EXPECT_GT(class_of_outline(drawn(person)).certainty, 0.8f);
}

TEST(OutlineClass, FacingTheOtherWayHardlyMatters) {
  for (const Shape shape : {person, horse, fish, spider}) {
    const BodyGuess one = class_of_outline(drawn(shape));
    const BodyGuess other = class_of_outline(drawn([&](double x, double y) { return shape(1 - x, y); }));
    EXPECT_EQ(one.body, other.body);
    EXPECT_NEAR(one.certainty, other.certainty, 0.05f);
  }
}

// Also of a figure in a corner of a large picture, and of one that is smaller than the cells.
TEST(OutlineClass, SizeAndPlaceHardlyMatter) {
  for (const Shape shape : {person, horse, fish}) {
    const BodyGuess one = class_of_outline(drawn(shape));
    const BodyGuess large = class_of_outline(drawn(shape, 777));
    const BodyGuess corner =
        class_of_outline(drawn([&](double x, double y) { return shape(3 * x - 2, 3 * y - 2); }, 600));
    EXPECT_EQ(one.body, large.body);
    EXPECT_NEAR(one.certainty, large.certainty, 0.1f);
    EXPECT_EQ(one.body, corner.body);
    EXPECT_NEAR(one.certainty, corner.certainty, 0.1f);
  }
  const BodyGuess dot = class_of_outline(drawn([](double, double) { return true; }, 3));
  EXPECT_GT(dot.certainty, 0.0f);
}

TEST(OutlineClass, CellsAreBytesAndTheSecondGuessIsAnother) {
  const OutlineCells full = outline_cells(drawn([](double, double) { return true; }, 48));
  for (const auto& row : full)
    for (const int32_t cell : row) EXPECT_EQ(cell, 255);
  for (const Shape shape : {person, horse, fish, spider}) {
    const BodyGuess guess = class_of_outline(drawn(shape));
    EXPECT_NE(guess.body, guess.second);
    EXPECT_LE(guess.second_certainty, guess.certainty);
    EXPECT_LE(guess.certainty + guess.second_certainty, 1.0f);
  }
}

TEST(OutlineClass, AnEmptyPictureIsNoGuess) {
  EXPECT_EQ(class_of_outline(Mask{}).certainty, 0.0f);
  EXPECT_EQ(class_of_outline(drawn([](double, double) { return false; })).certainty, 0.0f);
}

}  // namespace
}  // namespace sinew
