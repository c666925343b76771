// SPDX-License-Identifier: MIT
// Structs of callers with an older, the same and a newer header.
#include "core/struct_size.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace {

using sinew::read_struct;
using sinew::write_struct;

struct First {
  uint32_t struct_size, a;
};
struct Own {  // the library's
  uint32_t struct_size, a, b, c;
};
struct Newer {
  uint32_t struct_size, a, b, c, d, e;
};

TEST(StructSize, MembersThatAnOlderHeaderLacksAreZero) {
  const First older = {sizeof older, 7};
  Own own = {9, 9, 9, 9};
  ASSERT_EQ(read_struct(&older, sizeof(First), sizeof own, &own), SINEW_OK);
  EXPECT_EQ(own.struct_size, sizeof older);
  EXPECT_EQ(own.a, 7u);
  EXPECT_EQ(own.b, 0u);
  EXPECT_EQ(own.c, 0u);
}

TEST(StructSize, MembersThatAnOlderHeaderLacksAreNotWritten) {
  Newer memory = {sizeof(First), 1, 2, 3, 4, 5};
  Own own;
  ASSERT_EQ(read_struct(&memory, sizeof(First), sizeof own, &own), SINEW_OK);
  own.a = own.b = 50;
  write_struct(&own, sizeof own, &memory);
  EXPECT_EQ(memory.struct_size, sizeof(First));
  EXPECT_EQ(memory.a, 50u);
  EXPECT_EQ(memory.b, 2u);
}

TEST(StructSize, WhatANewerHeaderAddsMustBeZero) {
  Newer newer = {sizeof newer, 1, 2, 3, 0, 0};
  Own own;
  ASSERT_EQ(read_struct(&newer, sizeof(First), sizeof own, &own), SINEW_OK);
  EXPECT_EQ(own.c, 3u);
  own.c = 30;
  write_struct(&own, sizeof own, &newer);
  EXPECT_EQ(newer.struct_size, sizeof newer);
  EXPECT_EQ(newer.c, 30u);
  EXPECT_EQ(newer.d, 0u);

  Own untouched = {9, 9, 9, 9};
  for (size_t byte = sizeof(Own); byte < sizeof(Newer); ++byte) {
    Newer set = newer;
    reinterpret_cast<unsigned char*>(&set)[byte] = 1;
    EXPECT_EQ(read_struct(&set, sizeof(First), sizeof own, &untouched), SINEW_ERROR_VERSION) << byte;
  }
  EXPECT_EQ(untouched.a, 9u);
}

TEST(StructSize, SizesThatWereNeverSetAreRefused) {
  Own own = {9, 9, 9, 9};
  for (const uint32_t size : {0u, 1u, uint32_t{sizeof(First)} - 1, sinew::kLargestStruct + 1, 0xCDCDCDCDu}) {
    std::vector<uint32_t> caller(sinew::kLargestStruct / 4 + 2, 0);
    caller[0] = size;
    EXPECT_EQ(read_struct(caller.data(), sizeof(First), sizeof own, &own), SINEW_ERROR_ARGUMENT) << size;
  }
  EXPECT_EQ(own.a, 9u);
}

}  // namespace
