// SPDX-License-Identifier: MIT
// Label propagation: a bucket queue whose entries are cells, chamfer steps pruned by the terrain, and outside cells
// entered only as far as a label can still come back in time.
#include "candidates/propagation.hpp"

#include <string.h>

namespace sinew {
namespace {

constexpr uint32_t kReportEvery = 1u << 16;  // labels passed on between two progress reports

// Upper bound of the labels of a solid cell.
constexpr uint32_t kFarthest = make_label((1u << 17) - 1, kJointMask);

// Bounds are distances in int16: those of a grid of 64 cells stay below 10,000. Where one does not fit, outside cells
// are entered at any distance.
constexpr int16_t kAnyDistance = INT16_MAX;
constexpr int16_t kClosed = -30000;  // a step below it still fits
constexpr int32_t kLargestBound = 29000;

}  // namespace

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
  for (uint8_t incoming = 0; incoming < kStepCount; ++incoming) {
    steps_[incoming].next = 0;
    for (uint8_t on = 0; on < kStepCount; ++on) {
      bool natural = true;  // `on` moves along no axis but those of `incoming`, and in the same sense
      for (int axis = 0; axis < 3; ++axis) {
        natural = natural && (along_[on][axis] == 0 || along_[on][axis] == along_[incoming][axis]);
      }
      if (natural) steps_[incoming].next |= 1u << on;
    }
  }
}

// Everything is seen from c, which is solid, as is p.
void Propagation::lay_directions_beside() {
  uint8_t lengths[kStepCount][kStepCount];  // of the step from where one step leads to where another does; 0 when none
  for (uint8_t from = 0; from < kStepCount; ++from) {
    for (uint8_t to = 0; to < kStepCount; ++to) {
      int axes = 0;
      for (int axis = 0; axis < 3; ++axis) {
        const int move = along_[to][axis] - along_[from][axis];
        axes = move < -1 || move > 1 || axes == 4 ? 4 : axes + (move != 0);
      }
      lengths[from][to] = static_cast<uint8_t>(axes == 4 ? 0 : kStepLengths[axes]);
    }
  }
  for (uint8_t incoming = 0; incoming < kStepCount; ++incoming) {
    const uint8_t p = static_cast<uint8_t>(kStepCount - 1 - incoming);
    for (uint32_t costly = 0; costly < 2; ++costly) {
      const uint32_t factor = costly != 0 ? kOutsideFactor : 1;
      uint32_t* const others = beside_ + (2u * incoming + costly) * kStepCount;
      left_[incoming][costly] = 0;
      for (uint8_t n = 0; n < kStepCount; ++n) {
        const uint32_t last = factor * (steps_[n].label_step >> kJointBits);
        const uint32_t whole = (steps_[incoming].label_step >> kJointBits) + last;
        const auto better = [whole, last](uint32_t other, uint32_t other_last) {
          return other < whole || (other == whole && other_last < last);
        };
        const uint32_t straight = factor * lengths[p][n];
        if (straight == 0 ? n == p : better(straight, straight)) continue;
        left_[incoming][costly] |= 1u << n;
        others[n] = 0;
        for (uint8_t q = 0; q < kStepCount; ++q) {
          const uint32_t first = lengths[p][q], second = factor * lengths[q][n];
          if (first != 0 && second != 0 && better(first + second, second)) others[n] |= 1u << q;
        }
      }
    }
  }
}

bool Propagation::allocate(Arena& arena, const Counts& counts) {
  const size_t count = VoxelGrid::max_cells(counts), side = counts.cells_along(counts.vertices),
               inner = side * side * side;
  row_size_ = counts.candidates;
  cell_bytes_ = (static_cast<uint32_t>(sizeof(Cell)) + 5 * row_size_ + 3) & ~3u;
  grid.allocate(arena, counts);
  numbers_ = arena.alloc<uint32_t>(count);
  bounds_ = arena.alloc<int16_t>(count);
  beside_ = arena.alloc<uint32_t>(2 * kStepCount * kStepCount);
  block_ = arena.alloc<uint8_t>((inner + 1) * cell_bytes_);
  return arena.ok();
}

uint32_t Propagation::add_cell(uint32_t grid_index, uint8_t terrain) {
  const uint32_t number = ++cell_count_;
  Cell& cell = at(number);
  cell.grid_index = grid_index;
  cell.solid = 0;
  cell.terrain = terrain;
  cell.unused = 0;
  empty(&cell);
  numbers_[grid_index] = number;
  return number;
}

void Propagation::empty(Cell* cell) const {
  cell->limit = kFarthest;
  cell->last = 0;
  cell->found = 0;
  cell->settled = 0;
}

