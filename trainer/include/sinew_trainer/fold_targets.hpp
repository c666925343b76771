// SPDX-License-Identifier: MIT
// Reference weights as the yardstick's script reads them: dense rows in double, and end joints, unbound leaves that only mark
// where a bone ends, whose weight goes to their parents.
#ifndef SINEW_TRAINER_FOLD_TARGETS_HPP
#define SINEW_TRAINER_FOLD_TARGETS_HPP

#include <cstddef>
#include <cstdint>
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
DenseRows normalized_rows(const std::vector<std::vector<Influence>>& influences, size_t joint_count,
                          const std::string& name);

// Parent every end joint's weight folds to ([J], itself when it is none): a leaf that no reference vertex is bound to,
// and so on upwards. Throws Error when a parent does not exist.
std::vector<uint32_t> fold_targets(const Character& reference);
// The same for reference weights given as dense rows [V][J] with sums of 1.
std::vector<uint32_t> fold_targets(const Character& reference, const std::vector<std::vector<double>>& rows);

}  // namespace sinew
#endif
