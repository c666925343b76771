// SPDX-License-Identifier: MIT
// Row after row enters by the shortest augmenting path; prices of rows and columns keep all other costs at least 0.
#include "mapping/assignment.hpp"

namespace sinew::mapping {
namespace {

constexpr double kNever = 1e30;

}  // namespace

bool Assignment::allocate(Arena& arena, uint32_t most_rows, uint32_t most_columns) {
  const size_t lines = size_t{most_rows} + most_columns + 1;
  cost = arena.alloc<double>(size_t{most_rows} * most_columns);
  match = arena.alloc<int32_t>(most_rows);
  column_price_ = arena.alloc<double>(lines);
  least_ = arena.alloc<double>(lines);
  owner_ = arena.alloc<int32_t>(lines);
  path_ = arena.alloc<int32_t>(lines);
  used_ = arena.alloc<uint8_t>(lines);
  row_price_ = arena.alloc<double>(size_t{most_rows} + 1);
  return arena.ok();
}

double Assignment::price(int32_t row, int32_t column, double alone) const {
  if (column < columns) return cost[row * columns + column];
  return column - columns == row ? 2 * alone : kNever;
}

void Assignment::solve(double alone) {
  const int32_t all = columns + rows;
  for (int32_t j = 0; j <= all; ++j) {
    column_price_[j] = 0;
    owner_[j] = 0;
    path_[j] = 0;
  }
  for (int32_t i = 0; i <= rows; ++i) row_price_[i] = 0;
  for (int32_t i = 1; i <= rows; ++i) {
    owner_[0] = i;
    int32_t column = 0;
    for (int32_t j = 0; j <= all; ++j) {
      least_[j] = 2 * kNever;
      used_[j] = 0;
    }
    do {
      used_[column] = 1;
      const int32_t row = owner_[column];
      double delta = 2 * kNever;
      int32_t next = 0;
      for (int32_t j = 1; j <= all; ++j) {
        if (used_[j] != 0) continue;
        const double left = price(row - 1, j - 1, alone) - row_price_[row] - column_price_[j];
        if (left < least_[j]) {
          least_[j] = left;
          path_[j] = column;
        }
        if (least_[j] < delta) {
          delta = least_[j];
          next = j;
        }
      }
      for (int32_t j = 0; j <= all; ++j) {
        if (used_[j] != 0) {
          row_price_[owner_[j]] += delta;
          column_price_[j] -= delta;
        } else {
          least_[j] -= delta;
        }
      }
      column = next;
    } while (owner_[column] != 0);
    while (column != 0) {
      owner_[column] = owner_[path_[column]];
      column = path_[column];
    }
  }
  for (int32_t i = 0; i < rows; ++i) match[i] = -1;
  for (int32_t j = 1; j <= columns; ++j) {
    if (owner_[j] != 0) match[owner_[j] - 1] = j - 1;
  }
}

}  // namespace sinew::mapping
