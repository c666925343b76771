// SPDX-License-Identifier: MIT
// Which characters come next: families in proportion to n^power, the characters of a family equally.
#ifndef SINEW_TRAINER_DATA_FAMILY_QUEUE_HPP
#define SINEW_TRAINER_DATA_FAMILY_QUEUE_HPP

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "core/random.hpp"

namespace sinew {

// One round of about as many draws as there are characters, shuffled. `families` names the family of each character.
// Families in `shares` have that share of the round, the others divide the rest. The fraction of a draw that is left over
// is drawn by chance, so that shares are exact in the long run.
std::vector<uint32_t> draw_round(const std::vector<std::string>& families, double power,
                                 const std::map<std::string, double>& shares, Random* random);

}  // namespace sinew
#endif
