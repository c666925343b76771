// SPDX-License-Identifier: MIT
// End joints of a skeleton: unbound leaves that only mark where a bone ends.
#ifndef SINEW_TRAINER_FOLD_TARGETS_HPP
#define SINEW_TRAINER_FOLD_TARGETS_HPP

#include <cstdint>
#include <vector>

#include "sinew_formats/character.hpp"

namespace sinew {

// Parent every end joint's weight folds to ([J], itself when it is none): a leaf that no reference vertex is bound to,
// and so on upwards. Throws Error when a parent does not exist.
std::vector<uint32_t> fold_targets(const Character& reference);
// The same for reference weights given as dense rows [V][J] with sums of 1.
std::vector<uint32_t> fold_targets(const Character& reference, const std::vector<std::vector<double>>& rows);

}  // namespace sinew
#endif
