// SPDX-License-Identifier: MIT
// Rectangular assignment by shortest augmenting paths.
#include "score/assignment.hpp"

#include <limits>
#include <utility>

namespace sinew {
namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();

// At most as many rows as columns. Prices stay such that no reduced cost is negative and those of pairs are 0.
class Pairing {
 public:
  Pairing(const std::vector<double>& cost, size_t rows, size_t columns)
      : cost_(cost),
        row_prices_(rows, 0),
        column_prices_(columns, 0),
        column_of_(rows, -1),
        row_of_(columns, -1),
        before_(columns, -1) {
    for (size_t row = 0; row < rows; ++row) add(row);
  }

  std::vector<int> columns_of_rows() && { return std::move(column_of_); }
  std::vector<int> rows_of_columns() && { return std::move(row_of_); }

 private:
  // Finds the shortest path from the row to a free column, over pairs that it would change, and changes them.
  void add(size_t start) {
    const size_t columns = row_of_.size();
    std::vector<double> distance(columns, kFar);
    std::vector<size_t> reached_rows, reached_columns, open;
    // From the last to the first, and a column that is free before one that is not: the order settles ties.
    for (size_t column = columns; column-- > 0;) open.push_back(column);
    size_t row = start, end = columns;
    double reach = 0;
    while (end == columns) {
      reached_rows.push_back(row);
      size_t next = 0;
      double least = kFar;
      for (size_t k = 0; k < open.size(); ++k) {
        const size_t column = open[k];
        const double through = reach + cost_[row * columns + column] - row_prices_[row] - column_prices_[column];
        if (through < distance[column]) {
          distance[column] = through;
          before_[column] = static_cast<int>(row);
        }
        if (distance[column] < least || (distance[column] == least && row_of_[column] < 0)) {
          least = distance[column];
          next = k;
        }
      }
      reach = least;
      const size_t column = open[next];
      open[next] = open.back();
      open.pop_back();
      reached_columns.push_back(column);
      if (row_of_[column] < 0)
        end = column;
      else
        row = static_cast<size_t>(row_of_[column]);
    }
    for (const size_t reached : reached_rows)
      row_prices_[reached] += reached == start ? reach : reach - distance[static_cast<size_t>(column_of_[reached])];
    for (const size_t reached : reached_columns) column_prices_[reached] -= reach - distance[reached];
    for (int column = static_cast<int>(end); column >= 0;) {
      const int giver = before_[static_cast<size_t>(column)];
      row_of_[static_cast<size_t>(column)] = giver;
      std::swap(column_of_[static_cast<size_t>(giver)], column);
    }
  }

  const std::vector<double>& cost_;
  std::vector<double> row_prices_, column_prices_;
  std::vector<int> column_of_, row_of_;  // the pairs, -1 = none
  std::vector<int> before_;              // row from which the path came to a column
};

}  // namespace

std::vector<int> cheapest_pairs(const std::vector<double>& cost, size_t rows, size_t columns) {
  if (rows <= columns) return Pairing(cost, rows, columns).columns_of_rows();
  std::vector<double> turned(cost.size());
  for (size_t row = 0; row < rows; ++row)
    for (size_t column = 0; column < columns; ++column) turned[column * rows + row] = cost[row * columns + column];
  return Pairing(turned, columns, rows).rows_of_columns();
}

}  // namespace sinew
