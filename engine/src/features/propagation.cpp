// SPDX-License-Identifier: MIT
// Label propagation: a bucket queue whose entries are cells, and chamfer steps pruned where the terrain is uniform.
#include "features/propagation.hpp"

namespace sinew {
namespace {

constexpr uint32_t kBuckets = 512;  // a power of two above the longest wait, 4 * 72 for a step and 159 for a layer
constexpr uint32_t kNever = 0xFFFFFFFFu;
constexpr uint32_t kReportEvery = 1u << 16;  // settled labels between two progress reports

}  // namespace

void Propagation::link(uint32_t cell, uint32_t ring) {
  next_[cell] = next_[ring];
  last_[cell] = ring;
  last_[next_[ring]] = cell;
  next_[ring] = cell;
  ++waiting_;
}

void Propagation::unlink(uint32_t cell) {
  next_[last_[cell]] = next_[cell];
  last_[next_[cell]] = last_[cell];
  --waiting_;
}

uint32_t Propagation::bucket_of(const Cell& cell, uint32_t label) const {
  return grid.cell_count + (turn_of(cell, label) & (kBuckets - 1));
}

// Offers a label that the cell's limit allows: kept while it is among the cell's nearest joints.
void Propagation::offer(uint32_t index, uint32_t label, uint8_t arrival) {
  Cell& cell = cells_[index];
  uint32_t* const row = labels_ + static_cast<size_t>(index) * capacity_;
  uint8_t* const ways = arrivals_ + static_cast<size_t>(index) * capacity_;
  const uint32_t joint = label & kJointMask;
  uint32_t at = 0;
  while (at < cell.found && (row[at] & kJointMask) != joint) ++at;
  if (at < cell.found) {
    if (row[at] <= label) return;
  } else if (cell.found < capacity_) {
    ++cell.found;
  } else {
    at = capacity_ - 1;  // takes the place of the farthest
  }
  for (; at > 0 && row[at - 1] > label; --at) {
    row[at] = row[at - 1];
    ways[at] = ways[at - 1];
  }
  row[at] = label;
  ways[at] = arrival;
  if (cell.found == capacity_) cell.limit = row[capacity_ - 1];
  if (at != cell.settled) return;
  if (next_[index] != index) unlink(index);
  link(index, bucket_of(cell, label));
}

void Propagation::offer_step(uint32_t index, uint32_t label, uint8_t way, bool dear) {
  const Step& step = steps_[way];
  const uint32_t neighbour = static_cast<uint32_t>(static_cast<int32_t>(index) + step.offset);
  const Cell& cell = cells_[neighbour];
  const uint32_t offered =
      label + (dear || (cell.terrain & kDear) != 0 ? kOutsideFactor * step.label_step : step.label_step);
  if (offered <= cell.limit) offer(neighbour, offered, way);
}

// From one solid cell to another that has outside cells around it.
void Propagation::spread_along_surface(uint32_t index, uint32_t label, uint8_t arrival) {
  const uint32_t solid = solid_[index];
  const uint32_t* const near = beside(arrival, false);
  const uint32_t* const far = beside(arrival, true);
  for (uint8_t way = 0; way < kStepCount; ++way) {
    const bool dear = (solid >> way & 1) == 0;
    const uint32_t others = dear ? far[way] : near[way];
    if (others != kAllSteps && (others & solid) == 0) offer_step(index, label, way, dear);
  }
}

// Passes one settled label on to the neighbours.
void Propagation::spread(uint32_t index, uint32_t label, uint8_t arrival) {
  const uint8_t terrain = cells_[index].terrain;
  const bool dear = (terrain & kDear) != 0;
  if (arrival != kEverywhere) {
    const Step& came = steps_[arrival];
    if ((terrain & kUniform) != 0) {
      for (uint8_t i = 0; i < came.next_count; ++i) offer_step(index, label, came.next[i], dear);
      return;
    }
    const uint8_t back = static_cast<uint8_t>(kStepCount - 1 - arrival);
    if ((solid_[index] >> back & 1) != 0) {
      spread_along_surface(index, label, arrival);
      return;
    }
  }
  for (uint8_t way = 0; way < kStepCount; ++way) offer_step(index, label, way, dear);
}

void Propagation::lay_steps() {
  uint8_t count = 0;
  for (int32_t z = -1; z <= 1; ++z) {
    for (int32_t y = -1; y <= 1; ++y) {
      for (int32_t x = -1; x <= 1; ++x) {
        const int axes = (x != 0) + (y != 0) + (z != 0);
        if (axes == 0) continue;
        along_[count][0] = static_cast<int8_t>(x);
        along_[count][1] = static_cast<int8_t>(y);
        along_[count][2] = static_cast<int8_t>(z);
        steps_[count].offset = (z * grid.size[1] + y) * grid.size[0] + x;
        steps_[count].label_step = kStepLengths[axes] << kJointBits;
        ++count;
      }
    }
  }
  for (uint8_t came = 0; came < kStepCount; ++came) {
    steps_[came].next_count = 0;
    for (uint8_t on = 0; on < kStepCount; ++on) {
      bool natural = true;  // `on` moves along no axis but those of `came`, and in the same sense
      for (int axis = 0; axis < 3; ++axis) {
        natural = natural && (along_[on][axis] == 0 || along_[on][axis] == along_[came][axis]);
      }
      if (natural) steps_[came].next[steps_[came].next_count++] = on;
    }
  }
}

// Everything is seen from c, which is solid, as is p.
void Propagation::lay_ways_beside() {
  struct Cells {
    int32_t x, y, z;
    // Length of the step in fortieths of a cell; 0 when it is none.
    uint32_t length() const {
      if (x < -1 || x > 1 || y < -1 || y > 1 || z < -1 || z > 1) return 0;
      return kStepLengths[(x != 0) + (y != 0) + (z != 0)];
    }
  };
  const auto cell_at = [this](uint8_t step) { return Cells{along_[step][0], along_[step][1], along_[step][2]}; };
  const auto between = [](Cells from, Cells to) { return Cells{to.x - from.x, to.y - from.y, to.z - from.z}; };
  for (uint8_t came = 0; came < kStepCount; ++came) {
    const Cells p = cell_at(static_cast<uint8_t>(kStepCount - 1 - came));
    const uint32_t to_c = cell_at(came).length();
    for (uint32_t dear = 0; dear < 2; ++dear) {
      const uint32_t factor = dear != 0 ? kOutsideFactor : 1;
      uint32_t* const row = beside_ + (2u * came + dear) * kStepCount;
      for (uint8_t on = 0; on < kStepCount; ++on) {
        const Cells n = cell_at(on);
        const uint32_t last = factor * n.length(), whole = to_c + last;
        const auto better = [whole, last](uint32_t other, uint32_t other_last) {
          return other < whole || (other == whole && other_last < last);
        };
        const uint32_t straight = factor * between(p, n).length();
        if (straight == 0 ? on == kStepCount - 1 - came : better(straight, straight)) {
          row[on] = kAllSteps;
          continue;
        }
        row[on] = 0;
        for (uint8_t step = 0; step < kStepCount; ++step) {
          const uint32_t first = between(p, cell_at(step)).length(), second = between(cell_at(step), n).length();
          if (first != 0 && second != 0 && better(first + factor * second, factor * second)) row[on] |= 1u << step;
        }
      }
    }
  }
}

bool Propagation::allocate(Arena& arena, const Counts& counts) {
  const size_t count = VoxelGrid::max_cells(counts);
  grid.allocate(arena, counts);
  cells_ = arena.alloc<Cell>(count);
  solid_ = arena.alloc<uint32_t>(count);
  beside_ = arena.alloc<uint32_t>(2 * kStepCount * kStepCount);
  labels_ = arena.alloc<uint32_t>(count * counts.candidates);  // count_layers() needs three bytes a cell
  arrivals_ = arena.alloc<uint8_t>(count * counts.candidates);
  next_ = arena.alloc<uint32_t>(count + kBuckets + 1);
  last_ = arena.alloc<uint32_t>(count + kBuckets + 1);
  return arena.ok();
}

// How many times the body must grow by a cell on all sides to reach a cell: bytes of 0 and 1, axis by axis.
void Propagation::count_layers() {
  const uint32_t count = grid.cell_count;
  const uint32_t strides[3] = {1, static_cast<uint32_t>(grid.size[0]),
                               static_cast<uint32_t>(grid.size[0] * grid.size[1])};
  // All three free until begin().
  uint8_t* reached = static_cast<uint8_t*>(static_cast<void*>(labels_));
  uint8_t* grown = reached + count;
  uint8_t* const layers = grown + count;
  for (uint32_t index = 0; index < count; ++index) {
    reached[index] = grid.states[index] <= kCellSurface;
    layers[index] = 0;
  }
  for (uint32_t layer = 0; layer < kMostLayers; ++layer) {
    for (uint32_t index = 0; index < count; ++index)
      layers[index] = static_cast<uint8_t>(layers[index] + 1 - reached[index]);
    for (const uint32_t stride : strides) {
      // Rows run into each other at the border, where nothing is solid: a cell may seem nearer than it is, which only
      // costs time.
      for (uint32_t index = 0; index < stride; ++index) grown[index] = reached[index];
      for (uint32_t index = stride; index < count - stride; ++index) {
        grown[index] = reached[index] | reached[index - stride] | reached[index + stride];
      }
      for (uint32_t index = count - stride; index < count; ++index) grown[index] = reached[index];
      uint8_t* const swapped = reached;
      reached = grown;
      grown = swapped;
    }
  }
  for (uint32_t index = 0; index < count; ++index) cells_[index].layers = layers[index];
}

void Propagation::survey() {
  lay_steps();
  lay_ways_beside();
  for (uint32_t index = 0; index < grid.cell_count; ++index) {
    const uint8_t state = grid.states[index];
    cells_[index].terrain = state == kCellOutside ? kDear | kUniform : 0;
    if (state > kCellSurface) continue;
    uint32_t solid = 0, outside = 0;
    for (uint32_t way = 0; way < kStepCount; ++way) {
      const uint8_t around = grid.states[static_cast<uint32_t>(static_cast<int32_t>(index) + steps_[way].offset)];
      solid |= static_cast<uint32_t>(around <= kCellSurface) << way;
      outside |= static_cast<uint32_t>(around == kCellOutside);
    }
    solid_[index] = solid;
    if (outside == 0) cells_[index].terrain = kUniform;
  }
  count_layers();
}

void Propagation::begin(uint32_t joint_capacity) {
  capacity_ = joint_capacity;
  waiting_ = 0;
  for (uint32_t cell = 0; cell < grid.cell_count; ++cell) {
    cells_[cell].limit = grid.states[cell] == kCellBorder ? 0 : kNever;
    cells_[cell].found = 0;
    cells_[cell].settled = 0;
  }
  for (uint32_t ring = 0; ring < grid.cell_count + kBuckets + 1; ++ring) {  // a cell linked to itself waits nowhere
    next_[ring] = ring;
    last_[ring] = ring;
  }
}

bool Propagation::run(const Progress& progress, uint32_t permille) {
  uint32_t missing = 0;
  for (uint32_t cell = 0; cell < grid.cell_count; ++cell) missing += (cells_[cell].terrain & kWanted) != 0 ? 1 : 0;
  uint32_t labels_settled = 0;
  const uint32_t ring = grid.cell_count + kBuckets;  // the bucket whose turn it is
  for (uint32_t turn = 0; missing > 0 && waiting_ > 0; ++turn) {
    const uint32_t bucket = grid.cell_count + (turn & (kBuckets - 1));
    if (next_[bucket] == bucket) continue;
    // Moves the bucket aside: cells whose turn is a whole round away go back into it.
    next_[ring] = next_[bucket];
    last_[ring] = last_[bucket];
    next_[last_[ring]] = ring;
    last_[next_[ring]] = ring;
    next_[bucket] = bucket;
    last_[bucket] = bucket;
    while (next_[ring] != ring) {
      const uint32_t index = next_[ring];
      unlink(index);
      Cell& cell = cells_[index];
      const uint32_t* const row = labels_ + static_cast<size_t>(index) * capacity_;
      if (turn_of(cell, row[cell.settled]) != turn) {
        link(index, bucket);
        continue;
      }
      next_[index] = index;
      // Nothing can still arrive at this distance: every step costs more than it saves of the wait.
      while (cell.settled < cell.found && turn_of(cell, row[cell.settled]) == turn) {
        const uint32_t label = row[cell.settled];
        spread(index, label, arrivals_[static_cast<size_t>(index) * capacity_ + cell.settled++]);
        if (++labels_settled % kReportEvery == 0 && !progress.report(permille)) return false;
      }
      if (cell.settled == capacity_) {
        missing -= (cell.terrain & kWanted) != 0 ? 1 : 0;
      } else if (cell.settled < cell.found && next_[index] == index) {
        link(index, bucket_of(cell, row[cell.settled]));
      }
    }
  }
  return true;
}

}  // namespace sinew
