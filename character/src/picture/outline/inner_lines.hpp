// SPDX-License-Identifier: MIT
// Lines drawn inside of a figure where a limb lies before the rest of it: a leg before a leg, an arm along the trunk.
#ifndef SINEW_CHARACTER_PICTURE_OUTLINE_INNER_LINES_HPP
#define SINEW_CHARACTER_PICTURE_OUTLINE_INNER_LINES_HPP

#include "picture/outline/lab.hpp"

namespace sinew::picture {

// Opens a slit along every line that runs from the figure's border into it: dark, of a stroke's width, without corners, at least 10 % of the
// longest side and 2.4 times as long as it lies deep, and such that all stays in one piece. A line from border to border (a belt) is left as it is. Says how many, as a guess, in figure's notes.
//   colours  [height x width] of the figure's mask
void cut_inner_lines(const Grid<Lab>& colours, Figure* figure);

}  // namespace sinew::picture
#endif
