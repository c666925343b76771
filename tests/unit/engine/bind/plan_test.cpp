// SPDX-License-Identifier: MIT
// The size query is a function of the plan: it calls nobody back and does not ask the processor.
#include <gtest/gtest.h>

#include "bind/bind.hpp"

namespace sinew {
namespace {

size_t size_of(const sinew_bind_options& options) {
  BindPlan plan;
  EXPECT_EQ(plan_bind(nullptr, 1000, 2000, 6000, 20, &options, &plan), SINEW_OK);
  Arena arena;
  measure_bind(arena, plan);
  EXPECT_TRUE(arena.ok());
  return arena.high_water();
}

sinew_bind_options heat_options() {
  sinew_bind_options options = SINEW_INIT(sinew_bind_options);
  options.method = SINEW_METHOD_HEAT;
  return options;
}

TEST(SizeQuery, CallsNobodyBack) {
  sinew_bind_options options = heat_options();
  const size_t size = size_of(options);
  options.progress = [](void*, uint32_t) -> int {
    ADD_FAILURE() << "progress was reported";
    return 1;
  };
  options.parallel_for = [](void*, uint32_t, void (*)(void*, uint32_t), void*) { ADD_FAILURE() << "work was lent"; };
  options.thread_count = 1;
  EXPECT_EQ(size_of(options), size);
}

TEST(SizeQuery, IsTheSameForEveryKernel) {
  sinew_bind_options options = heat_options();
  const size_t size = size_of(options);
  for (options.kernel = 1; sinew_kernel_name(options.kernel) != nullptr; ++options.kernel) {
    EXPECT_EQ(size_of(options), size) << sinew_kernel_name(options.kernel);
  }
}

}  // namespace
}  // namespace sinew
