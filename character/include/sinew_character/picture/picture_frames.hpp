// SPDX-License-Identifier: MIT
// Frames of an animated picture, for sprite sheets and loops.
#ifndef SINEW_CHARACTER_PICTURE_FRAMES_HPP
#define SINEW_CHARACTER_PICTURE_FRAMES_HPP

#include <vector>

#include "sinew_character/picture/sprites.hpp"
#include "sinew_character/pose/deform.hpp"
#include "sinew_formats/motion.hpp"

namespace sinew {

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
