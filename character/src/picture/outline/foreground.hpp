// SPDX-License-Identifier: MIT
// Background grown inwards from the border of a picture, or of a sheet in it; what is left.
#ifndef SINEW_CHARACTER_PICTURE_OUTLINE_FOREGROUND_HPP
#define SINEW_CHARACTER_PICTURE_OUTLINE_FOREGROUND_HPP

#include "picture/outline/lab.hpp"

namespace sinew::picture {

// What a pixel is by its colour alone.
enum Likeness : uint8_t { kUnlike = 0, kShadow = 1, kLike = 2 };

struct Foreground {
  Mask mask;  // not reached from the border
  Grid<uint8_t>
      likeness;        // Likeness of `mask`'s pixels: holes and paper inside of outlines look as the background does
  bool drawn = false;  // outlines on paper: the figure is what they enclose
};

// `domain` says which pixels there are; the others are neither.
Foreground find_foreground(const Grid<Lab>& colours, const Mask& domain);

// The same for one part of what was found, beside strokes of other things: an outline drawing is filled. False where it is none, unchanged then.
bool fill_outline(const Foreground& found, const Mask& domain, Mask* part);

}  // namespace sinew::picture
#endif