void Propagation::survey() {
  lay_steps();
  lay_directions_beside();
  cell_count_ = 0;
  memset(numbers_, 0, grid.cell_count * sizeof(uint32_t));
  const int32_t nx = grid.size[0], ny = grid.size[1];
  for (int32_t z = 1; z < grid.size[2] - 1; ++z) {
    for (int32_t y = 1; y < ny - 1; ++y) {
      for (uint32_t grid_index = grid.index(1, y, z); grid_index < grid.index(nx - 1, y, z); ++grid_index) {
        if (grid.states[grid_index] > kCellSurface) continue;
        uint32_t solid = 0, outside = 0;
        for (uint32_t direction = 0; direction < kStepCount; ++direction) {
          const uint8_t around =
              grid.states[static_cast<uint32_t>(static_cast<int32_t>(grid_index) + steps_[direction].offset)];
          solid |= static_cast<uint32_t>(around <= kCellSurface) << direction;
          outside |= around == kCellOutside;
        }
        at(add_cell(grid_index, outside != 0 ? kSurface : 0)).solid = solid;
      }
    }
  }
  solid_count_ = cell_count_;
}

void Propagation::begin(uint32_t capacity) {
  capacity_ = capacity;
  waiting_ = 0;
  passed_on_ = 0;
  edge_ = kCostly | kBeside;
  for (; cell_count_ > solid_count_; --cell_count_) numbers_[at(cell_count_).grid_index] = 0;
  for (uint32_t grid_index = 0; grid_index < grid.cell_count; ++grid_index) bounds_[grid_index] = kClosed;
  for (uint32_t number = 1; number <= solid_count_; ++number) {
    Cell& cell = at(number);
    empty(&cell);
    cell.terrain &= kSurface;
    bounds_[cell.grid_index] = kAnyDistance;
  }
  for (uint32_t& head : heads_) head = 0;
}

void Propagation::seed(uint32_t grid_index, uint32_t label) {
  if (numbers_[grid_index] == 0) {  // outside
    add_cell(grid_index, kCostly);
    bounds_[grid_index] = kAnyDistance;
    for (const Step& step : steps_) {
      const uint32_t around = numbers_[static_cast<uint32_t>(static_cast<int32_t>(grid_index) + step.offset)];
      if (around != 0) at(around).terrain |= kBeside;
    }
  }
  if (label <= at(numbers_[grid_index]).limit) offer(numbers_[grid_index], label, kEverywhere);
}

void Propagation::link(uint32_t number, uint32_t bucket) {
  Cell& cell = at(number);
  cell.next = heads_[bucket];
  cell.last = kHead | bucket;
  if (cell.next != 0) at(cell.next).last = number;
  heads_[bucket] = number;
  ++waiting_;
}

void Propagation::unlink(Cell* cell) {
  if ((cell->last & kHead) != 0) {
    heads_[cell->last & ~kHead] = cell->next;
  } else {
    at(cell->last).next = cell->next;
  }
  if (cell->next != 0) at(cell->next).last = cell->last;
  cell->last = 0;
  --waiting_;
}

// Offers a label that the cell's limit allows: kept while it is among the cell's nearest joints.
void Propagation::offer(uint32_t number, uint32_t label, uint8_t arrival) {
  Cell& cell = at(number);
  uint32_t* const labels = row(cell);
  uint8_t* const directions = arrivals(cell);
  const uint32_t joint = label & kJointMask;
  uint32_t grid_index = 0;
  while (grid_index < cell.found && (labels[grid_index] & kJointMask) != joint) ++grid_index;
  if (grid_index < cell.found) {
    if (labels[grid_index] <= label) return;
  } else if (cell.found < capacity_) {
    ++cell.found;
  } else {
    grid_index = capacity_ - 1;  // replaces the farthest
  }
  for (; grid_index > 0 && labels[grid_index - 1] > label; --grid_index) {
    labels[grid_index] = labels[grid_index - 1];
    directions[grid_index] = directions[grid_index - 1];
  }
  labels[grid_index] = label;
  directions[grid_index] = arrival;
  if (cell.found == capacity_ && labels[capacity_ - 1] < cell.limit) cell.limit = labels[capacity_ - 1];
  if (grid_index > cell.settled) return;
  cell.settled = static_cast<uint8_t>(grid_index);
  if (cell.last != 0) unlink(&cell);
  link(number, round_of(label) & (kBuckets - 1));
}

// Whether a cell's bound allows a label.
bool Propagation::enters(uint32_t grid_index, uint32_t label) const {
  const int16_t bound = bounds_[grid_index];
  return static_cast<int32_t>(label >> kJointBits) <= bound || bound == kAnyDistance;
}

