// SPDX-License-Identifier: MIT
#include "sinew_character/crowd/vertex_textures.hpp"

#include <algorithm>
#include <cmath>

#include "sinew_formats/base/point.hpp"
#include "sinew_formats/error.hpp"

namespace sinew {
namespace {

constexpr double kPositionSteps = 65535;
constexpr double kNormalScale = 127, kNormalZero = 128;  // 0 lies on a step

}  // namespace

TextureLayout texture_layout(const std::string& name, size_t vertices, size_t frames) {
  const size_t rows = (vertices + kMostTextureWidth - 1) / kMostTextureWidth;
  const size_t most_frames = rows == 0 ? 0 : kMostTextureHeight / rows;
  if (vertices == 0 || frames == 0 || frames > most_frames)
    throw Error(name + ": expected clips of 1 to " + std::to_string(most_frames) + " frames in total for textures of " +
                std::to_string(kMostTextureWidth) + " x " + std::to_string(kMostTextureHeight) + " with " +
                std::to_string(vertices) + " vertices, found " + std::to_string(frames) +
                "; give fewer clips, a lower --fps, or the character with fewer triangles (sinew lod)");
  return {static_cast<uint32_t>(vertices), static_cast<uint32_t>(frames),
          static_cast<uint32_t>((vertices + rows - 1) / rows), static_cast<uint32_t>(rows)};
}

VertexTextures blank_textures(const TextureLayout& layout, const Box& bounds) {
  Image image;
  image.width = static_cast<int>(layout.width);
  image.height = static_cast<int>(layout.height());
  image.rgb.assign(size_t{3} * layout.width * layout.height(), 0);
  return {layout, bounds, image, image, image};
}

void set_position(const Vec3& position, size_t texel, VertexTextures* textures) {
  const Point3 p = point(position), low = point(textures->bounds.low), high = point(textures->bounds.high);
  for (size_t axis = 0; axis < 3; ++axis) {
    const double side = high[axis] - low[axis];
    const double share = side > 0 ? std::clamp((p[axis] - low[axis]) / side, 0.0, 1.0) : 0;
    const auto value = static_cast<uint32_t>(std::lround(share * kPositionSteps));
    textures->position_high.rgb[3 * texel + axis] = static_cast<uint8_t>(value >> 8);
    textures->position_low.rgb[3 * texel + axis] = static_cast<uint8_t>(value & 255);
  }
}

Vec3 position_at(const VertexTextures& textures, size_t texel) {
  const Point3 low = point(textures.bounds.low), high = point(textures.bounds.high);
  Point3 p{};
  for (size_t axis = 0; axis < 3; ++axis) {
    const uint32_t value =
        textures.position_high.rgb[3 * texel + axis] * 256u + textures.position_low.rgb[3 * texel + axis];
    p[axis] = low[axis] + value / kPositionSteps * (high[axis] - low[axis]);
  }
  return to_vec3(p);
}

void set_normal(const Vec3& normal, size_t texel, VertexTextures* textures) {
  const Point3 n = point(normal);
  for (size_t axis = 0; axis < 3; ++axis)
    textures->normal.rgb[3 * texel + axis] =
        static_cast<uint8_t>(std::lround(std::clamp(n[axis], -1.0, 1.0) * kNormalScale + kNormalZero));
}

Vec3 normal_at(const VertexTextures& textures, size_t texel) {
  Point3 n{};
  for (size_t axis = 0; axis < 3; ++axis)
    n[axis] = (textures.normal.rgb[3 * texel + axis] - kNormalZero) / kNormalScale;
  return to_vec3(unit(n));
}

}  // namespace sinew
