// SPDX-License-Identifier: MIT
// Texts as printf writes them, of any length.
#include "sinew_formats/print.hpp"

#include <gtest/gtest.h>

namespace sinew {
namespace {

TEST(Print, WritesWhatPrintfWrites) {
  EXPECT_EQ(print("%d of %s, %.2f %%", 3, "four", 0.5), "3 of four, 0.50 %");
  EXPECT_EQ(print("%s", ""), "");
}

TEST(Print, CutsNoLongText) {
  const std::string text(5000, 'x');
  EXPECT_EQ(print("<%s>", text.c_str()), "<" + text + ">");
}

}  // namespace
}  // namespace sinew
