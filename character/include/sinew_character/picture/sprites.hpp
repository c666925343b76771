// SPDX-License-Identifier: MIT
// Rendered poses of a picture's character: frames, sprite sheets, animated PNG.
#ifndef SINEW_CHARACTER_SPRITES_HPP
#define SINEW_CHARACTER_SPRITES_HPP

#include <cstdint>
#include <string>
#include <vector>

#include "sinew_character/picture/picture_file.hpp"
#include "sinew_character/pose/deform.hpp"
#include "sinew_formats/character.hpp"
#include "sinew_formats/motion.hpp"

namespace sinew {

// The visible window of the picture plane, from +z, without perspective.
struct PlaneWindow {
  float left = 0, top = 0;         // upper left corner of the window, in the mesh's units; y up
  float pixels = 1;                // pixels per unit
  uint32_t width = 1, height = 1;  // pixels
};

// Renders a posed mesh of picture_mesh() with the picture's colors, unlit, antialiased, on a transparent background.
Pixels draw_in_plane(const PictureFile& picture, const Character& posed, const PlaneWindow& window);

struct SpriteFrame {
  std::string name;  // "wave 0"
  Pixels pixels;
  uint32_t milliseconds = 100;
};

// The functions below throw Error for no frame, frames of several sizes, a build without libpng, or a sheet with a
// side above kMostPictureSide.
std::vector<uint8_t> encode_png(const Pixels& pixels);
// Encodes an endless animated PNG (https://wiki.mozilla.org/APNG_Specification); programs that know only PNG show its
// first frame.
std::vector<uint8_t> encode_loop(const std::vector<SpriteFrame>& frames);

struct SpriteSheet {
  Pixels pixels;     // frames in rows, about as wide as high
  std::string json;  // position of each frame, as the JSON "hash" of TexturePacker and Aseprite for 2D engines
};
//   image  file name of the sheet, for the JSON
SpriteSheet sprite_sheet(const std::vector<SpriteFrame>& frames, const std::string& image);

// Frames of an animated picture, for sprite sheets and loops.
struct FrameOptions {
  size_t count = 0;     // frames per clip, at equal intervals; 0: 15 per second
  uint32_t side = 512;  // pixels of a frame's longest side, at most as many as in the picture
};

// Renders all frames of all clips in one window that follows the character. A clip whose last frame equals the first
// is drawn without the last, so that it loops.
//   character  of `picture`, bound; in any units
//   motion     of its joints
//   deformer   null: linear skinning
// Throws Error: no clip, more than 4,096 frames.
std::vector<SpriteFrame> picture_frames(const PictureFile& picture, const Character& character, const Motion& motion,
                                        CharacterDeformer* deformer, const FrameOptions& options);

}  // namespace sinew
#endif
