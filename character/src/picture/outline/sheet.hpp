// SPDX-License-Identifier: MIT
// A sheet of paper on a table, which is what stands out in its picture.
#ifndef SINEW_CHARACTER_PICTURE_OUTLINE_SHEET_HPP
#define SINEW_CHARACTER_PICTURE_OUTLINE_SHEET_HPP

#include <optional>

#include "picture/outline/raster.hpp"

namespace sinew::picture {

// The inside of a part that fills a quadrilateral of more than a quarter of the picture; its rim is left out. nullopt for anything else.
std::optional<Mask> sheet_of(const Mask& part);

}  // namespace sinew::picture
#endif
