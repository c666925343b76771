// SPDX-License-Identifier: MIT
// The caller's rows in every format, and what becomes of them where vertices are welded.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "hand_rows.hpp"
#include "weights/users_say.hpp"

namespace sinew {
namespace {

using sinew_test::HandRows;

uint32_t q16(float value) {
  const float weights[2] = {1.0f, value};
  uint32_t row[2] = {};
  EXPECT_TRUE(read_row(weights, SINEW_WEIGHT_FLOAT, 0, 2, row)) << static_cast<double>(value);
  return row[1];
}

TEST(ReadRow, FloatsAreStepsOfTwoToTheMinusSixteenRoundedHalfUp) {
  EXPECT_EQ(q16(0.0f), 0u);
  EXPECT_EQ(q16(-0.0f), 0u);
  EXPECT_EQ(q16(0.5f), 32768u);
  EXPECT_EQ(q16(1.0f), kWholeRow);
  EXPECT_EQ(q16(3.5f), kWholeRow);
  EXPECT_EQ(q16(std::numeric_limits<float>::infinity()), kWholeRow);
  EXPECT_EQ(q16(std::ldexp(1.0f, -16)), 1u);
  EXPECT_EQ(q16(std::ldexp(1.0f, -17)), 1u);
  EXPECT_EQ(q16(std::nextafter(std::ldexp(1.0f, -17), 0.0f)), 0u);
  EXPECT_EQ(q16(std::numeric_limits<float>::denorm_min()), 0u);
  EXPECT_EQ(q16(std::nextafter(1.0f, 0.0f)), kWholeRow);
  for (uint32_t i = 0; i <= kWholeRow; i += 7) EXPECT_EQ(q16(static_cast<float>(i) / 65536.0f), i);
}

TEST(ReadRow, RefusesNegativeWeightsNaNAndEmptyRows) {
  uint32_t row[2];
  for (const float bad : {-1.0f, -1e-30f, std::nanf(""), -std::numeric_limits<float>::infinity()}) {
    const float weights[2] = {1.0f, bad};
    EXPECT_FALSE(read_row(weights, SINEW_WEIGHT_FLOAT, 0, 2, row)) << static_cast<double>(bad);
  }
  const float nothing[2] = {0.0f, -0.0f};
  EXPECT_FALSE(read_row(nothing, SINEW_WEIGHT_FLOAT, 0, 2, row));
  const uint8_t narrow[2] = {};
  EXPECT_FALSE(read_row(narrow, SINEW_WEIGHT_UNORM8, 0, 2, row));
}

TEST(ReadRow, IntegersComeAsTheyAreFromTheIndexOn) {
  uint32_t row[2];
  const uint8_t narrow[4] = {9, 9, 200, 55};
  ASSERT_TRUE(read_row(narrow, SINEW_WEIGHT_UNORM8, 2, 2, row));
  EXPECT_EQ(row[0], 200u);
  EXPECT_EQ(row[1], 55u);
  const uint16_t wide[4] = {9, 9, 65535, 0};
  ASSERT_TRUE(read_row(wide, SINEW_WEIGHT_UNORM16, 2, 2, row));
  EXPECT_EQ(row[0], 65535u);
  EXPECT_EQ(row[1], 0u);
}

// Five vertices of the caller on three welded ones: 0 and 1 on 0, 2 and 3 on 1, 4 on 2. Rows of two slots.
struct Welded {
  Mesh mesh;
  std::vector<uint32_t> vertex_to_welded = {0, 0, 1, 1, 2};
  std::vector<uint8_t> locked = std::vector<uint8_t>(5, 0), hints = std::vector<uint8_t>(5, 0);
  std::vector<uint16_t> joints = std::vector<uint16_t>(10, 0), weights = std::vector<uint16_t>(10, 0);
  HandRows out{3};

  void give(uint32_t vertex, uint16_t a, uint16_t weight_a, uint16_t b, uint16_t weight_b) {
    joints[2 * vertex] = a;
    joints[2 * vertex + 1] = b;
    weights[2 * vertex] = weight_a;
    weights[2 * vertex + 1] = weight_b;
  }
  const GivenRows& gather() {
    mesh.vertex_count = 5;
    mesh.welded_count = 3;
    mesh.vertex_to_welded = vertex_to_welded.data();
    gather_given_rows(mesh, locked.data(), hints.data(), joints.data(), weights.data(), SINEW_WEIGHT_UNORM16, 2,
                      &out.given);
    return out.given;
  }
};

TEST(GatherGivenRows, TakesTheMeanOfWhatWasGivenAtOnePlace) {
  Welded w;
  w.locked[0] = w.locked[1] = 1;
  w.give(0, 4, 65535, 0, 0);
  w.give(1, 4, 32768, 7, 32767);
  const GivenRows& given = w.gather();
  EXPECT_EQ(given.kind[0], GivenKind::kKept);
  EXPECT_EQ(given.kind[1], GivenKind::kFree);
  EXPECT_EQ(given.kind[2], GivenKind::kFree);
  EXPECT_NEAR(given.rows.weight(0, 4), 49151, 1);
  EXPECT_NEAR(given.rows.weight(0, 7), 16384, 1);
}

TEST(GatherGivenRows, ARowThatSumsToTheWholeStaysAsItIs) {
  Welded w;
  w.hints[4] = 1;
  w.give(4, 3, 65000, 1, 535);
  const GivenRows& given = w.gather();
  EXPECT_EQ(given.kind[2], GivenKind::kSteers);
  EXPECT_EQ(given.rows.weight(2, 3), 65000u);
  EXPECT_EQ(given.rows.weight(2, 1), 535u);
}

TEST(GatherGivenRows, HintsAloneCountWhereThereAreBoth) {
  Welded w;
  w.locked[2] = 1;
  w.hints[3] = 1;
  w.give(2, 1, 65535, 0, 0);
  w.give(3, 2, 65535, 0, 0);
  const GivenRows& given = w.gather();
  EXPECT_EQ(given.kind[1], GivenKind::kSteers);
  EXPECT_EQ(given.rows.weight(1, 1), 0u);
  EXPECT_EQ(given.rows.weight(1, 2), 65535u);
}

TEST(GatherGivenRows, LockedRowsWithoutWeightAreFree) {
  Welded w;
  w.locked[4] = 1;
  EXPECT_EQ(w.gather().kind[2], GivenKind::kFree);
}

}  // namespace
}  // namespace sinew
