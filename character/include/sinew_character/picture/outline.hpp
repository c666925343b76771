// SPDX-License-Identifier: MIT
// The border of a figure as closed lines that a user can drag, and back.
#ifndef SINEW_CHARACTER_OUTLINE_HPP
#define SINEW_CHARACTER_OUTLINE_HPP

#include <array>
#include <vector>

#include "sinew_character/picture/figure.hpp"

namespace sinew {

// Closed lines in pixels of the picture, x right, y down from its top left corner: the figure's border, then those of its holes and smaller parts.
using Outline = std::vector<std::vector<std::array<float, 2>>>;

// Points of the border, no pixel of the mask farther than 0.6 from the lines between.
Outline outline_of(const Figure& figure);

// What lies inside of an odd number of the lines. Throws Error: a line of less than three points, one that is not finite, too little inside.
Figure figure_of_outline(const PictureFile& picture, const Outline& outline, const FigureOptions& options = {});

}  // namespace sinew
#endif
