// SPDX-License-Identifier: MIT
// Every index runs once, on the lane that is fixed for it, whatever runs the lanes.
#include "core/threads.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "lent_threads.hpp"

namespace sinew {
namespace {

using sinew_test::LoopLog;

constexpr sinew_parallel_for kRunners[] = {nullptr, sinew_test::run_backwards, sinew_test::run_on_threads};

TEST(Threads, EveryIndexRunsOnceOnItsLane) {
  for (const sinew_parallel_for runner : kRunners) {
    for (uint32_t lanes = 1; lanes <= 5; ++lanes) {
      for (const uint32_t count : {0u, 1u, 2u, 4u, 5u, 6u, 37u}) {
        LoopLog log;
        const Threads threads = {lanes, runner, &log};
        std::vector<std::vector<uint32_t>> ran(count);  // by index: lanes
        threads.each(count, [&](uint32_t index, uint32_t lane) { ran[index].push_back(lane); });
        for (uint32_t i = 0; i < count; ++i) {
          ASSERT_EQ(ran[i], std::vector<uint32_t>{i % lanes}) << i << " of " << count << ", " << lanes << " lanes";
        }
      }
    }
  }
}

TEST(Threads, TheCallersThreadsAreAskedForNoMoreThanThereIsToDo) {
  for (const uint32_t count : {0u, 1u, 2u, 3u, 50u}) {
    LoopLog log;
    const Threads threads = {3, sinew_test::run_backwards, &log};
    threads.each(count, [](uint32_t, uint32_t) {});
    EXPECT_EQ(log.loops, count < 2 ? 0u : 1u) << count;
    EXPECT_EQ(log.largest, count < 2 ? 0u : count < 3 ? count : 3u) << count;
  }
}

TEST(Threads, RangesCoverTheCountWithoutOverlap) {
  for (const sinew_parallel_for runner : kRunners) {
    for (const uint32_t count : {0u, 1u, 9u, 10u, 11u, 100u, 101u}) {
      LoopLog log;
      const Threads threads = {3, runner, &log};
      std::vector<std::vector<std::pair<uint32_t, uint32_t>>> by_lane(3);
      threads.ranges(count, 10,
                     [&](uint32_t begin, uint32_t end, uint32_t lane) { by_lane[lane].emplace_back(begin, end); });
      std::vector<uint32_t> covered(count, 0);
      for (uint32_t lane = 0; lane < 3; ++lane) {
        for (const auto& [begin, end] : by_lane[lane]) {
          EXPECT_EQ(begin % 10, 0u);
          EXPECT_EQ(begin / 10 % 3, lane);
          EXPECT_EQ(end, std::min(begin + 10, count));
          for (uint32_t i = begin; i < end; ++i) ++covered[i];
        }
      }
      EXPECT_EQ(covered, std::vector<uint32_t>(count, 1)) << count;
    }
  }
}

}  // namespace
}  // namespace sinew
