// SPDX-License-Identifier: MIT
// Every item once, on as many threads as there are; the first failure comes out.
#include "sinew_formats/base/thread_pool.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>
#include <vector>

namespace sinew {
namespace {

TEST(ParallelFor, DoesEveryItemOnce) {
  for (const unsigned threads : {0u, 1u, 3u, 50u}) {
    std::vector<std::atomic<int>> done(20);
    std::atomic<bool> in_range = true;
    parallel_for(done.size(), threads, [&](size_t item, unsigned thread) {
      ++done[item];
      if (thread >= std::max(threads, 1u)) in_range = false;
    });
    for (const std::atomic<int>& count : done) EXPECT_EQ(count, 1);
    EXPECT_TRUE(in_range);
  }
  parallel_for(0, 4, [](size_t, unsigned) { FAIL(); });
}

TEST(ParallelFor, AFailureComesOutAndSoonNoFurtherItemStarts) {
  for (const unsigned threads : {1u, 4u}) {
    std::atomic<size_t> done = 0;
    EXPECT_THROW(parallel_for(1000, threads,
                              [&](size_t item, unsigned) {
                                if (item == 0) throw std::runtime_error("no");
                                std::this_thread::sleep_for(std::chrono::milliseconds(1));
                                ++done;
                              }),
                 std::runtime_error);
    EXPECT_LT(done, 500u) << threads;
  }
}

}  // namespace
}  // namespace sinew