// Offers a label to solid cells around a solid one.
void Propagation::offer_solid(uint32_t grid_index, uint32_t label, uint32_t directions) {
  for (; directions != 0; directions &= directions - 1) {
    const int direction = low_bit(directions);
    const uint32_t number =
        numbers_[static_cast<uint32_t>(static_cast<int32_t>(grid_index) + steps_[direction].offset)];
    const uint32_t offered = label + steps_[direction].label_step;
    if (offered <= at(number).limit) offer(number, offered, static_cast<uint8_t>(direction));
  }
}

// Offers a label to cells around, where one of both is outside.
void Propagation::offer_costly(uint32_t grid_index, uint32_t label, uint32_t directions) {
  for (; directions != 0; directions &= directions - 1) {
    const int direction = low_bit(directions);
    const uint32_t neighbor = static_cast<uint32_t>(static_cast<int32_t>(grid_index) + steps_[direction].offset);
    const uint32_t offered = label + kOutsideFactor * steps_[direction].label_step;
    if (!enters(neighbor, offered)) continue;
    uint32_t number = numbers_[neighbor];
    if (number == 0) number = add_cell(neighbor, kCostly);
    if (offered <= at(number).limit) offer(number, offered, static_cast<uint8_t>(direction));
  }
}

// The steps from a solid cell with outside cells around, reached by `arrival` from another solid cell, that
// are left. costly: 1 when they lead outside.
uint32_t Propagation::directions_beside(uint32_t directions, uint32_t solid, uint8_t arrival, uint32_t costly) const {
  const uint32_t* const others = beside_ + (2u * arrival + costly) * kStepCount;
  uint32_t kept = 0;
  for (directions &= left_[arrival][costly]; directions != 0; directions &= directions - 1) {
    const int direction = low_bit(directions);
    kept |= static_cast<uint32_t>((others[direction] & solid) == 0) << direction;
  }
  return kept;
}

// Passes a label on to the neighbors that the steps lead to: `solid` from one solid cell to others, `costly` where
// one of both is outside.
void Propagation::spread(const Cell& from, uint32_t label, uint8_t arrival, uint32_t solid, uint32_t costly) {
  if (arrival != kEverywhere) {
    if ((from.terrain & kSurface) == 0) {
      solid &= steps_[arrival].next;
      costly &= steps_[arrival].next;
    } else if ((from.solid >> (kStepCount - 1 - arrival) & 1) != 0) {
      solid = directions_beside(solid, from.solid, arrival, 0);
      if (costly != 0) costly = directions_beside(costly, from.solid, arrival, 1);
    }
  }
  offer_solid(from.grid_index, label, solid);
  offer_costly(from.grid_index, label, costly);
}

// Passes labels on by distance until none is left.
bool Propagation::settle(const Progress& progress, uint32_t permille) {
  for (uint32_t round = 0; waiting_ > 0; ++round) {
    const uint32_t bucket = round & (kBuckets - 1);
    if (heads_[bucket] == 0) continue;
    // Moves the bucket aside: cells that are due a whole round later go back into it.
    heads_[kBuckets] = heads_[bucket];
    at(heads_[kBuckets]).last = kHead | kBuckets;
    heads_[bucket] = 0;
    while (heads_[kBuckets] != 0) {
      const uint32_t number = heads_[kBuckets];
      Cell& cell = at(number);
      unlink(&cell);
      const uint32_t* const labels = row(cell);
      uint8_t* const directions = arrivals(cell);
      while (cell.settled < cell.found && round_of(labels[cell.settled]) == round) {
        const uint32_t label = labels[cell.settled];
        const uint8_t arrival = directions[cell.settled];
        directions[cell.settled++] |= kPassedOn;
        while (cell.settled < cell.found && (directions[cell.settled] & kPassedOn) != 0) ++cell.settled;
        spread(cell, label, arrival, cell.solid, (cell.terrain & edge_) != 0 ? kAllSteps & ~cell.solid : 0);
        if (++passed_on_ % kReportEvery == 0 && !progress.report(permille)) return false;
      }
      if (cell.settled < cell.found) link(number, round_of(labels[cell.settled]) & (kBuckets - 1));
    }
  }
  return true;
}

