// SPDX-License-Identifier: MIT
// Label propagation against the plain definition: one exhaustive search per joint over all 26 steps, the nearest K
// kept.
#include "candidates/propagation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
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

// Shortest label of one joint in every cell: Dijkstra, no pruning, no limit. solid_only: not through outside cells.
std::vector<uint32_t> nearest(const sinew::VoxelGrid& grid, const std::vector<Seed>& seeds, uint32_t joint,
                              bool solid_only = false) {
  const auto closed = [&](uint32_t cell) {
    return grid.states[cell] == sinew::kCellBorder || (solid_only && grid.states[cell] == sinew::kCellOutside);
  };
  std::vector<uint32_t> best(grid.cell_count, UINT32_MAX);
  std::priority_queue<std::pair<int64_t, uint32_t>> queue;
  for (const Seed& seed : seeds) {
    if (seed.joint != joint || seed.distance >= best[seed.cell] || closed(seed.cell)) continue;
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
          if (to == cell || closed(to)) continue;
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

// The K nearest labels of every solid cell.
std::vector<std::vector<uint32_t>> expect(const sinew::VoxelGrid& grid, const std::vector<Seed>& seeds, uint32_t joints,
                                          uint32_t capacity, bool solid_only = false) {
  std::vector<std::vector<uint32_t>> labels(grid.cell_count);
  for (uint32_t joint = 0; joint < joints; ++joint) {
    const std::vector<uint32_t> best = nearest(grid, seeds, joint, solid_only);
    for (uint32_t cell = 0; cell < grid.cell_count; ++cell) {
      if (grid.states[cell] > sinew::kCellSurface || best[cell] == UINT32_MAX) continue;
      labels[cell].push_back(sinew::make_label(best[cell], joint));
    }
  }
  for (std::vector<uint32_t>& cell : labels) {
    std::sort(cell.begin(), cell.end());
    cell.resize(std::min<size_t>(cell.size(), capacity));
  }
  return labels;
}

class Field {
 public:
  Field(uint32_t candidates, uint32_t grid) {
    sinew::Counts counts;
    counts.candidates = candidates;
    counts.grid = grid;
    sinew::Arena measure;
    Propagation().allocate(measure, counts);
    bytes_ = measure.high_water();
    block_ = ::operator new (bytes_, std::align_val_t{64});
    sinew::Arena arena(block_, bytes_);
    EXPECT_TRUE(p.allocate(arena, counts));
  }
  ~Field() { ::operator delete (block_, std::align_val_t{64}); }
  Field(const Field&) = delete;
  Field& operator=(const Field&) = delete;

  // Fills the grid, border aside, and survey()s it. state: of inner cell (x, y, z).
  template <class State>
  void fill(std::array<int32_t, 3> size, State state) {
    sinew::VoxelGrid& grid = p.grid;
    std::copy(size.begin(), size.end(), grid.size);
    grid.cell_count = static_cast<uint32_t>(size[0] * size[1] * size[2]);
    std::fill(grid.states, grid.states + grid.cell_count, sinew::kCellBorder);
    for (int32_t z = 1; z < size[2] - 1; ++z) {
      for (int32_t y = 1; y < size[1] - 1; ++y) {
        for (int32_t x = 1; x < size[0] - 1; ++x) {
          grid.states[grid.index(x, y, z)] = static_cast<uint8_t>(state(x, y, z));
          inner.push_back(grid.index(x, y, z));
        }
      }
    }
    p.survey();
  }
  void run(const std::vector<Seed>& seeds, uint32_t capacity) {
    p.begin(capacity);
    for (const Seed& seed : seeds) p.seed(seed.cell, sinew::make_label(seed.distance, seed.joint));
    ASSERT_TRUE(p.run({}, 0));
  }
  void expect_labels(const std::vector<std::vector<uint32_t>>& expected) const {
    for (const uint32_t cell : inner) {
      if (p.grid.states[cell] > sinew::kCellSurface) continue;
      const uint32_t* const labels = p.labels(p.solid_cell(cell));
      ASSERT_EQ(std::vector<uint32_t>(labels, labels + p.capacity()), expected[cell]) << "cell " << cell;
    }
  }

  Propagation p;
  std::vector<uint32_t> inner;

 private:
  size_t bytes_ = 0;
  void* block_ = nullptr;
};

TEST(Propagation, FindsTheNearestJointsOfEveryCell) {
  std::mt19937 random(11);
  const auto below = [&](size_t n) { return static_cast<uint32_t>(random() % n); };
  // What the bounds of outside cells may rest on: all solid cells full without a step outside, some, or none.
  uint32_t all_full = 0, some_full = 0, none_full = 0, cells_corrected = 0;
  for (int round = 0; round < 100; ++round) {
    const uint32_t candidates = 1 + below(5);
    Field field(candidates, 16);
    std::array<int32_t, 3> size;
    for (int32_t& side : size) side = 3 + static_cast<int32_t>(below(16));
    // Large solid and outside regions with straight faces, some rounds with crumbs, so that both kinds of terrain
    // occur; or blocks apart from each other.
    const bool blocks = round % 2 == 0, crumbs = round % 3 == 0;
    const int32_t cut = static_cast<int32_t>(below(static_cast<size_t>(size[0])));
    std::vector<std::array<int32_t, 6>> boxes(blocks ? 1 + below(4) : 0);
    for (auto& box : boxes) {
      for (size_t axis = 0; axis < 3; ++axis) {
        box[axis] = static_cast<int32_t>(below(static_cast<size_t>(size[axis])));
        box[axis + 3] = box[axis] + static_cast<int32_t>(below(7));
      }
    }
    field.fill(size, [&](int32_t x, int32_t y, int32_t z) {
      bool outside = blocks || x < cut;
      for (const auto& box : boxes) {
        outside = outside && (x < box[0] || y < box[1] || z < box[2] || x > box[3] || y > box[4] || z > box[5]);
      }
      if (crumbs && below(8) == 0) outside = !outside;
      const uint32_t inside_or_surface = below(2);
      return outside ? sinew::kCellOutside : static_cast<sinew::CellState>(inside_or_surface);
    });
    const uint32_t joints = candidates + below(6);
    std::vector<Seed> seeds;
    const uint32_t gap = round % 5 == 4 ? 27000 + 1000 * below(6) : 0;  // joints far away, about what bounds can hold
    for (uint32_t joint = 0; joint < joints; ++joint) {
      for (uint32_t i = 0; i <= below(4); ++i) {  // some beyond a round of the buckets, many with ties
        seeds.push_back(
            {field.inner[below(field.inner.size())], joint, gap + (below(2) ? below(3) * 40 : below(3000))});
      }
    }
    for (const uint32_t capacity : {uint32_t{1}, candidates}) {
      const auto expected = expect(field.p.grid, seeds, joints, capacity);
      const auto solid_only = expect(field.p.grid, seeds, joints, capacity, true);
      field.run(seeds, capacity);
      ASSERT_NO_FATAL_FAILURE(field.expect_labels(expected)) << "round " << round;
      uint32_t solid = 0, full = 0;
      for (const uint32_t cell : field.inner) {
        if (field.p.grid.states[cell] > sinew::kCellSurface) continue;
        ++solid;
        full += solid_only[cell].size() == capacity;
        cells_corrected += solid_only[cell].size() == capacity && solid_only[cell] != expected[cell];
      }
      ++(full == solid ? all_full : full > 0 ? some_full : none_full);
    }
  }
  EXPECT_GT(all_full, 20u);
  EXPECT_GT(some_full, 20u);
  EXPECT_GT(none_full, 20u);
  EXPECT_GT(cells_corrected, 1000u);
}

TEST(Propagation, LeavesAWindingBodyForTheStraightWay) {
  Field field(2, 128);
  // One layer: lanes that join at alternate ends. 8,000 cells from end to end are farther than labels are followed.
  field.fill({130, 130, 3}, [](int32_t x, int32_t y, int32_t) {
    const bool joint = x == (y % 4 == 0 ? 128 : 1);
    return y % 2 == 1 || joint ? sinew::kCellSurface : sinew::kCellOutside;
  });
  const std::vector<Seed> seeds = {{field.p.grid.index(1, 1, 1), 0, 0}, {field.p.grid.index(2, 1, 1), 1, 0}};
  field.run(seeds, 2);
  field.expect_labels(expect(field.p.grid, seeds, 2, 2));
  EXPECT_GT(nearest(field.p.grid, seeds, 0, true)[field.p.grid.index(64, 127, 1)], 1u << 17);
}

}  // namespace
