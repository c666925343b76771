// SPDX-License-Identifier: MIT
// Seams as the C API tells them.
#ifndef SINEW_CHARACTER_CAPI_SEAMS_OF_HPP
#define SINEW_CHARACTER_CAPI_SEAMS_OF_HPP

#include <vector>

#include "sinew/character.h"
#include "sinew_character/bind/seams.hpp"

namespace sinew {

inline std::vector<sinew_character_seam> seams_of(const Seams& seams) {
  std::vector<sinew_character_seam> views;
  for (const Seam& seam : seams.seams)
    views.push_back({{static_cast<uint32_t>(seam.joints[0]), static_cast<uint32_t>(seam.joints[1])},
                     {seam.position.x, seam.position.y, seam.position.z},
                     static_cast<float>(seam.length)});
  return views;
}

}  // namespace sinew
#endif
