// SPDX-License-Identifier: MIT
// Limbs that a picture shows in front of the body or beside it, in one outline with it.
#ifndef SINEW_CHARACTER_FREE_LIMBS_HPP
#define SINEW_CHARACTER_FREE_LIMBS_HPP

#include <array>
#include <string>
#include <vector>

#include "sinew_character/picture/figure.hpp"

namespace sinew {

// Bones of a limb in pixels of a figure's mask, y down.
struct DrawnLimb {
  std::string name;
  std::vector<std::array<float, 2>> points;  // from the body to the limb's end
  std::array<float, 2> body = {};            // the middle of the trunk
};

// Opens a slit in the mask between each limb and the body where the limb lies at the figure's border and the body right beside it, so that
// the body does not follow the limb. As thick as a limb is from its bones to the border, so thick it is taken for. Limbs that lie before
// the body, or free of it, stay as they are. Says which limbs it has cut free in figure's notes. Returns how many.
size_t free_limbs(const std::vector<DrawnLimb>& limbs, Figure* figure);

}  // namespace sinew
#endif