// Makes every bound the largest of its own and the others less the distance from there, outside throughout: a chamfer
// distance transform in two passes (Borgefors 1986).
void Propagation::spread_bounds() {
  const int32_t nx = grid.size[0], ny = grid.size[1], nz = grid.size[2];
  constexpr uint8_t kHalf = kStepCount / 2, kAlong = kHalf - 1;  // steps to cells before; the last one goes along x
  for (int pass = 0; pass < 2; ++pass) {
    for (int32_t i = 0; i < (ny - 2) * (nz - 2); ++i) {
      const int32_t at = pass == 0 ? i : (ny - 2) * (nz - 2) - 1 - i;
      int16_t* const bounds = bounds_ + grid.index(0, at % (ny - 2) + 1, at / (ny - 2) + 1);
      for (uint8_t s = 0; s < kAlong; ++s) {
        const Step& step = steps_[pass == 0 ? s : kStepCount - 1 - s];
        const int16_t* const others = bounds + step.offset;
        const int32_t length = static_cast<int32_t>(kOutsideFactor * (step.label_step >> kJointBits));
        for (int32_t x = 1; x < nx - 1; ++x) {
          const int16_t other = static_cast<int16_t>(others[x] - length);
          bounds[x] = other > bounds[x] ? other : bounds[x];
        }
      }
      const int32_t sense = pass == 0 ? 1 : -1;
      for (int32_t x = pass == 0 ? 1 : nx - 2; x > 0 && x < nx - 1; x += sense) {
        const int32_t other = bounds[x - sense] - static_cast<int32_t>(kOutsideFactor * kStepLengths[1]);
        if (other > bounds[x]) bounds[x] = static_cast<int16_t>(other);
      }
    }
  }
}

// The distance beyond which no label of an outside cell can reach a solid cell in time to be among its nearest K. False
// when none can.
bool Propagation::bound_outside() {
  const auto clear = [this](int16_t value) {
    for (uint32_t grid_index = 0; grid_index < grid.cell_count; ++grid_index) {
      if (grid.states[grid_index] == kCellOutside) bounds_[grid_index] = value;
    }
  };
  if (kSmallCode) {  // for small grids, which have few cells outside: 2 % more work in a bind, half a kilobyte less
                     // code
    clear(kAnyDistance);
    return true;
  }
  clear(kClosed);
  bool all_full = true;
  for (uint32_t number = 1; number <= cell_count_; ++number) {
    const Cell& cell = at(number);
    const int32_t farthest = static_cast<int32_t>(cell.limit >> kJointBits);
    const bool full = cell.found == capacity_ && farthest <= kLargestBound;
    bounds_[cell.grid_index] = full ? static_cast<int16_t>(-farthest) : kClosed;
    all_full = all_full && (full || number > solid_count_);
  }
  // A cell has no label farther than those of a full cell that walk to it straight.
  if (!all_full) spread_bounds();
  clear(kClosed);
  int16_t largest = 0;
  for (uint32_t number = 1; number <= solid_count_; ++number) {
    int16_t& bound = bounds_[at(number).grid_index];
    bound = static_cast<int16_t>(-bound);
    if (bound > largest) largest = bound;
  }
  constexpr int32_t kOutAndBack = 2 * kOutsideFactor * kStepLengths[1];
  if (largest < kOutAndBack) return false;
  spread_bounds();
  for (uint32_t number = 1; number <= solid_count_; ++number) bounds_[at(number).grid_index] = kAnyDistance;
  if (largest > kLargestBound) clear(kAnyDistance);
  return true;
}

// Passes on a cell's labels to the outside cells around it, as settle() did not yet.
void Propagation::leave(Cell* cell) {
  const uint32_t* const labels = row(*cell);
  const uint8_t* const directions = arrivals(*cell);
  uint32_t open = 0;  // to its nearest label
  for (uint32_t all = kAllSteps & ~cell->solid; all != 0; all &= all - 1) {
    const int direction = low_bit(all);
    const uint32_t neighbor = static_cast<uint32_t>(static_cast<int32_t>(cell->grid_index) + steps_[direction].offset);
    if (enters(neighbor, labels[0] + kOutsideFactor * steps_[direction].label_step)) open |= 1u << direction;
  }
  for (uint32_t k = 0; open != 0 && k < cell->found; ++k) {
    if ((directions[k] & kPassedOn) != 0)
      spread(*cell, labels[k], directions[k] & static_cast<uint8_t>(~kPassedOn), 0, open);
  }
}

bool Propagation::run(const Progress& progress, uint32_t permille) {
  if (!settle(progress, permille)) return false;
  if (!bound_outside()) return true;
  edge_ = kCostly | kSurface;
  const uint32_t entered = cell_count_;
  for (uint32_t number = 1; number <= entered; ++number) {
    Cell& cell = at(number);
    if (cell.found > 0 && (cell.terrain & edge_) != 0) leave(&cell);
  }
  return settle(progress, permille);
}

}  // namespace sinew
