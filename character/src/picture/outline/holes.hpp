// SPDX-License-Identifier: MIT
// Which enclosed regions that look like the background are holes of a figure, and which are its white parts.
#ifndef SINEW_CHARACTER_PICTURE_OUTLINE_HOLES_HPP
#define SINEW_CHARACTER_PICTURE_OUTLINE_HOLES_HPP

#include "picture/outline/foreground.hpp"

namespace sinew::picture {

// Takes holes out of `figure`: what is at least 0.1 % as large, is not all in a shadow (pale paint looks like paper in one), and has nothing
// drawn inside of it (a face has).
//   likeness  Likeness of every pixel
void open_holes(const Grid<uint8_t>& likeness, Mask* figure);

}  // namespace sinew::picture
#endif
