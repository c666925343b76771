// SPDX-License-Identifier: MIT
// Threads that share blocks of rows: everything is done once, whoever does it, and failures come out.
#include "core/team.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <numeric>
#include <set>
#include <stdexcept>
#include <thread>

namespace sinew {
namespace {

TEST(Team, DoesEveryItemAndEveryBlockOnce) {
  for (const unsigned threads : {1u, 2u, 5u}) {
    Team team;
    for (int round = 0; round < 50; ++round) {
      constexpr size_t kItems = 3, kBlocks = 40;
      std::vector<std::atomic<int>> done(kItems * kBlocks);
      team.run(kItems, threads, [&](size_t item, unsigned thread) {
        EXPECT_LT(thread, threads);
        team.blocks(kBlocks / 2, [&](size_t block) { ++done[item * kBlocks + block]; });
        team.blocks(kBlocks / 2, [&](size_t block) { ++done[item * kBlocks + kBlocks / 2 + block]; });
      });
      for (const auto& count : done) ASSERT_EQ(count, 1);
    }
  }
}

TEST(Team, AThreadWithoutAnItemHelps) {
  Team team;
  std::mutex mutex;
  std::set<std::thread::id> helpers;
  team.run(1, 2, [&](size_t, unsigned) {
    // The second thread becomes idle at some moment; until then blocks are done here.
    for (int tries = 0; tries < 1000 && helpers.size() < 2; ++tries) {
      team.blocks(8, [&](size_t) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        const std::lock_guard<std::mutex> lock(mutex);
        helpers.insert(std::this_thread::get_id());
      });
    }
  });
  EXPECT_EQ(helpers.size(), 2u);
}

TEST(Team, AFailureComesOutAndNobodyWaits) {
  Team team;
  for (const unsigned threads : {1u, 3u}) {
    EXPECT_THROW(team.run(4, threads,
                          [&](size_t item, unsigned) {
                            if (item == 1) throw std::runtime_error("one");
                            team.blocks(4, [](size_t) {});
                          }),
                 std::runtime_error);
  }
  size_t sum = 0;
  team.blocks(4, [&](size_t block) { sum += block; });
  EXPECT_EQ(sum, 6u) << "outside run() it is a plain loop";
  team.run(0, 3, [](size_t, unsigned) { FAIL(); });
}

}  // namespace
}  // namespace sinew
