// SPDX-License-Identifier: MIT
// Label propagation: a bucket queue whose entries are cells, and chamfer steps pruned where the terrain is uniform.
#include "features/propagation.hpp"

namespace sinew {
namespace {

constexpr uint32_t kBuckets = 512;  // a power of two above the longest step, 4 * 72
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

uint32_t Propagation::bucket_of(uint32_t label) const {
  return grid.cell_count + ((label >> kJointBits) & (kBuckets - 1));
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
  link(index, bucket_of(label));
}

void Propagation::offer_step(uint32_t index, uint32_t label, uint8_t way, bool dear) {
  const Step& step = steps_[way];
  const uint32_t neighbour = static_cast<uint32_t>(static_cast<int32_t>(index) + step.offset);
  const Cell& cell = cells_[neighbour];
  const uint32_t offered =
      label + (dear || (cell.terrain & kDear) != 0 ? kOutsideFactor * step.label_step : step.label_step);
  if (offered <= cell.limit) offer(neighbour, offered, way);
}

// Passes one settled label on to the neighbours.
void Propagation::spread(uint32_t index, uint32_t label, uint8_t arrival) {
  const bool dear = (cells_[index].terrain & kDear) != 0;
  if ((cells_[index].terrain & kUniform) != 0 && arrival != kEverywhere) {
    const Step& came = steps_[arrival];
    for (uint8_t i = 0; i < came.next_count; ++i) offer_step(index, label, came.next[i], dear);
  } else {
    for (uint8_t way = 0; way < kStepCount; ++way) offer_step(index, label, way, dear);
  }
}

void Propagation::lay_steps() {
  int32_t along[kStepCount][3];
  uint8_t count = 0;
  for (int32_t z = -1; z <= 1; ++z) {
    for (int32_t y = -1; y <= 1; ++y) {
      for (int32_t x = -1; x <= 1; ++x) {
        const int axes = (x != 0) + (y != 0) + (z != 0);
        if (axes == 0) continue;
        along[count][0] = x;
        along[count][1] = y;
        along[count][2] = z;
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
        natural = natural && (along[on][axis] == 0 || along[on][axis] == along[came][axis]);
      }
      if (natural) steps_[came].next[steps_[came].next_count++] = on;
    }
  }
}

bool Propagation::allocate(Arena& arena, const Counts& counts) {
  const size_t count = VoxelGrid::max_cells(counts);
  grid.allocate(arena, counts);
  cells_ = arena.alloc<Cell>(count);
  labels_ = arena.alloc<uint32_t>(count * counts.candidates);
  arrivals_ = arena.alloc<uint8_t>(count * counts.candidates);
  next_ = arena.alloc<uint32_t>(count + kBuckets + 1);
  last_ = arena.alloc<uint32_t>(count + kBuckets + 1);
  return arena.ok();
}

void Propagation::survey() {
  lay_steps();
  for (uint32_t index = 0; index < grid.cell_count; ++index) {
    cells_[index].wanted = 0;
    cells_[index].terrain = 0;
    if (grid.states[index] == kCellBorder) continue;
    const uint8_t dear = grid.states[index] == kCellOutside ? kDear : 0;
    bool uniform = true;
    for (const Step& step : steps_) {
      const uint8_t state = grid.states[static_cast<uint32_t>(static_cast<int32_t>(index) + step.offset)];
      uniform = uniform && (state == kCellBorder || (state == kCellOutside) == (dear != 0));
    }
    cells_[index].terrain = uniform ? dear | kUniform : dear;
  }
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
  for (uint32_t cell = 0; cell < grid.cell_count; ++cell) missing += cells_[cell].wanted;
  uint32_t labels_settled = 0;
  const uint32_t ring = grid.cell_count + kBuckets;  // the bucket whose turn it is
  for (uint32_t distance = 0; missing > 0 && waiting_ > 0; ++distance) {
    const uint32_t bucket = grid.cell_count + (distance & (kBuckets - 1));
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
      if (row[cell.settled] >> kJointBits != distance) {
        link(index, bucket);
        continue;
      }
      next_[index] = index;
      // Nothing can still arrive at this distance: every step is longer than 0.
      while (cell.settled < cell.found && row[cell.settled] >> kJointBits == distance) {
        const uint32_t label = row[cell.settled];
        spread(index, label, arrivals_[static_cast<size_t>(index) * capacity_ + cell.settled++]);
        if (++labels_settled % kReportEvery == 0 && !progress.report(permille)) return false;
      }
      if (cell.settled == capacity_) {
        missing -= cell.wanted;
      } else if (cell.settled < cell.found && next_[index] == index) {
        link(index, bucket_of(row[cell.settled]));
      }
    }
  }
  return true;
}

}  // namespace sinew
