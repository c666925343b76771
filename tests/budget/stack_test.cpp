// SPDX-License-Identifier: MIT
// The deepest stack of a bind on this machine, with every kernel: run on a painted stack of its own. And the workspace:
// what is asked for is what is used.
#include <gtest/gtest.h>
#include <pthread.h>

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "stack_cases.hpp"

namespace {

using sinew_test::StackCase;

constexpr size_t kStackBytes = 1 << 20;
constexpr uint8_t kPaint = 0xA5;

std::vector<StackCase> cases() {
  return sinew_test::stack_cases(SINEW_SOURCE_DIR "/samples/data/sinew_default.sinew",
                                 SINEW_SOURCE_DIR "/tests/golden/models");
}

void* nothing(void*) { return nullptr; }
void* bind(void* tested) {
  sinew_test::run(*static_cast<const StackCase*>(tested));
  return nullptr;
}

size_t painted_away(void* (*work)(void*), void* argument) {
  struct alignas(64) Line {
    uint8_t bytes[64];
  };
  std::vector<Line> stack(kStackBytes / sizeof(Line));
  uint8_t* const bytes = stack[0].bytes;
  std::memset(bytes, kPaint, kStackBytes);
  pthread_attr_t attributes;
  pthread_t thread;
  EXPECT_EQ(pthread_attr_init(&attributes), 0);
  EXPECT_EQ(pthread_attr_setstack(&attributes, bytes, kStackBytes), 0);
  EXPECT_EQ(pthread_create(&thread, &attributes, work, argument), 0);
  EXPECT_EQ(pthread_join(thread, nullptr), 0);
  pthread_attr_destroy(&attributes);
  size_t untouched = 0;
  while (untouched < kStackBytes && bytes[untouched] == kPaint) ++untouched;
  return kStackBytes - untouched;
}

TEST(Stack, NoBindTakesMoreThan16KB) {
  // What a thread has on its stack before anything runs.
  const size_t own = painted_away(nothing, nullptr);
  for (StackCase& tested : cases()) {
    for (uint32_t kernel = SINEW_KERNEL_REF; sinew_kernel_name(kernel) != nullptr; ++kernel) {
      if (sinew_kernel_select(kernel) == 0) continue;
      tested.options.kernel = kernel;
      const size_t bytes = painted_away(bind, &tested) - own;
      EXPECT_GT(bytes, 1024u) << "nothing ran on the painted stack";
      EXPECT_LE(bytes, 16u * 1024u) << tested.name << ", " << sinew_kernel_name(kernel);
      std::printf("stack %s %s: %zu bytes\n", tested.name, sinew_kernel_name(kernel), bytes);
    }
  }
}

TEST(Workspace, WhatIsAskedForIsUsed) {
  for (StackCase& tested : cases()) {
    const size_t used = sinew_test::run(tested);
    EXPECT_LE(used, tested.workspace_bytes) << tested.name;
    EXPECT_GE(used * 100, tested.workspace_bytes * 99) << tested.name;
  }
}

}  // namespace
