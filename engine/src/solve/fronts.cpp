// SPDX-License-Identifier: MIT
// Fronts of the nested dissection: their borders, the numeric factorisation, and solves that skip what no right-hand
// side of a batch reaches.
#include "solve/fronts.hpp"

#include <string.h>

#include "core/sort.hpp"

namespace sinew {
namespace {

constexpr int32_t kSmallestPivot = 1 << 10;  // Q30
constexpr int kWidestRange = 24;             // of the rows' exponents

// value / 2^shift rounded half up; a negative shift multiplies.
int64_t round_shifted(int64_t value, int shift) {
  if (shift <= 0) return static_cast<int64_t>(static_cast<uint64_t>(value) << (shift < -63 ? 63 : -shift));
  return round_shift(value, shift > 62 ? 62 : shift);
}

size_t triangle(size_t n) { return n * (n + 1) / 2; }

int64_t wrapping_multiply(int64_t a, int64_t b) {
  return static_cast<int64_t>(static_cast<uint64_t>(a) * static_cast<uint64_t>(b));
}

}  // namespace

bool FrontFactor::allocate(Arena& arena, const Counts& counts) {
  const size_t vertices = counts.vertices;
  size_t levels = 0, root = 1;
  for (size_t v = vertices; v > 1; v = (v + 1) / 2) ++levels;
  while (root * root < vertices) ++root;
  front_capacity_ = 3 * (counts.vertices / 8) + 64;
  row_capacity_ = 6 * vertices;
  factor_capacity_ = (20 + 3 * levels + levels * levels / 14) * vertices;
  height_capacity_ = 4 * root + 32;
  stack_capacity_ = 2 * height_capacity_ * height_capacity_ / 3 + 4 * vertices;
  fronts_ = arena.alloc<Front>(size_t{front_capacity_} + 1);
  rows_ = arena.alloc<uint32_t>(row_capacity_);
  waiting_ = arena.alloc<uint32_t>(front_capacity_);
  mark_ = arena.alloc<uint32_t>(vertices);
  front_of_ = arena.alloc<uint32_t>(vertices);
  exponent_ = arena.alloc<int8_t>(vertices);
  inverse_ = arena.alloc<int64_t>(vertices);
  factor_ = arena.alloc<int32_t>(factor_capacity_ + kFrontColumns * height_capacity_);  // kernels read whole blocks
  // The factorisation's stack lies where the solves' rows come later.
  const size_t shared = arena.mark();
  stack_ = arena.alloc<int32_t>(stack_capacity_);
  const size_t end = arena.used();
  arena.release(shared);
  (void)allocate_solve(arena, counts, &own_);
  if (arena.used() < end) (void)arena.alloc<uint8_t>(end - arena.used());
  return arena.ok();
}

bool FrontFactor::allocate_solve(Arena& arena, const Counts& counts, FrontSolve* solve) const {
  solve->rows = arena.alloc<int32_t>(height_capacity_ * kFrontBatch);
  solve->x = arena.alloc<int32_t>(static_cast<size_t>(counts.vertices) * kFrontBatch);
  solve->active = arena.alloc<uint8_t>(front_capacity_);
  return arena.ok();
}

// False when it does not fit.
bool FrontFactor::find_border(const SparseMatrix& matrix, uint32_t index, const uint32_t* children,
                              uint32_t child_count) {
  const Mesh& mesh = *matrix.mesh;
  const Ordering& ordering = *matrix.ordering;
  const Front& front = fronts_[index];
  const uint32_t end = front.first + front.pivots;
  size_t count = front.rows;
  const auto insert = [&](uint32_t position) {
    if (position < end || mark_[position] == index + 1) return true;
    if (count == row_capacity_) return false;
    mark_[position] = index + 1;
    rows_[count++] = position;
    return true;
  };
  for (uint32_t k = front.first; k < end; ++k) {
    const uint32_t v = ordering.order[k];
    for (uint32_t e = mesh.row_offsets[v]; e < mesh.row_offsets[v + 1]; ++e) {
      if (!insert(ordering.position[mesh.col_indices[e]])) return false;
    }
  }
  for (uint32_t i = 0; i < child_count; ++i) {
    const uint32_t child = children[i];
    for (uint32_t r = fronts_[child].rows; r < fronts_[child + 1].rows; ++r) {
      if (!insert(rows_[r])) return false;
    }
  }
  sort_ascending(rows_ + front.rows, count - front.rows);
  fronts_[index + 1].rows = static_cast<uint32_t>(count);
  return true;
}

bool FrontFactor::analyze(const SparseMatrix& matrix) {
  const Ordering& ordering = *matrix.ordering;
  front_count_ = 0;
  memset(mark_, 0, matrix.rows * sizeof(mark_[0]));
  uint32_t waiting = 0;
  size_t stacked = 0;
  fronts_[0].rows = 0;
  fronts_[0].factor = 0;
  for (uint32_t position = 0; position < matrix.rows;) {
    const uint32_t index = front_count_;
    if (index == front_capacity_) return false;
    Front& front = fronts_[index];
    front.first = position;
    front.pivots = ordering.region_size[position];
    front.subtree = index;
    uint32_t children = 0;
    size_t used = 0;
    front.parent = kNoFront;
    while (waiting > 0 && fronts_[waiting_[waiting - 1]].first >= ordering.region_begin[position]) {
      const uint32_t child = waiting_[--waiting];
      ++children;
      fronts_[child].parent = index;
      front.subtree = fronts_[child].subtree;
      used += triangle(border(child));
    }
    for (uint32_t k = 0; k < front.pivots; ++k) front_of_[position + k] = index;
    if (!find_border(matrix, index, waiting_ + waiting, children)) return false;
    const size_t rest = border(index), height = front.pivots + rest;
    fronts_[index + 1].factor = front.factor + front.pivots * height;
    if (height > height_capacity_ || fronts_[index + 1].factor > factor_capacity_ ||
        stacked + rest * rest > stack_capacity_) {
      return false;
    }
    stacked = stacked - used + triangle(rest);
    waiting_[waiting++] = index;
    position += front.pivots;
    ++front_count_;
  }
  return true;
}

bool FrontFactor::scale_rows(const SparseMatrix& matrix) {
  int lowest = 127, highest = -127;
  for (uint32_t k = 0; k < matrix.rows; ++k) {
    if (matrix.diagonal[k] <= 0) return false;
    const int above = top_bit(static_cast<uint64_t>(matrix.diagonal[k])) + 1 - matrix.matrix_bits;  // power of 2 above
    const int exponent = above >= 0 ? (above + 1) / 2 : -(-above / 2);
    exponent_[k] = static_cast<int8_t>(exponent);
    if (exponent < lowest) lowest = exponent;
    if (exponent > highest) highest = exponent;
  }
  if (highest - lowest > kWidestRange) return false;
  for (uint32_t index = 0; index < front_count_; ++index) {
    Front& front = fronts_[index];
    front.exponent = exponent_[front.first];
    for (uint32_t k = front.first; k < front.first + front.pivots; ++k)
      if (exponent_[k] > front.exponent) front.exponent = exponent_[k];
    for (uint32_t r = front.rows; r < fronts_[index + 1].rows; ++r)
      if (exponent_[rows_[r]] > front.exponent) front.exponent = exponent_[rows_[r]];
  }
  return true;
}

// The front's part of the matrix, into the columns of its pivots. mark_ holds the local number of every row.
void FrontFactor::fill(const SparseMatrix& matrix, const Front& front, uint32_t height, int32_t* columns) {
  const Mesh& mesh = *matrix.mesh;
  const Ordering& ordering = *matrix.ordering;
  memset(columns, 0, static_cast<size_t>(front.pivots) * height * sizeof(columns[0]));
  for (uint32_t k = 0; k < front.pivots; ++k) {
    const uint32_t position = front.first + k;
    int32_t* const column = columns + static_cast<size_t>(k) * height;
    const int exponent = exponent_[position];
    column[k] =
        static_cast<int32_t>(round_shifted(matrix.diagonal[position], matrix.matrix_bits + 2 * exponent - kFrontBits));
    const uint32_t v = ordering.order[position];
    for (uint32_t e = mesh.row_offsets[v]; e < mesh.row_offsets[v + 1]; ++e) {
      const uint32_t other = ordering.position[mesh.col_indices[e]];
      if (other < position) continue;
      const int64_t entry = round_shifted(matrix.weight(e), kEdgeWeightBits + exponent + exponent_[other] - kFrontBits);
      int32_t& target = column[mark_[other]];  // of a definite matrix below 1; of another it wraps
      target = static_cast<int32_t>(static_cast<uint32_t>(target) - static_cast<uint32_t>(entry));
    }
  }
}

// Adds what a child left of its border.
void FrontFactor::add_child(uint32_t child, const Front& front, uint32_t height, const int32_t* rest, int32_t* columns,
                            int32_t* corner) {
  const uint32_t* const rows = rows_ + fronts_[child].rows;
  const uint32_t count = border(child), below = height - front.pivots;
  for (uint32_t j = 0; j < count; ++j) {
    const uint32_t column = mark_[rows[j]];
    const bool own = column < front.pivots;
    const uint32_t skipped = own ? 0 : front.pivots;  // rows that the corner's columns do not have
    int32_t* const target = own ? columns + static_cast<size_t>(column) * height
                                : corner + static_cast<size_t>(column - front.pivots) * below;
    for (uint32_t i = j; i < count; ++i, ++rest) {
      int32_t& entry = target[mark_[rows[i]] - skipped];
      entry = static_cast<int32_t>(static_cast<uint32_t>(entry) + static_cast<uint32_t>(*rest));
    }
  }
}

bool FrontFactor::eliminate_pivots(const FrontKernels& kernels, const Front& front, uint32_t height, int32_t* columns) {
  for (uint32_t first = 0; first < front.pivots; first += kFrontColumns) {
    const uint32_t count = front.pivots - first < kFrontColumns ? front.pivots - first : kFrontColumns;
    int32_t* const block = columns + static_cast<size_t>(first) * height + first;
    if (first > 0) kernels.update(columns + first, height, first, count, height - first, block, height);
    for (uint32_t c = 0; c < count; ++c) {
      int32_t* const column = block + static_cast<size_t>(c) * height + c;
      if (c > 0) kernels.update(block + c, height, c, 1, height - first - c, column, height);
      if (column[0] < kSmallestPivot) return false;
      const int64_t root = isqrt64(static_cast<uint64_t>(column[0]) << kFrontBits);
      const int64_t inverse = (static_cast<int64_t>(1) << (2 * kFrontBits)) / root;
      inverse_[front.first + first + c] = inverse;
      column[0] = static_cast<int32_t>(root);
      for (uint32_t i = 1; i < height - first - c; ++i) {
        column[i] =
            clamp32(wrapping_add(wrapping_multiply(column[i], inverse), static_cast<int64_t>(1) << (kFrontBits - 1)) >>
                        kFrontBits,
                    -0x7FFFFFFF, 0x7FFFFFFF);
      }
    }
  }
  return true;
}

bool FrontFactor::factorise(const SparseMatrix& matrix, const FrontKernels& kernels) {
  if (!scale_rows(matrix)) return false;
  uint32_t waiting = 0;
  size_t stacked = 0;
  for (uint32_t index = 0; index < front_count_; ++index) {
    const Front& front = fronts_[index];
    const uint32_t below = border(index), height = front.pivots + below;
    for (uint32_t k = 0; k < front.pivots; ++k) mark_[front.first + k] = k;
    for (uint32_t r = 0; r < below; ++r) mark_[rows_[front.rows + r]] = front.pivots + r;
    int32_t* const columns = factor_ + front.factor;
    int32_t* const corner = stack_ + stacked;
    fill(matrix, front, height, columns);
    memset(corner, 0, static_cast<size_t>(below) * below * sizeof(corner[0]));
    while (waiting > 0 && waiting_[waiting - 1] >= front.subtree) {
      const uint32_t child = waiting_[--waiting];
      stacked -= triangle(border(child));
      add_child(child, front, height, stack_ + stacked, columns, corner);
    }
    if (!eliminate_pivots(kernels, front, height, columns)) return false;
    for (uint32_t j = 0; j < below; j += kFrontColumns) {
      const uint32_t count = below - j < kFrontColumns ? below - j : kFrontColumns;
      kernels.update(columns + front.pivots + j, height, front.pivots, count, below - j,
                     corner + static_cast<size_t>(j) * below + j, below);
    }
    // Downwards in memory, column by column, so nothing is overwritten before it is read.
    int32_t* rest = stack_ + stacked;
    for (uint32_t j = 0; j < below; ++j) {
      memmove(rest, corner + static_cast<size_t>(j) * below + j, (below - j) * sizeof(rest[0]));
      rest += below - j;
    }
    stacked += triangle(below);
    waiting_[waiting++] = index;
  }
  return true;
}

void FrontFactor::begin(const FrontSolve& solve) const { memset(solve.active, 0, front_count_); }

void FrontFactor::clear(const FrontSolve& solve, const Front& front) {
  memset(solve.x + static_cast<size_t>(front.first) * kFrontBatch, 0,
         static_cast<size_t>(front.pivots) * kFrontBatch * sizeof(solve.x[0]));
}

// A front that gets a right-hand side passes it on to those on its path to the root, its border's among them.
void FrontFactor::wake(const FrontSolve& solve, uint32_t index) const {
  for (; index != kNoFront && solve.active[index] == 0; index = fronts_[index].parent) {
    solve.active[index] = 1;
    clear(solve, fronts_[index]);
  }
}

void FrontFactor::add(const FrontSolve& solve, uint32_t position, uint32_t member, int64_t value_q40) const {
  wake(solve, front_of_[position]);
  solve.x[static_cast<size_t>(position) * kFrontBatch + member] =
      clamp32(round_shifted(value_q40, 40 - kFrontSolutionBits + 2 * exponent_[position]), -0x7FFFFFFF, 0x7FFFFFFF);
}

// v of the front's pivots, and what they take from its border.
void FrontFactor::eliminate_front(const FrontKernels& kernels, const FrontSolve& solve, uint32_t index) const {
  const Front& front = fronts_[index];
  const FrontRows rows = rows_of(solve, front);
  const uint32_t height = front.pivots + border(index);
  const int32_t* const columns = factor_ + front.factor;
  int64_t sums[kFrontColumns * kFrontBatch];
  for (uint32_t first = 0; first < front.pivots; first += kFrontColumns) {
    const uint32_t count = front.pivots - first < kFrontColumns ? front.pivots - first : kFrontColumns;
    // A column too many reads on into the border or the next column; its sums are not used.
    kernels.multiply(columns + first, 1, height, first, solve.rows, sums);
    kernels.solve(rows, columns + static_cast<size_t>(first) * height + first, height, front.first + first, count, true,
                  sums, solve.rows + first * kFrontBatch);
  }
  for (uint32_t first = front.pivots; first < height; first += kFrontColumns) {
    const uint32_t count = height - first < kFrontColumns ? height - first : kFrontColumns;
    kernels.multiply(columns + first, 1, height, front.pivots, solve.rows, sums);
    kernels.subtract(rows, rows_ + front.rows + first - front.pivots, count, sums);
  }
}

void FrontFactor::eliminate(const FrontKernels& kernels, const FrontSolve& solve) const {
  for (uint32_t index = 0; index < front_count_; ++index) {
    if (solve.active[index] != 0) eliminate_front(kernels, solve, index);
  }
}

bool FrontFactor::border_is_negligible(const FrontSolve& solve, uint32_t index) const {
  for (uint32_t r = fronts_[index].rows; r < fronts_[index + 1].rows; ++r) {
    const int32_t* const x = solve.x + static_cast<size_t>(rows_[r]) * kFrontBatch;
    uint32_t any = 0;
    for (uint32_t member = 0; member < kFrontBatch; ++member)
      any |= static_cast<uint32_t>(x[member] > kNegligible) | static_cast<uint32_t>(x[member] < -kNegligible);
    if (any != 0) return false;
  }
  return true;
}

void FrontFactor::substitute_front(const FrontKernels& kernels, const FrontSolve& solve, uint32_t index) const {
  const Front& front = fronts_[index];
  const FrontRows rows = rows_of(solve, front);
  const uint32_t height = front.pivots + border(index);
  const int32_t* const columns = factor_ + front.factor;
  if (solve.active[index] == 0) clear(solve, front);
  kernels.load(rows, rows_ + front.rows, height - front.pivots, solve.rows + front.pivots * kFrontBatch);
  int64_t sums[kFrontColumns * kFrontBatch];
  const uint32_t blocks = (front.pivots + kFrontColumns - 1) / kFrontColumns;
  for (uint32_t block = blocks; block-- > 0;) {
    const uint32_t first = block * kFrontColumns;
    const uint32_t end = first + kFrontColumns < front.pivots ? first + kFrontColumns : front.pivots;
    kernels.multiply(columns + static_cast<size_t>(first) * height + end, height, 1, height - end,
                     solve.rows + end * kFrontBatch, sums);
    kernels.solve(rows, columns + static_cast<size_t>(first) * height + first, height, front.first + first, end - first,
                  false, sums, solve.rows + first * kFrontBatch);
  }
}

}  // namespace sinew
