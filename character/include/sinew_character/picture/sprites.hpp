// SPDX-License-Identifier: MIT
// A picture's character in poses as pictures again: frames, sheets of frames, animated PNG.
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

// What is seen of the picture's plane, from +z, without perspective.
struct PlaneWindow {
  float left = 0, top = 0;         // of the window's upper left corner, in the mesh's units; y runs up
  float pixels = 1;                // a unit
  uint32_t width = 1, height = 1;  // pixels
};

// A mesh of picture_mesh() in a pose, in the picture's own colors without light, its surroundings transparent. Edges are smoothed.
Pixels draw_in_plane(const PictureFile& picture, const Character& posed, const PlaneWindow& window);

struct SpriteFrame {
  std::string name;  // "wave 0"
  Pixels pixels;
  uint32_t milliseconds = 100;
};

// Throw Error: no frame, frames of several sizes, a build without libpng, a sheet of more than kMostPictureSide a side.
std::vector<uint8_t> encode_png(const Pixels& pixels);
// An animated PNG (https://wiki.mozilla.org/APNG_Specification) that starts again for ever; what knows PNG alone shows its first frame.
std::vector<uint8_t> encode_loop(const std::vector<SpriteFrame>& frames);

struct SpriteSheet {
  Pixels pixels;     // frames in rows, about as wide as high
  std::string json;  // where each one lies: the "hash" of TexturePacker and Aseprite, as 2D engines read it
};
//   image  the file that the sheet is written to, for the JSON
SpriteSheet sprite_sheet(const std::vector<SpriteFrame>& frames, const std::string& image);

// Frames of an animated picture, for sprite sheets and loops.
struct FrameOptions {
  size_t count = 0;     // of each clip, at equal distances; 0: 15 a second
  uint32_t side = 512;  // pixels of a frame's longest side, and no more than the picture has for it
};

// Every frame of every clip in one window, which goes along where the character does: it stays in its place. A clip that ends as it begins
// is drawn without its last frame, so that it loops.
//   character  of `picture`, bound; in any units
//   motion     of its joints
//   deformer   null: linear skinning
// Throws Error: no clip, more than 4,096 frames.
std::vector<SpriteFrame> picture_frames(const PictureFile& picture, const Character& character, const Motion& motion,
                                        CharacterDeformer* deformer, const FrameOptions& options);

}  // namespace sinew
#endif
