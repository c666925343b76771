// SPDX-License-Identifier: MIT
// Inflates a figure to a mesh as thick as it is wide, with the picture on both sides.
#ifndef SINEW_CHARACTER_PICTURE_MESH_HPP
#define SINEW_CHARACTER_PICTURE_MESH_HPP

#include <array>
#include <cstdint>
#include <vector>

#include "sinew_character/picture/figure.hpp"
#include "sinew_character/picture/picture_file.hpp"
#include "sinew_formats/character.hpp"

namespace sinew {

struct PictureMeshOptions {
  bool pixels =
      false;  // units are pixels, x from the left edge, y up from the bottom edge; else the figure's longest side is 1, its feet at y 0, its center at x 0
  bool flat = false;  // a card, 1 % of the longest side thick
};

// Makes a mesh in the xy plane, seen from +z. Vertices on the outline are shared by both sides; the others are in
// front (z > 0) and behind. It has one unlit material whose texture is the picture file; the back shows the same
// picture. Throws Error for a figure with too few pixels.
Character picture_mesh(const PictureFile& picture, const Figure& figure, const PictureMeshOptions& options = {});

// Maps points between the figure's mask (pixels, x right, y down) and a mesh of picture_mesh(). Derived from the
// bounding boxes of both.
struct PicturePlane {
  float mask_left = 0, mask_bottom = 0, left = 0, bottom = 0, scale = 1;  // mesh units per mask pixel
  std::array<float, 2> to_mesh(const std::array<float, 2>& p) const {
    return {left + (p[0] - mask_left) * scale, bottom + (mask_bottom - p[1]) * scale};
  }
  std::array<float, 2> to_mask(const Vec3& p) const {
    return {mask_left + (p.x - left) / scale, mask_bottom - (p.y - bottom) / scale};
  }
};
PicturePlane picture_plane(const Figure& figure, const Character& mesh);

// Moves the mesh's borders on both sides of the figure's slits together, so that the picture has no gap there; the
// borders stay separate.
void close_slits(const Figure& figure, const PicturePlane& plane, Character* mesh);

// [V] colors of the picture at the vertices of picture_mesh(), sRGB, for drawing it without textures.
std::vector<std::array<uint8_t, 3>> picture_colors(const PictureFile& picture, const Character& mesh);

// Flattens a mesh of picture_mesh() to a card.
void flatten(Character* mesh);

}  // namespace sinew
#endif
