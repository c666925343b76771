// SPDX-License-Identifier: MIT
// Label propagation against the plain definition: one exhaustive search per joint over all 26 steps, the nearest K
// kept.
#include "features/propagation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <new>
#include <queue>
#include <random>
#include <vector>

namespace {

using sinew::Propagation;

struct Seed {
  uint32_t cell, joint, distance;
};

// Shortest label of one joint in every cell: Dijkstra, no pruning, no limit.
std::vector<uint32_t> nearest(const sinew::VoxelGrid& grid, const std::vector<Seed>& seeds, uint32_t joint) {
  std::vector<uint32_t> best(grid.cell_count, UINT32_MAX);
  std::priority_queue<std::pair<int64_t, uint32_t>> queue;
  for (const Seed& seed : seeds) {
    if (seed.joint != joint || seed.distance >= best[seed.cell]) continue;
    best[seed.cell] = seed.distance;
    queue.push({-static_cast<int64_t>(seed.distance), seed.cell});
  }
  while (!queue.empty()) {
    const auto [negative, cell] = queue.top();
    queue.pop();
    if (-negative != best[cell]) continue;
    for (int32_t z = -1; z <= 1; ++z) {
      for (int32_t y = -1; y <= 1; ++y) {
        for (int32_t x = -1; x <= 1; ++x) {
          const uint32_t to = cell + static_cast<uint32_t>((z * grid.size[1] + y) * grid.size[0] + x);
          if (to == cell || grid.states[to] == sinew::kCellBorder) continue;
          const uint32_t lengths[4] = {0, 40, 56, 72};
          const bool outside = grid.states[cell] == sinew::kCellOutside || grid.states[to] == sinew::kCellOutside;
          const uint32_t distance = best[cell] + lengths[std::abs(x) + std::abs(y) + std::abs(z)] * (outside ? 4 : 1);
          if (distance >= best[to]) continue;
          best[to] = distance;
          queue.push({-static_cast<int64_t>(distance), to});
        }
      }
    }
  }
  return best;
}

TEST(Propagation, FindsTheNearestJointsOfEveryCell) {
  std::mt19937 random(11);
  const auto below = [&](size_t n) { return static_cast<uint32_t>(random() % n); };
  for (int round = 0; round < 60; ++round) {
    sinew::Counts counts;
    counts.candidates = 1 + below(5);
    counts.grid = 16;
    sinew::Arena measure;
    Propagation().allocate(measure, counts);
    const size_t bytes = measure.high_water();
    void* const block = ::operator new (bytes, std::align_val_t{64});
    sinew::Arena arena(block, bytes);
    Propagation p;
    ASSERT_TRUE(p.allocate(arena, counts));
    sinew::VoxelGrid& grid = p.grid;
    for (int32_t& side : grid.size) side = 3 + static_cast<int32_t>(below(16));
    grid.cell_count = static_cast<uint32_t>(grid.size[0] * grid.size[1] * grid.size[2]);
    // Large solid and outside regions with straight faces, and some rounds with crumbs, so that both kinds of terrain
    // occur.
    const int32_t cut = static_cast<int32_t>(below(static_cast<size_t>(grid.size[0])));
    std::vector<uint32_t> inner;
    for (int32_t z = 0; z < grid.size[2]; ++z) {
      for (int32_t y = 0; y < grid.size[1]; ++y) {
        for (int32_t x = 0; x < grid.size[0]; ++x) {
          const uint32_t cell = grid.index(x, y, z);
          const bool border =
              x == 0 || y == 0 || z == 0 || x == grid.size[0] - 1 || y == grid.size[1] - 1 || z == grid.size[2] - 1;
          const bool outside = (x < cut) != (round % 3 == 0 && below(8) == 0);
          grid.states[cell] = static_cast<uint8_t>(below(2));  // inside or surface
          if (outside) grid.states[cell] = sinew::kCellOutside;
          if (border) grid.states[cell] = sinew::kCellBorder;
          if (!border) inner.push_back(cell);
        }
      }
    }
    const uint32_t joints = counts.candidates + below(6);
    std::vector<Seed> seeds;
    for (uint32_t joint = 0; joint < joints; ++joint) {
      for (uint32_t i = 0; i <= below(4); ++i) {  // some far beyond one round of the buckets, many with ties
        seeds.push_back({inner[below(inner.size())], joint, below(2) ? below(3) * 40 : below(3000)});
      }
    }
    p.survey();
    for (const uint32_t cell : inner) p.want(cell);
    for (const uint32_t capacity : {uint32_t{1}, counts.candidates}) {
      p.begin(capacity);
      for (const Seed& seed : seeds) p.seed(seed.cell, sinew::make_label(seed.distance, seed.joint));
      ASSERT_TRUE(p.run({}, 0));
      std::vector<std::vector<uint32_t>> expected(grid.cell_count);
      for (uint32_t joint = 0; joint < joints; ++joint) {
        const std::vector<uint32_t> best = nearest(grid, seeds, joint);
        for (const uint32_t cell : inner) expected[cell].push_back(sinew::make_label(best[cell], joint));
      }
      for (const uint32_t cell : inner) {
        std::sort(expected[cell].begin(), expected[cell].end());
        expected[cell].resize(capacity);
        ASSERT_EQ(std::vector<uint32_t>(p.labels(cell), p.labels(cell) + p.label_count(cell)), expected[cell])
            << "round " << round << " cell " << cell;
      }
    }
    ::operator delete (block, std::align_val_t{64});
  }
}

}  // namespace
