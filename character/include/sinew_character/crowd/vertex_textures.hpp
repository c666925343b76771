// SPDX-License-Identifier: MIT
// Vertex animation textures: the vertices of all frames of several clips as texels, for shaders that draw crowds
// without skinning.
#ifndef SINEW_CHARACTER_VERTEX_TEXTURES_HPP
#define SINEW_CHARACTER_VERTEX_TEXTURES_HPP

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "sinew_character/draw/image.hpp"
#include "sinew_formats/base/box.hpp"

namespace sinew {

// Maximum side of a texture; GPUs of the last ten years support 4096 x 8192, and most 16384.
constexpr uint32_t kMostTextureWidth = 4096, kMostTextureHeight = 8192;

// Layout of the textures: vertex v of frame f is in column v % width, row f * rows + v / width.
struct TextureLayout {
  uint32_t vertices = 0, frames = 0;
  uint32_t width = 0;
  uint32_t rows = 0;  // rows per frame

  uint32_t height() const { return rows * frames; }
  size_t texel(size_t vertex, size_t frame) const { return (frame * rows + vertex / width) * width + vertex % width; }
  // Texture coordinates of the center of the vertex's texel in frame 0, 0..1, from the top.
  std::array<float, 2> coordinates(size_t vertex) const {
    return {(static_cast<float>(vertex % width) + 0.5f) / static_cast<float>(width),
            (static_cast<float>(vertex / width) + 0.5f) / static_cast<float>(height())};
  }
};

// Returns the narrowest layout with the fewest rows. Throws Error, which begins with `name` and has the number of
// frames that fit, if it would be too high.
TextureLayout texture_layout(const std::string& name, size_t vertices, size_t frames);

// Three RGB pictures with 8 bits per channel: browsers and Godot keep no more of a PNG.
struct VertexTextures {
  TextureLayout layout;
  Box bounds;                                 // of the positions of all frames
  Image position_high, position_low, normal;  // red, green and blue are x, y and z
};

// Black pictures of the layout.
VertexTextures blank_textures(const TextureLayout& layout, const Box& bounds);

// A position has 16 bits per axis over the bounds, in separate high and low bytes: low + (256 high + low) / 65535 *
// (high - low) of the bounds. The error is half a step, 0.014 mm per axis for bounds of 1.8 m. An axis on which the
// bounds are flat has 0.
void set_position(const Vec3& position, size_t texel, VertexTextures* textures);
Vec3 position_at(const VertexTextures& textures, size_t texel);
// A normal of length 1 is stored as round(127 n) + 128, which is exact for the axes and at most 0.4 degrees off
// otherwise. Decoded to length 1.
void set_normal(const Vec3& normal, size_t texel, VertexTextures* textures);
Vec3 normal_at(const VertexTextures& textures, size_t texel);

}  // namespace sinew
#endif
