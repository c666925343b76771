// SPDX-License-Identifier: MIT
// Which characters come next: families in proportion to n^power, the characters of a family equally.
#ifndef SINEW_TRAINER_DATA_FAMILY_QUEUE_HPP
#define SINEW_TRAINER_DATA_FAMILY_QUEUE_HPP

#include <cstdint>
#include <string>
#include <vector>

#include "core/random.hpp"

namespace sinew {

// One round of about as many draws as there are characters, shuffled. `families` names the family of each character.
// A family's quota is its share of the round; the fraction left over is drawn, so that shares are exact in the long
// run.
std::vector<uint32_t> draw_round(const std::vector<std::string>& families, double power, Random* random);

}  // namespace sinew
#endif
