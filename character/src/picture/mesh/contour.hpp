// SPDX-License-Identifier: MIT
// The border of a mask as closed lines.
#ifndef SINEW_CHARACTER_PICTURE_MESH_CONTOUR_HPP
#define SINEW_CHARACTER_PICTURE_MESH_CONTOUR_HPP

#include <array>
#include <vector>

#include "sinew_character/picture/figure.hpp"

namespace sinew::picture {

using Point2 = std::array<double, 2>;  // in pixels of the mask, x right, y down; a pixel's middle is at + 0.5
using Loop = std::vector<Point2>;      // closed; the figure is on the right hand

// Along the edges of pixels, stairs smoothed away. Loops of less than 12 edges are left out.
std::vector<Loop> contours_of(const Mask& mask);

// Indices into a loop, rising: no point of it is farther than `tolerance` from the lines between (Douglas, Peucker 1973), which are no longer than `longest`.
std::vector<size_t> simplified(const Loop& loop, double tolerance, double longest);

}  // namespace sinew::picture
#endif
