// SPDX-License-Identifier: MIT
// Two lists of joints side by side, in their order: the cheapest alignment by dynamic programming.
#ifndef SINEW_MAPPING_ALIGN_HPP
#define SINEW_MAPPING_ALIGN_HPP

#include "core/arena.hpp"

namespace sinew::mapping {

struct Aligner {
  double* row = nullptr;     // [2 x (columns + 1)] costs of two rows of the table
  uint8_t* moves = nullptr;  // [(rows + 1) x (columns + 1)]
  int32_t* match = nullptr;  // [rows] the best alignment so far: column, -1 = none

  bool allocate(Arena& arena, uint32_t most_rows, uint32_t most_columns) {
    row = arena.alloc<double>(2 * (size_t{most_columns} + 1));
    moves = arena.alloc<uint8_t>((size_t{most_rows} + 1) * (size_t{most_columns} + 1));
    match = arena.alloc<int32_t>(most_rows);
    return arena.ok();
  }

  // Aligns rows with columns; what is left out costs `skip`. Leaves `match` and returns the cost.
  //   cost(i, j)  of putting row i and column j side by side
  template <class Cost>
  double run(int32_t rows, int32_t columns, double skip, const Cost& cost) {
    const double total = fill(rows, columns, skip, cost);
    take(rows, columns);
    return total;
  }
  // Only the cost, and the table for take().
  template <class Cost>
  double fill(int32_t rows, int32_t columns, double skip, const Cost& cost) {
    const size_t width = static_cast<size_t>(columns) + 1;
    double* before = row;
    double* now = row + width;
    for (int32_t i = 0; i <= rows; ++i) {
      uint8_t* const move = moves + static_cast<size_t>(i) * width;
      for (int32_t j = 0; j <= columns; ++j) {
        double best = i == 0 && j == 0 ? 0 : 1e300;
        uint8_t how = kBoth;
        if (i > 0 && j > 0) best = before[j - 1] + cost(i - 1, j - 1);
        if (i > 0 && before[j] + skip < best) {
          best = before[j] + skip;
          how = kRowAlone;
        }
        if (j > 0 && now[j - 1] + skip < best) {
          best = now[j - 1] + skip;
          how = kColumnAlone;
        }
        now[j] = best;
        move[j] = how;
      }
      double* const swap = before;
      before = now;
      now = swap;
    }
    return before[columns];
  }
  void take(int32_t rows, int32_t columns) {
    const size_t width = static_cast<size_t>(columns) + 1;
    for (int32_t i = 0; i < rows; ++i) match[i] = -1;
    while (rows > 0 || columns > 0) {
      const uint8_t how = moves[static_cast<size_t>(rows) * width + static_cast<size_t>(columns)];
      if (how == kBoth) match[rows - 1] = columns - 1;
      if (how != kColumnAlone) --rows;
      if (how != kRowAlone) --columns;
    }
  }

 private:
  enum : uint8_t { kBoth, kRowAlone, kColumnAlone };
};

}  // namespace sinew::mapping
#endif
