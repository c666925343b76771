// SPDX-License-Identifier: MIT
// The figure of a picture: which pixels are the character, and its border as closed lines.
#ifndef SINEW_CHARACTER_FIGURE_HPP
#define SINEW_CHARACTER_FIGURE_HPP

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "sinew_character/picture/picture_file.hpp"

namespace sinew {

// One bit a pixel, as bytes.
struct Mask {
  uint32_t width = 0, height = 0;
  std::vector<uint8_t> inside;  // [height x width] 1 = figure, row 0 on top
  bool at(int64_t x, int64_t y) const {
    return x >= 0 && y >= 0 && x < int64_t{width} && y < int64_t{height} &&
           inside[static_cast<size_t>(y) * width + static_cast<size_t>(x)] != 0;
  }
};

struct FigureOptions {
  uint32_t number = 0;  // of several figures, from left to right, from 1 on; 0: the largest
  bool cut = false;     // where the figure overlaps itself: slits along the lines that are drawn into it, as a guess
};

enum class FigureSource { kAlpha, kBackground, kMask };  // how it was found

struct Figure {
  Mask mask;           // the picture divided by `step`, rounded up
  uint32_t step = 1;   // pixels of the picture a pixel of the mask
  uint32_t count = 1;  // figures in the picture
  uint32_t number = 1;
  FigureSource source = FigureSource::kBackground;
  std::vector<std::string> notes;  // what was guessed, a line each
  std::vector<std::vector<std::array<float, 2>>>
      slits;  // lines of free_limbs() that the mask is open along, in its pixels
};

// By alpha where the picture has some, else what is unlike the colors of its border (README.md). Throws Error, which begins with the picture's name: nothing
// that stands out, nothing large enough, no figure of that number.
Figure find_figure(const PictureFile& picture, const FigureOptions& options = {});
// As a user drew it: what is bright and opaque in `mask`, a picture of the same shape in any size.
Figure figure_of_mask(const PictureFile& picture, const PictureFile& mask, const FigureOptions& options = {});

// In the picture's own size.
Mask full_mask(const PictureFile& picture, const Figure& figure);

// Closed lines in pixels of the picture, x right, y down from its top left corner: the figure's border, then those of its holes and smaller parts.
using Outline = std::vector<std::vector<std::array<float, 2>>>;

// Points of the border, no pixel of the mask farther than 0.6 from the lines between.
Outline outline_of(const Figure& figure);

// What lies inside of an odd number of the lines. Throws Error: a line of less than three points, one that is not finite, too little inside.
Figure figure_of_outline(const PictureFile& picture, const Outline& outline, const FigureOptions& options = {});

}  // namespace sinew
#endif
