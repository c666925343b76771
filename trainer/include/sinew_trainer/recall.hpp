// SPDX-License-Identifier: MIT
// How much of the reference weight a network could reach at all: what lies on no candidate is lost before it starts.
#ifndef SINEW_TRAINER_RECALL_HPP
#define SINEW_TRAINER_RECALL_HPP

#include <cstdint>
#include <vector>

#include "sinew_formats/character.hpp"

namespace sinew {

// For each K of `ks` (1..SINEW_MAX_CANDIDATES): the mean over bound vertices of the share of reference weight on
// the K candidates the network would choose from, end markers counted as their parents. `grid` is the voxel grid's
// longest side. Throws Error when the character cannot be bound or has no weights.
std::vector<double> candidate_recall(const Character& character, const std::vector<uint32_t>& ks, uint32_t grid);

}  // namespace sinew
#endif
