// SPDX-License-Identifier: MIT
// The figure of a picture: the pixels of the character, and its outline as closed lines.
#ifndef SINEW_CHARACTER_FIGURE_HPP
#define SINEW_CHARACTER_FIGURE_HPP

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "sinew_character/picture/picture_file.hpp"

namespace sinew {

// One byte per pixel.
struct Mask {
  uint32_t width = 0, height = 0;
  std::vector<uint8_t> inside;  // [height x width] 1 = figure, row 0 on top
  bool at(int64_t x, int64_t y) const {
    return x >= 0 && y >= 0 && x < int64_t{width} && y < int64_t{height} &&
           inside[static_cast<size_t>(y) * width + static_cast<size_t>(x)] != 0;
  }
};

struct FigureOptions {
  uint32_t number = 0;  // number of the figure, from left to right, starting at 1; 0: the largest
  bool cut = false;     // cuts slits along lines drawn into the figure, where it probably overlaps itself
};

enum class FigureSource { kAlpha, kBackground, kMask };  // how it was found

struct Figure {
  Mask mask;           // the picture divided by `step`, rounded up
  uint32_t step = 1;   // picture pixels per mask pixel
  uint32_t count = 1;  // figures in the picture
  uint32_t number = 1;
  FigureSource source = FigureSource::kBackground;
  std::vector<std::string> notes;  // guesses, one line each
  std::vector<std::vector<std::array<float, 2>>>
      slits;  // lines of free_limbs() along which the mask is cut, in mask pixels
};

// Finds the figure by alpha if the picture has it, else by difference from the colors of its border (README.md).
// Throws Error, which begins with the picture's name, if nothing differs, nothing is large enough, or there is no
// figure of that number.
Figure find_figure(const PictureFile& picture, const FigureOptions& options = {});
// Takes the figure from a user's mask: bright and opaque pixels of `mask`, a picture with the same aspect ratio in
// any size.
Figure figure_of_mask(const PictureFile& picture, const PictureFile& mask, const FigureOptions& options = {});

// Returns the mask in the picture's size.
Mask full_mask(const PictureFile& picture, const Figure& figure);

// Closed lines in pixels of the picture, x right, y down from its top left corner: the figure's border, then those of its holes and smaller parts.
using Outline = std::vector<std::vector<std::array<float, 2>>>;

// Returns points of the border; no border pixel of the mask is farther than 0.6 from the lines between them.
Outline outline_of(const Figure& figure);

// Fills the area inside an odd number of the lines. Throws Error for a line of fewer than three points, a point that
// is not finite, or too small an area.
Figure figure_of_outline(const PictureFile& picture, const Outline& outline, const FigureOptions& options = {});

}  // namespace sinew
#endif
