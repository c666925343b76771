// SPDX-License-Identifier: MIT
// Fixed-point helpers: exact roots at every square's edge, highest bits, logarithms.
#include "core/fixed.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace sinew {
namespace {

void expect_root(uint64_t v) {
  const uint64_t r = isqrt64(v);
  ASSERT_LE(r * r, v);
  ASSERT_TRUE(r == 0xFFFFFFFFu || (r + 1) * (r + 1) > v) << v << " root " << r;
  ASSERT_EQ(r, isqrt64_bitwise(v)) << v;
  if (v >> 63 != 0) return;
  for (const uint64_t near : {root_by_table(v), near_root(v)}) {
    ASSERT_LE(near > r ? near - r : r - near, 4u) << v;
  }
}

TEST(Isqrt64, IsExactAroundEverySquareOfAnySize) {
  std::mt19937_64 random(5);
  for (uint64_t v = 0; v < 100000; ++v) expect_root(v);
  for (uint64_t v = 0; v < 1000; ++v) expect_root(UINT64_MAX - v);
  for (int i = 0; i < 300000 && !HasFatalFailure(); ++i) {
    const uint64_t r = (random() >> 32) >> (random() % 32);
    expect_root(r * r);
    expect_root(r * r - (r > 0));
    expect_root(r * r + 2 * r);
    expect_root(random() >> (random() % 64));
  }
  for (uint32_t bit = 0; bit < 64; ++bit) expect_root(uint64_t{1} << bit);
}

TEST(TopBit, IsTheHighestOne) {
  EXPECT_EQ(top_bit(0), 0);
  for (int bit = 0; bit < 64; ++bit) {
    EXPECT_EQ(top_bit(uint64_t{1} << bit), bit);
    EXPECT_EQ(top_bit((uint64_t{2} << bit) - 1), bit);
  }
}

TEST(Log2, IsWithinItsBoundExactForPowersAndNeverFalls) {
  std::mt19937_64 random(6);
  for (int i = 0; i < 100000; ++i) {
    const uint64_t v = (random() >> (random() % 64)) | 1;
    ASSERT_NEAR(log2_q16(v) / 65536.0, std::log2(static_cast<double>(v)), 1.0 / 32768) << v;
  }
  for (int bit = 0; bit < 64; ++bit) EXPECT_EQ(log2_q16(uint64_t{1} << bit), bit << 16);
  for (uint64_t v = 1; v < 200000; ++v) ASSERT_LE(log2_q16(v), log2_q16(v + 1)) << v;
}

TEST(Exp2Negative, IsWithinItsBound) {
  for (int64_t x = 0; x < 45 * 65536; x += 997) {
    const double expected = std::exp2(-static_cast<double>(x) / 65536 + 30);
    EXPECT_NEAR(static_cast<double>(exp2_negative(x)), expected, expected * 3e-8 + 1) << x;
  }
}

}  // namespace
}  // namespace sinew
