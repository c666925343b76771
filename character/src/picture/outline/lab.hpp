// SPDX-License-Identifier: MIT
// Colours as eyes part them: CIE 1976 L*a*b*, white D65 (IEC 61966-2-1 for sRGB).
#ifndef SINEW_CHARACTER_PICTURE_OUTLINE_LAB_HPP
#define SINEW_CHARACTER_PICTURE_OUTLINE_LAB_HPP

#include <array>

#include "picture/outline/raster.hpp"
#include "sinew_character/picture/picture_file.hpp"

namespace sinew::picture {

using Lab = std::array<float, 3>;  // L 0..100, a and b about -100..100

// The picture in means of step x step pixels; what is transparent is left out of a mean.
struct Reduced {
  Grid<Lab> colours;
  Grid<uint8_t> alpha;  // 0..255
};
Reduced reduce(const Pixels& pixels, uint32_t step);
// Outlines are found at up to 1,280 pixels a side.
uint32_t step_of(const Pixels& pixels);

}  // namespace sinew::picture
#endif
