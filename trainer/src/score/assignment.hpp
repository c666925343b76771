// SPDX-License-Identifier: MIT
// The cheapest way to pair rows with columns.
#ifndef SINEW_TRAINER_SCORE_ASSIGNMENT_HPP
#define SINEW_TRAINER_SCORE_ASSIGNMENT_HPP

#include <cstddef>
#include <vector>

namespace sinew {

// Pairs each row with a column of its own, or each column with a row where there are fewer columns, at the least sum of
// costs. Returns the column of every row, -1 for a row that is left over. `cost` [rows x columns] finite.
// Shortest augmenting paths with dual prices: D. F. Crouse, On implementing 2D rectangular assignment algorithms, IEEE
// Trans. Aerospace and Electronic Systems 52 (2016), O(rows^2 columns). Of equally cheap pairings the one that
// scipy.optimize.linear_sum_assignment gives: skeletons are symmetric, ties are common.
std::vector<int> cheapest_pairs(const std::vector<double>& cost, size_t rows, size_t columns);

}  // namespace sinew
#endif
