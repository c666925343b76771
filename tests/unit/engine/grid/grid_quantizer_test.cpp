// SPDX-License-Identifier: MIT
// Float to grid: the defining inequality over the whole float range against a big integer of the test's own, ties,
// scale and offset.
#include "grid/grid_quantizer.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "mesh/mesh.hpp"

namespace {

using sinew::GridQuantizer;
using sinew::Vec3i;

// Signed integer in digits of 16 bits with lazy carries; enough for sums and products with 24-bit numbers.
struct Big {
  std::array<int64_t, 24> digit = {};

  static Big of(float value) {  // in units of 2^-149
    int exponent = 0;
    const double mantissa = std::frexp(static_cast<double>(value), &exponent);
    int64_t whole = static_cast<int64_t>(std::ldexp(mantissa, 24));
    int shift = exponent - 24 + 149;
    for (; shift < 0; ++shift) whole /= 2;  // denormals: those bits are zero
    Big out;
    out.digit[static_cast<size_t>(shift / 16)] = whole * (int64_t{1} << (shift % 16));
    return out.carried();
  }
  Big plus(const Big& b, int64_t factor) const {
    Big out = *this;
    for (size_t i = 0; i < digit.size(); ++i) out.digit[i] += b.digit[i] * factor;
    return out.carried();
  }
  Big carried() const {
    Big out = *this;
    for (size_t i = 0; i + 1 < digit.size(); ++i) {
      const int64_t low = out.digit[i] & 0xFFFF;
      out.digit[i + 1] += (out.digit[i] - low) >> 16;
      out.digit[i] = low;
    }
    return out;
  }
  bool negative() const { return digit.back() < 0; }
};

// Whether q = floor(((2 v - sum) 2^20 + side) / (2 side)).
bool is_rounded(float value, float low, float high, bool floor_axis, const Big& side, int32_t q) {
  Big centered = Big().plus(Big::of(value), 2).plus(Big::of(low), -1).plus(Big::of(floor_axis ? low : high), -1);
  const Big numerator = Big().plus(centered, 1 << 20).plus(side, 1);
  const Big rest = numerator.plus(side, -2 * static_cast<int64_t>(q));
  return !rest.negative() && rest.plus(side, -2).negative();
}

Big longest_side(const std::vector<float>& p, float* low, float* high) {
  Big side;
  for (size_t axis = 0; axis < 3; ++axis) {
    low[axis] = high[axis] = p[axis];
    for (size_t i = axis; i < p.size(); i += 3) {
      low[axis] = std::fmin(low[axis], p[i]);
      high[axis] = std::fmax(high[axis], p[i]);
    }
    const Big extent = Big::of(high[axis]).plus(Big::of(low[axis]), -1);
    if (side.plus(extent, -1).negative()) side = extent;
  }
  return side;
}

void expect_definition(const std::vector<float>& p, const std::vector<float>& extra) {
  GridQuantizer quantizer;
  ASSERT_EQ(sinew::make_grid_quantizer(p.data(), p.size() / 3, 0, &quantizer), SINEW_OK);
  float low[3], high[3];
  const Big side = longest_side(p, low, high);
  if (!Big().plus(side, -1).negative()) return;  // no extent
  const auto check = [&](const float* point, bool may_clamp) {
    const Vec3i q = sinew::quantize_point(quantizer, point);
    const int32_t grid[3] = {q.x, q.y, q.z};
    for (int axis = 0; axis < 3; ++axis) {
      const float lo = low[axis], hi = high[axis];
      if (may_clamp && (grid[axis] == 1 << 22 || grid[axis] == -(1 << 22))) {
        // Clamped: one step further in must not be the true value.
        const int32_t inner = grid[axis] > 0 ? grid[axis] - 1 : grid[axis] + 1;
        ASSERT_FALSE(is_rounded(point[axis], lo, hi, axis == 1, side, inner));
        continue;
      }
      ASSERT_TRUE(is_rounded(point[axis], lo, hi, axis == 1, side, grid[axis]))
          << "axis " << axis << " value " << point[axis] << " box " << lo << " .. " << hi << " gave " << grid[axis];
    }
  };
  for (size_t i = 0; i < p.size(); i += 3) check(&p[i], false);
  for (size_t i = 0; i < extra.size(); i += 3) check(&extra[i], true);
}

float random_float(std::mt19937& random, int low_exponent, int high_exponent) {
  const int span = high_exponent - low_exponent;
  const int exponent = low_exponent + static_cast<int>(random() % static_cast<unsigned>(span + 1));
  const float mantissa = static_cast<float>(random() & 0xFFFFFFu) - 8388608.0f;
  return std::ldexp(mantissa, exponent - 23);
}

TEST(Quantize, IsTheExactQuotientOverTheWholeFloatRange) {
  std::mt19937 random(1);
  const int ranges[][2] = {{-149, 126}, {0, 0}, {-3, 3}, {-60, 10}, {-149, -120}, {100, 126}, {-20, 0}};
  for (int round = 0; round < 4000; ++round) {
    const int* const range = ranges[random() % 7];
    std::vector<float> points, joints;
    for (int i = 0; i < 9; ++i) points.push_back(random_float(random, range[0], range[1]));
    for (int i = 0; i < 6; ++i) joints.push_back(random_float(random, range[0], range[1]));
    ASSERT_NO_FATAL_FAILURE(expect_definition(points, joints));
  }
}

// Grid lines on round numbers make remainders of exactly zero, where a truncated quotient is wrong by one.
TEST(Quantize, IsExactNextToTies) {
  std::mt19937 random(2);
  for (int round = 0; round < 4000; ++round) {
    const float tiny = std::ldexp(1.0f, -static_cast<int>(random() % 149));
    const float side = std::ldexp(1.0f, 18 + static_cast<int>(random() % 6));
    const float half = static_cast<float>(random() % 2097152) / 2;
    expect_definition({random() % 2 ? tiny : 0.0f, 0, random() % 2 ? -tiny : 0.0f, side, tiny, 1, half, half, half},
                      {half - tiny, half + tiny, -half, std::nextafter(half, 0.0f), -tiny, tiny});
  }
}

// Rounding boundaries close to zero, where floats are far finer than the 64-bit way's unit: cutting a value off moves
// it across.
TEST(Quantize, IsExactWhereTheShortWayCutsBitsOff) {
  std::mt19937 random(4);
  for (int round = 0; round < 20000; ++round) {
    const float side = 1 + random_float(random, -2, -2);
    const double unit = static_cast<double>(side) / 1048576;
    const double steps = static_cast<double>(random() % 256) + 0.5;
    const float low = static_cast<float>(-steps * unit);
    const float high = low + side;
    const long double exact_unit = (static_cast<long double>(high) - low) / 1048576;
    const float boundary = static_cast<float>(low + steps * exact_unit);
    const std::vector<float> box = {0, low, 0, 0, high, 0};
    const float below = std::nextafter(boundary, -1.0f), above = std::nextafter(boundary, 1.0f);
    ASSERT_NO_FATAL_FAILURE(expect_definition(box, {0, boundary, 0, 0, below, 0, 0, above, 0}));
  }
}

// The side alone has too many bits for the short way; on y everything else is exact and every value lies on a tie of
// the cut-off side.
TEST(Quantize, ASideThatIsCutOffStillDecidesTies) {
  const std::vector<float> box = {-std::ldexp(1.0f, -60), 0, 0, 1, 1, 0};
  for (int k = 1; k < 1048576; k += 10007) {
    expect_definition(box, {0, std::ldexp(static_cast<float>(2 * k - 1), -21), 0});
  }
}

TEST(Quantize, RoundsHalfUp) {
  // Side 2^21 around 0: a grid unit is 2.
  const std::vector<float> p = {-1048576, 0, 0, 1048576, 0, 0};
  GridQuantizer quantizer;
  ASSERT_EQ(sinew::make_grid_quantizer(p.data(), 2, 0, &quantizer), SINEW_OK);
  const auto x = [&](float value) {
    const float point[3] = {value, 0, 0};
    return sinew::quantize_point(quantizer, point).x;
  };
  EXPECT_EQ(x(1), 1);
  EXPECT_EQ(x(std::nextafter(1.0f, 0.0f)), 0);
  EXPECT_EQ(x(-1), 0);
  EXPECT_EQ(x(std::nextafter(-1.0f, -2.0f)), -1);
  EXPECT_EQ(x(3), 2);
  EXPECT_EQ(x(1048576), 1 << 19);
  EXPECT_EQ(x(-1048576), -(1 << 19));
  EXPECT_EQ(x(-0.0f), 0);
  EXPECT_EQ(x(1e30f), 1 << 22);
  EXPECT_EQ(x(-1e30f), -(1 << 22));
}

TEST(Quantize, PowersOfTwoAndRepresentableOffsetsChangeNothing) {
  std::mt19937 random(3);
  std::vector<float> p;
  for (int i = 0; i < 300; ++i) p.push_back(static_cast<float>(static_cast<int>(random() % 2048)) / 16);
  GridQuantizer plain;
  ASSERT_EQ(sinew::make_grid_quantizer(p.data(), 100, 0, &plain), SINEW_OK);
  for (const int scale : {-140, -30, 0, 60, 119}) {
    for (const float offset : {0.0f, 1e6f, -1e6f}) {
      if ((scale < -100 || scale > 100) && offset != 0) continue;  // would not be representable
      std::vector<float> moved;
      for (const float v : p) moved.push_back(std::ldexp(v + offset, scale));
      GridQuantizer quantizer;
      ASSERT_EQ(sinew::make_grid_quantizer(moved.data(), 100, 0, &quantizer), SINEW_OK);
      for (size_t i = 0; i < p.size(); i += 3) {
        EXPECT_EQ(sinew::quantize_point(quantizer, &moved[i]), sinew::quantize_point(plain, &p[i]))
            << scale << " " << offset;
      }
    }
  }
}

TEST(Quantize, APointHasSideOne) {
  const float p[3] = {7.5f, -2, 1e6f};
  const float joint[3] = {8.5f, -1, 1e6f + 0.5f};
  GridQuantizer quantizer;
  ASSERT_EQ(sinew::make_grid_quantizer(p, 1, 0, &quantizer), SINEW_OK);
  EXPECT_EQ(sinew::quantize_point(quantizer, p), (Vec3i{0, 0, 0}));
  EXPECT_EQ(sinew::quantize_point(quantizer, joint), (Vec3i{1 << 20, 1 << 20, 1 << 19}));
}

TEST(Quantize, ZUpIsTurned) {
  const float p[6] = {0, 0, 0, 1, 2, 4};
  GridQuantizer quantizer;
  ASSERT_EQ(sinew::make_grid_quantizer(p, 2, 1, &quantizer), SINEW_OK);
  EXPECT_EQ(sinew::quantize_point(quantizer, p), (Vec3i{-(1 << 17), 0, 1 << 18}));
  EXPECT_EQ(sinew::quantize_point(quantizer, p + 3), (Vec3i{1 << 17, 1 << 20, -(1 << 18)}));
}

TEST(Quantize, RefusesWhatIsNotFinite) {
  for (const float bad : {std::numeric_limits<float>::infinity(), -std::numeric_limits<float>::infinity(),
                          std::numeric_limits<float>::quiet_NaN()}) {
    for (int at = 0; at < 6; ++at) {
      float p[6] = {0, 0, 0, 1, 2, 4};
      p[at] = bad;
      GridQuantizer quantizer;
      EXPECT_EQ(sinew::make_grid_quantizer(p, 2, 0, &quantizer), SINEW_ERROR_NOT_FINITE);
    }
  }
}

}  // namespace
