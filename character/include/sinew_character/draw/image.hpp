// SPDX-License-Identifier: MIT
// Rendering without a window: an RGB image, a PNG writer and a small software rasterizer for characters.
#ifndef SINEW_CHARACTER_IMAGE_HPP
#define SINEW_CHARACTER_IMAGE_HPP

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "sinew_formats/base/box.hpp"
#include "sinew_formats/character.hpp"

namespace sinew {

struct Image {
  int width = 0, height = 0;
  std::vector<uint8_t> rgb;  // [height x width x 3], row 0 on top
};

std::vector<uint8_t> encode_png(const Image& image);

// A ring around a point, on top of everything; pale where the surface hides the point.
struct RenderMark {
  Vec3 position;
  std::array<uint8_t, 3> color = {230, 20, 90};
};

struct RenderOptions {
  int width = 900, height = 900;
  float yaw_degrees = 25.0f, pitch_degrees = 10.0f;  // camera rotation about Y (front = +Z) and tilt down
  bool draw_skeleton = true;
  Axis up = Axis::kY;
  std::vector<uint8_t> red_joints;  // [J] 1: it and the bone to its parent are red; empty: none
  std::vector<RenderMark> marks;
  Vec3 focus;              // with focus_radius > 0: center of the picture instead of the whole mesh,
  float focus_radius = 0;  //   and the shown radius, in the mesh's units
};

// Returns the color of a joint index, spread over hue.
std::array<uint8_t, 3> joint_color(size_t joint);
// Draws shaded, depth-tested triangles with one color per vertex [V].
Image render(const Character& character, const std::vector<std::array<uint8_t, 3>>& vertex_colors,
             const RenderOptions& options = {});
// Returns colors blended from the joints' colors by weight.
std::vector<std::array<uint8_t, 3>> weight_colors(const Character& character);
// Returns colors from dark blue (0) to yellow to red (scale) for values such as L1 errors.
std::vector<std::array<uint8_t, 3>> heat_colors(const std::vector<float>& values, float scale);
// Joins pictures of the same height side by side.
Image beside(const std::vector<Image>& images);

// Colors of pictures: sRGB bytes to linear light and back, joints' colors, a scale for errors.

using Linear = std::array<float, 3>;  // linear light, 0..1

Linear to_linear(const std::array<uint8_t, 3>& srgb);
std::array<uint8_t, 3> to_srgb(const Linear& light);

}  // namespace sinew
#endif
