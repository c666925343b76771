// SPDX-License-Identifier: MIT
// Rows as a match carries them: distances between rows, whole rows, rows in another skeleton's joints.
#include "transfer/match.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace sinew::transferring {
namespace {

// Rows of four vertices.
struct Four {
  std::vector<uint16_t> joints = std::vector<uint16_t>(4 * kRowSlots, kNoJoint);
  std::vector<uint32_t> weights = std::vector<uint32_t>(4 * kRowSlots, 0);
  Rows rows;
  Four() {
    rows.joints = joints.data();
    rows.weights = weights.data();
  }
};

TEST(Match, DistancesOfRows) {
  const Four a;
  a.rows.add(0, 3, kWholeRow);
  a.rows.add(1, 5, kWholeRow);
  a.rows.add(2, 3, kWholeRow / 4);
  a.rows.add(2, 5, kWholeRow - kWholeRow / 4);
  EXPECT_EQ(row_distance(a.rows, 0, a.rows, 0), 0u);
  EXPECT_EQ(row_distance(a.rows, 0, a.rows, 1), 2 * kWholeRow);
  EXPECT_EQ(row_distance(a.rows, 1, a.rows, 2), 2 * (kWholeRow / 4));
  EXPECT_EQ(row_distance(a.rows, 2, a.rows, 1), 2 * (kWholeRow / 4)) << "either way";
  EXPECT_EQ(row_distance(a.rows, 0, a.rows, 3), kWholeRow) << "an empty row";
  EXPECT_TRUE(has_weight(a.rows, 0));
  EXPECT_FALSE(has_weight(a.rows, 3));
}

TEST(Match, RowsAreMadeWhole) {
  const Four a;
  a.rows.add(0, 1, 10);
  a.rows.add(0, 2, 30);
  make_whole(a.rows, 0);
  EXPECT_EQ(a.rows.weight(0, 1), (kWholeRow + 2) / 4);
  EXPECT_NEAR(a.rows.weight(0, 2), 0.75 * kWholeRow, 1);
  make_whole(a.rows, 3);
  EXPECT_FALSE(has_weight(a.rows, 3));
}

TEST(Match, RowsGoToTheJointsThatTakeThem) {
  int32_t target_of[4] = {2, 2, -1, 0};
  JointCounterparts map;
  map.target_of = target_of;
  const Four a;
  a.rows.add(0, 0, 100);
  a.rows.add(0, 1, 100);
  a.rows.add(0, 2, 500);  // goes nowhere
  a.rows.add(0, 3, 200);
  map_row(map, a.rows, 0);
  EXPECT_NEAR(a.rows.weight(0, 2), 0.5 * kWholeRow, 1);
  EXPECT_NEAR(a.rows.weight(0, 0), 0.5 * kWholeRow, 1);
  EXPECT_EQ(a.rows.weight(0, 1), 0u);
}

TEST(Match, CarriesBetweenCorners) {
  MatchedPoint point;
  point.corners[0] = 0;
  point.corners[1] = 1;
  point.corners[2] = 2;
  point.shares[0] = 0.5;
  point.shares[1] = 0.25;
  point.shares[2] = 0.25;
  Match match;
  match.points = &point;
  const double values[3] = {4, 8, 16};
  EXPECT_EQ(match.carry(values, 0), 8);
  const Four source, out;
  source.rows.add(0, 7, kWholeRow);
  source.rows.add(1, 9, kWholeRow);
  match.carry(source.rows, 0, out.rows, 3);  // the third corner has no weight
  EXPECT_NEAR(out.rows.weight(3, 7), kWholeRow * 2.0 / 3, 2);
  EXPECT_NEAR(out.rows.weight(3, 9), kWholeRow / 3.0, 2);
}

}  // namespace
}  // namespace sinew::transferring
