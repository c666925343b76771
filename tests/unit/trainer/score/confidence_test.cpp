// SPDX-License-Identifier: MIT
// How much looking at the least sure vertices finds.
#include "sinew_trainer/confidence.hpp"

#include <gtest/gtest.h>

namespace {

using sinew::doubt_lift;
using sinew::JudgedConfidence;

// 100 vertices, as sure as their number says; every fifth of the first 50 is wrong.
JudgedConfidence judged(bool by_number) {
  JudgedConfidence j;
  for (int v = 0; v < 100; ++v) {
    j.confidence.push_back(by_number ? static_cast<uint8_t>(v) : 200);
    j.right.push_back(v < 50 && v % 5 == 0 ? 0 : 1);
  }
  return j;
}

TEST(DoubtLift, ComparesTheLeastSureTenthWithAll) {
  const sinew::DoubtLift lift = doubt_lift({judged(true)});
  EXPECT_EQ(lift.characters, 1u);
  EXPECT_DOUBLE_EQ(lift.wrong, 0.1);
  EXPECT_DOUBLE_EQ(lift.wrong_first, 0.2);  // 0 and 5 of the first ten
  EXPECT_DOUBLE_EQ(lift.times_average, 2);
}

TEST(DoubtLift, TiesFindTheAverageAndCharactersWithoutFaultDoNotCount) {
  JudgedConfidence faultless = judged(true);
  faultless.right.assign(100, 1);
  const sinew::DoubtLift lift = doubt_lift({judged(false), faultless});
  EXPECT_EQ(lift.characters, 1u);
  EXPECT_DOUBLE_EQ(lift.times_average, 1);
  EXPECT_EQ(doubt_lift({faultless}).characters, 0u);
}

}  // namespace
