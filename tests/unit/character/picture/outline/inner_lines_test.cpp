// SPDX-License-Identifier: MIT
// Figures that overlap themselves, cut open along the lines that are drawn into them.
#include <gtest/gtest.h>

#include "picture/outline/raster.hpp"
#include "small_pictures.hpp"

namespace sinew::test {
namespace {

constexpr int kWide = 400;
// A head on a trunk, the trunk's outline in ink; what is drawn inside is up to the test.
bool in_person(int x, int y) { return in_disc(x, y, 200, 70, 50) || (x >= 120 && x < 280 && y >= 100 && y < 380); }
bool on(int at, int line) { return at >= line - 2 && at <= line + 2; }
bool in_line(int x, int y) { return y >= 100 && (x < 125 || x >= 275 || y >= 375); }
bool in_arm_line(int x, int y) { return (on(x, 160) || on(x, 240)) && y >= 180 && y < 380; }

template <typename Ink>
Figure cut(const Ink& ink) {
  FigureOptions options;
  options.cut = true;
  return find_figure(picture_of(kWide, kWide,
                                [&](int x, int y) {
                                  if (!in_person(x, y)) return kWhite;
                                  return in_line(x, y) || ink(x, y) ? kInk : Rgba{240, 200, 120, 255};
                                }),
                     options);
}

TEST(InnerLines, ArmsAlongTheTrunkAreCutFree) {
  const Figure figure = cut([](int x, int y) { return in_arm_line(x, y) || (on(y, 300) && x > 160 && x < 240); });
  for (const int line : {160, 240})
    for (const int y : {190, 290, 379}) {
      int clear = 0;
      for (int x = line - 8; x <= line + 8; ++x) clear += figure.mask.at(x, y) ? 0 : 1;
      EXPECT_GE(clear, 2) << line << " " << y;
      EXPECT_LE(clear, 5) << line << " " << y;
    }
  EXPECT_TRUE(figure.mask.at(160, 150)) << "the arm hangs on its shoulder";
  for (const int x : {170, 200, 230}) EXPECT_TRUE(figure.mask.at(x, 300)) << "the belt is cut at " << x;
  EXPECT_EQ(picture::parts_of(figure.mask, true).sizes.size(), 1u);
  EXPECT_EQ(figure.notes.back().rfind("2 lines", 0), 0u) << figure.notes.back();
}

TEST(InnerLines, ALineFromBorderToBorderOrWithinIsNone) {
  for (const bool across : {true, false}) {
    const Figure figure =
        cut([across](int x, int y) { return across ? on(y, 200) : on(y, 200) && x > 150 && x < 250; });
    EXPECT_GT(overlap(figure.mask, in_person), 0.999) << across;
    EXPECT_NE(figure.notes.back().find("nothing was cut"), std::string::npos);
  }
}

TEST(InnerLines, NothingIsCutUnasked) {
  const Figure figure = find_figure(picture_of(kWide, kWide, [](int x, int y) {
    return !in_person(x, y) ? kWhite : in_line(x, y) || in_arm_line(x, y) ? kInk : Rgba{240, 200, 120, 255};
  }));
  EXPECT_GT(overlap(figure.mask, in_person), 0.999);
  EXPECT_TRUE(figure.notes.empty());
}

}  // namespace
}  // namespace sinew::test
