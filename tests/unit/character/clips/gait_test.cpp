// SPDX-License-Identifier: MIT
// Files of gaits/: what their lines say, sums of waves, curves and couplings, and errors with the line.
#include "clips/gait.hpp"

#include <gtest/gtest.h>

#include <string>

#include "expect_error.hpp"

namespace sinew::clips {
namespace {

constexpr const char* kText =
    "# a comment\nkind cat quadruped\nlet sway is 1~1\n\nclip stroll frames 20\nlet sway is 2\n"
    "turn Tail1..3.L later .1 x 3 2*sway@.25 y 0:0 .5:10\n";

TEST(Gait, LinesHaveNamesAndValues) {
  const std::vector<Block> blocks = read_gaits("cat.txt", kText);
  ASSERT_EQ(blocks.size(), 2u);
  EXPECT_EQ(blocks[0].head.names, (std::vector<std::string>{"cat", "quadruped"}));
  EXPECT_EQ(blocks[1].head.number("frames", 0), 20);
  EXPECT_EQ(blocks[1].head.number("travel", 7), 7) << "not given";
  const Line& turn = blocks[1].lines.at(1);
  EXPECT_EQ(turn.names, (std::vector<std::string>{"Tail1.L", "Tail2.L", "Tail3.L"}));
  EXPECT_EQ(turn.find("z"), nullptr);
  EXPECT_EQ(turn.find("x")->terms.at(1).signal, "sway");
  EXPECT_EQ(turn.find("y")->keys.size(), 2u);
}

double value(const std::string& sum, double phase, const std::string& variant = "") {
  const std::vector<Block> blocks =
      read_gaits("test", "clip c\nlet w is 1~1\nlet late is 2*w@.25 1\nlet total is " + sum + "\n" + variant);
  Signals signals;
  signals.add(blocks[0].lines);
  signals.vary(blocks[0].lines);
  return signals.value(*blocks[0].lines.at(2).find("is"), phase);
}

TEST(Gait, SumsAreWavesArcsCurvesAndCouplings) {
  EXPECT_DOUBLE_EQ(value("3", 0.4), 3);
  EXPECT_NEAR(value("2~1", 0.25), 2, 1e-12);
  EXPECT_NEAR(value("2~3@.25", 0.25), 0, 1e-12) << "later by a share of the cycle, whatever its own";
  EXPECT_NEAR(value("1*late", 0.5), 3, 1e-12) << "a coupling of a coupling";
  EXPECT_NEAR(value("1*late@.5", 0), 3, 1e-12);
  EXPECT_DOUBLE_EQ(value("4^.25:.75", 0.5), 4);
  EXPECT_DOUBLE_EQ(value("4^.25:.75", 0.8), 0);
  EXPECT_NEAR(value("0:0 .5:10 1", 0.5), 11, 1e-12) << "a curve and a number";
}

TEST(Gait, AVariantScalesAndShiftsSignals) {
  EXPECT_NEAR(value("1*w", 0.25, "scale w is 1.5\nshift w is 2\n"), 3.5, 1e-12);
}

TEST(Gait, ErrorsNameTheLine) {
  EXPECT_ERROR(read_gaits("cat.txt", "kind a b\nleap high\n"), "cat.txt:2", "kind, clip, variant", "leap");
  EXPECT_ERROR(read_gaits("cat.txt", "turn Head x 1\n"), "cat.txt:1", "turn");
  for (const char* wrong : {"1~", "a", "1*", "2^.5", "2^.5:.5", "1@", ".5:1 .4:2", "1.5:3"})
    EXPECT_ERROR(read_gaits("cat.txt", "clip c\nturn Head x " + std::string(wrong) + "\n"), "cat.txt:2", "found");
  EXPECT_ERROR(read_gaits("cat.txt", "clip c\nlet x is 3\n"), "cat.txt:2", "names");
  EXPECT_ERROR(read_gaits("cat.txt", "clip c\nturn Head x 1 x 2\n"), "cat.txt:2", "each value once");
  EXPECT_ERROR(value("1*nothing", 0), "a signal", "nothing");
  EXPECT_ERROR(value("1*w", 0, "let w is 1*w\n"), "a signal");
}

TEST(Gait, CurvesPassTheirKeysAndStayBetweenThem) {
  const auto at = [](double t) { return curve({{0, 1}, {0.25, 3}, {0.5, 3}, {0.75, -1}}, t); };
  EXPECT_DOUBLE_EQ(at(0), 1);
  EXPECT_DOUBLE_EQ(at(0.25), 3);
  EXPECT_DOUBLE_EQ(at(0.75), -1);
  EXPECT_NEAR(at(1 - 1e-9), 1, 1e-6);
  for (double t = 0; t < 1; t += 0.01) {
    EXPECT_LE(at(t), 3 + 1e-12) << t;
    EXPECT_GE(at(t), -1 - 1e-12) << t;
  }
  for (double t = 0.25; t <= 0.5; t += 0.01) EXPECT_DOUBLE_EQ(at(t), 3) << "a level";
}

}  // namespace
}  // namespace sinew::clips
