// SPDX-License-Identifier: MIT
// One figure of several, with what touches it.
#ifndef SINEW_CHARACTER_PICTURE_OUTLINE_CHOOSE_PART_HPP
#define SINEW_CHARACTER_PICTURE_OUTLINE_CHOOSE_PART_HPP

#include <string>

#include "picture/outline/raster.hpp"

namespace sinew::picture {

struct ChosenPart {
  Mask mask;
  uint32_t count = 0, number = 0;  // figures from left to right
};
//   name    for messages
//   number  0: the largest
// Throws Error: nothing there, nothing large enough, many marks as of text, no figure of that number.
ChosenPart choose_part(const std::string& name, const Mask& mask, uint32_t number);

}  // namespace sinew::picture
#endif
