// SPDX-License-Identifier: MIT
// A dressed character taken apart: the body, and the cloth that lies around it.
#ifndef SINEW_SCORE_DRESSED_HPP
#define SINEW_SCORE_DRESSED_HPP

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "bends.hpp"
#include "sinew_formats/character.hpp"

namespace sinew {

struct Dressed {
  Character body, garment;  // both with the joints of the whole; the body with its weights, the garment without
  std::vector<std::pair<const Bend*, size_t>> bends;  // those of report_bends() that lie under cloth, and their joints
};

// A connected part is cloth when at some bend it lies around a part that lies around the bone: rays from the bone, across it, all meet
// both, and it farther away. What is not cloth is the body. nullopt when there is no cloth, no weights, or no joint that names tell.
std::optional<Dressed> take_apart(const Character& character);

}  // namespace sinew
#endif
