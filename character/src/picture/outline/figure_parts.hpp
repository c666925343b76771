// SPDX-License-Identifier: MIT
// Parts of what stands out in a picture: one figure of several, a sheet of paper, holes, and lines drawn inside.
#ifndef SINEW_CHARACTER_PICTURE_OUTLINE_FIGURE_PARTS_HPP
#define SINEW_CHARACTER_PICTURE_OUTLINE_FIGURE_PARTS_HPP

#include <optional>
#include <string>
#include <vector>

#include "picture/outline/foreground.hpp"
#include "picture/outline/raster.hpp"

namespace sinew::picture {

// One figure of several, with what touches it.
struct ChosenPart {
  Mask mask;
  uint32_t count = 0, number = 0;  // figures from left to right
};
//   name    for messages
//   number  0: the largest
// Throws Error: nothing there, nothing large enough, many marks as of text, no figure of that number.
ChosenPart choose_part(const std::string& name, const Mask& mask, uint32_t number);

// The inside of a part that fills a quadrilateral of more than a quarter of the picture; its rim is left out. nullopt for anything else.
std::optional<Mask> sheet_of(const Mask& part);

// Takes holes out of `figure`: what is at least 0.1 % as large, is not all in a shadow (pale paint looks like paper in one), and has nothing
// drawn inside of it (a face has).
//   likeness  Likeness of every pixel
void open_holes(const Grid<uint8_t>& likeness, Mask* figure);

// Takes what is within `radius` pixels of those, as a square, out of the mask.
void take_out(const std::vector<uint32_t>& pixels, int64_t radius, Mask* mask);
// Opens a slit of three pixels along those pixels. False, and the mask as it was, where the figure would fall in two; crumbs may come off.
bool open_slit(const std::vector<uint32_t>& pixels, Mask* mask);

// Opens a slit along every line that runs from the figure's border into it: dark, of a stroke's width, without corners, at least 10 % of the
// longest side and 2.4 times as long as it lies deep, and such that all stays in one piece. A line from border to
// border (a belt) is left as it is. Adds their number to figure's notes, as a guess.
//   colors  [height x width] of the figure's mask
void cut_inner_lines(const Grid<Lab>& colors, Figure* figure);

}  // namespace sinew::picture
#endif
