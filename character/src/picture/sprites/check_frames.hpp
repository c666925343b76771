// SPDX-License-Identifier: MIT
// What frames have in common.
#ifndef SINEW_CHARACTER_PICTURE_DRAW_CHECK_FRAMES_HPP
#define SINEW_CHARACTER_PICTURE_DRAW_CHECK_FRAMES_HPP

#include <vector>

#include "sinew_character/picture/sprites.hpp"
#include "sinew_formats/error.hpp"

namespace sinew::picture {

inline void check_frames(const std::vector<SpriteFrame>& frames) {
  if (frames.empty()) throw Error("sprites: expected frames, found none");
  for (const SpriteFrame& frame : frames)
    if (frame.pixels.width != frames[0].pixels.width || frame.pixels.height != frames[0].pixels.height)
      throw Error("sprites: expected frames of one size");
}

}  // namespace sinew::picture
#endif
