// SPDX-License-Identifier: MIT
// Text to float and back where the compiler's library has no functions for it gives what the standard's functions give.
#include "text/decimal.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <random>

namespace sinew {
namespace {

float of_bits(uint32_t bits) {
  float value;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

TEST(Decimal, OddWordsAreReadAlike) {
  for (const char* word : {"0",
                           "-0",
                           "1",
                           "-1.5",
                           ".5",
                           "5.",
                           "1e3",
                           "1E-3",
                           "1e+3",
                           "0.1",
                           "16777217",
                           "3.4028235e38",
                           "3.4028236e38",
                           "1e39",
                           "-1e99",
                           "1e-46",
                           "1e-99",
                           "1e-40",
                           "0.000000000000000000000000000000000000000000001",
                           "",
                           "-",
                           ".",
                           "-.",
                           "e5",
                           "1e",
                           "1e-",
                           "nan",
                           "inf",
                           "-inf",
                           "infinity",
                           "0x10",
                           "1,5",
                           "1 ",
                           " 1",
                           "+1",
                           "--1",
                           "1f",
                           "1.2.3",
                           "1e5.0"}) {
    EXPECT_EQ(plain::to_float(word), decimal_to_float(word)) << "'" << word << "'";
  }
}

TEST(Decimal, EveryKindOfFloatComesBack) {
  std::mt19937 random(5);
  for (int i = 0; i < 200000; ++i) {
    const float value = of_bits(static_cast<uint32_t>(random()));
    if (!std::isfinite(value)) continue;
    const std::string text = plain::shortest(value);
    ASSERT_EQ(plain::to_float(text), value) << text;
    ASSERT_EQ(decimal_to_float(text), value) << text;
    ASSERT_EQ(plain::to_float(shortest_decimal(value)), value) << text;
    ASSERT_EQ(plain::fixed(static_cast<double>(value), 6), fixed_decimal(static_cast<double>(value), 6));
  }
}

}  // namespace
}  // namespace sinew
