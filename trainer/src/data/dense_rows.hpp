// SPDX-License-Identifier: MIT
// Influences as dense rows in double, with the values and sums that the yardstick's script gets from the same files.
#ifndef SINEW_TRAINER_DATA_DENSE_ROWS_HPP
#define SINEW_TRAINER_DATA_DENSE_ROWS_HPP

#include <cstddef>
#include <string>
#include <vector>

#include "sinew_formats/character.hpp"

namespace sinew {

using DenseRows = std::vector<std::vector<double>>;  // [V][J]

constexpr double kInfluenceThreshold = 1e-4;  // a weight above it counts as an influence

// numpy's pairwise sum: eight running sums for up to 128 values, halves (of a multiple of 8) above that.
double numpy_sum(const double* values, size_t count);

// Rows with sum 1, or all zero. Weights that are not positive do not count; a joint named twice is added up. Throws
// Error with `name` when a weight belongs to a joint >= joint_count.
DenseRows normalised_rows(const std::vector<std::vector<Influence>>& influences, size_t joint_count,
                          const std::string& name);

}  // namespace sinew
#endif
