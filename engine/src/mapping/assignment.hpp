// SPDX-License-Identifier: MIT
// The cheapest assignment of rows to columns, where both may stay alone (Kuhn 1955, by shortest augmenting paths).
#ifndef SINEW_MAPPING_ASSIGNMENT_HPP
#define SINEW_MAPPING_ASSIGNMENT_HPP

#include "core/arena.hpp"

namespace sinew::mapping {

struct Assignment {
  int32_t rows = 0, columns = 0;
  double* cost = nullptr;    // [rows x columns] filled by the caller
  int32_t* match = nullptr;  // [rows] column, -1 = none

  bool allocate(Arena& arena, uint32_t most_rows, uint32_t most_columns);
  double& at(int32_t row, int32_t column) { return cost[row * columns + column]; }
  // A row or column that stays alone costs `alone`.
  void solve(double alone);

 private:
  double price(int32_t row, int32_t column, double alone) const;
  // [columns + rows + 1]: a row's own column behind the others represents staying alone; index 0 is none.
  double* column_price_ = nullptr;
  double* least_ = nullptr;
  int32_t* owner_ = nullptr;
  int32_t* path_ = nullptr;
  uint8_t* used_ = nullptr;
  double* row_price_ = nullptr;  // [rows + 1]
};

}  // namespace sinew::mapping
#endif
