// SPDX-License-Identifier: MIT
// Limbs that are drawn in front of the body or beside it, in one outline with it.
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
  std::array<float, 2> body = {};            // center of the torso
};

// Cuts a slit into the mask between the body and each limb at the figure's border, so that the body does not follow
// the limb. A limb is assumed to be as thick on both sides of its bones as it is towards the border. Limbs in front
// of the body or separate from it are unchanged. Lists the limbs that were cut free in the figure's notes. Returns
// their number.
size_t free_limbs(const std::vector<DrawnLimb>& limbs, Figure* figure);

}  // namespace sinew
#endif
