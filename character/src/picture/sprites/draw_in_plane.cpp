// SPDX-License-Identifier: MIT
// Triangles with the picture on them, the nearest one at every sample.
#include <algorithm>
#include <array>
#include <cmath>

#include "sinew_character/picture/sprites.hpp"

namespace sinew {
namespace {

constexpr uint32_t kSamples = 3;  // a side of a pixel
constexpr uint8_t kOpaque = 128;

struct Corner {
  float x, y, z, u, v;  // x, y in samples, z towards the viewer; u, v of the seen picture, v runs down
};

struct Canvas {
  uint32_t width, height;       // samples
  std::vector<float> nearness;  // [height x width]
  std::vector<uint8_t> colors;  // [height x width x 4]
};

// Between four pixels' middles; what is transparent gives no color.
std::array<float, 4> color_at(const Pixels& pixels, float u, float v) {
  const float x = std::clamp(u * static_cast<float>(pixels.width) - 0.5f, 0.0f, static_cast<float>(pixels.width - 1)),
              y = std::clamp(v * static_cast<float>(pixels.height) - 0.5f, 0.0f, static_cast<float>(pixels.height - 1));
  const auto x0 = static_cast<uint32_t>(x), y0 = static_cast<uint32_t>(y);
  const float fx = x - static_cast<float>(x0), fy = y - static_cast<float>(y0);
  std::array<float, 4> sum{};
  for (uint32_t k = 0; k < 4; ++k) {
    const uint32_t px = std::min(x0 + (k & 1), pixels.width - 1), py = std::min(y0 + (k >> 1), pixels.height - 1);
    const uint8_t* p = &pixels.rgba[(size_t{py} * pixels.width + px) * 4];
    const float share = ((k & 1) != 0 ? fx : 1 - fx) * ((k >> 1) != 0 ? fy : 1 - fy) * static_cast<float>(p[3]);
    for (size_t c = 0; c < 3; ++c) sum[c] += share * static_cast<float>(p[c]);
    sum[3] += share;
  }
  for (size_t c = 0; c < 3 && sum[3] > 0; ++c) sum[c] /= sum[3];
  return sum;
}

void fill(const Pixels& pixels, bool cut_out, const std::array<Corner, 3>& t, Canvas* canvas) {
  const float area = (t[1].x - t[0].x) * (t[2].y - t[0].y) - (t[2].x - t[0].x) * (t[1].y - t[0].y);
  if (area == 0 || !std::isfinite(area)) return;
  const auto bound = [](float v, uint32_t most) {
    return static_cast<uint32_t>(std::clamp(v, 0.0f, static_cast<float>(most)));
  };
  const uint32_t x0 = bound(std::min({t[0].x, t[1].x, t[2].x}), canvas->width),
                 x1 = bound(std::max({t[0].x, t[1].x, t[2].x}) + 1, canvas->width),
                 y0 = bound(std::min({t[0].y, t[1].y, t[2].y}), canvas->height),
                 y1 = bound(std::max({t[0].y, t[1].y, t[2].y}) + 1, canvas->height);
  for (uint32_t y = y0; y < y1; ++y)
    for (uint32_t x = x0; x < x1; ++x) {
      const float px = static_cast<float>(x) + 0.5f, py = static_cast<float>(y) + 0.5f;
      const float b = ((px - t[0].x) * (t[2].y - t[0].y) - (t[2].x - t[0].x) * (py - t[0].y)) / area,
                  c = ((t[1].x - t[0].x) * (py - t[0].y) - (px - t[0].x) * (t[1].y - t[0].y)) / area, a = 1 - b - c;
      if (a < 0 || b < 0 || c < 0) continue;
      const size_t at = size_t{y} * canvas->width + x;
      const float z = a * t[0].z + b * t[1].z + c * t[2].z;
      if (z <= canvas->nearness[at]) continue;
      const auto color = color_at(pixels, a * t[0].u + b * t[1].u + c * t[2].u, a * t[0].v + b * t[1].v + c * t[2].v);
      if (cut_out && color[3] < kOpaque) continue;
      canvas->nearness[at] = z;
      for (size_t k = 0; k < 3; ++k) canvas->colors[4 * at + k] = static_cast<uint8_t>(color[k] + 0.5f);
      canvas->colors[4 * at + 3] = 255;
    }
}

Pixels reduced(const Canvas& canvas) {
  Pixels out;
  out.width = canvas.width / kSamples;
  out.height = canvas.height / kSamples;
  out.rgba.assign(size_t{out.width} * out.height * 4, 0);
  for (uint32_t y = 0; y < out.height; ++y)
    for (uint32_t x = 0; x < out.width; ++x) {
      std::array<uint32_t, 3> sum{};
      uint32_t covered = 0;
      for (uint32_t s = 0; s < kSamples * kSamples; ++s) {
        const size_t at = size_t{kSamples * y + s / kSamples} * canvas.width + kSamples * x + s % kSamples;
        if (canvas.colors[4 * at + 3] == 0) continue;
        for (size_t c = 0; c < 3; ++c) sum[c] += canvas.colors[4 * at + c];
        ++covered;
      }
      if (covered == 0) continue;
      uint8_t* p = &out.rgba[(size_t{y} * out.width + x) * 4];
      for (size_t c = 0; c < 3; ++c) p[c] = static_cast<uint8_t>((sum[c] + covered / 2) / covered);
      p[3] = static_cast<uint8_t>(255 * covered / (kSamples * kSamples));
    }
  return out;
}

}  // namespace

Pixels draw_in_plane(const PictureFile& picture, const Character& posed, const PlaneWindow& window) {
  Canvas canvas = {window.width * kSamples, window.height * kSamples, {}, {}};
  canvas.nearness.assign(size_t{canvas.width} * canvas.height, -1e30f);
  canvas.colors.assign(canvas.nearness.size() * 4, 0);
  const bool cut_out = !posed.materials.empty() && posed.materials[0].cut_out;
  const float scale = window.pixels * static_cast<float>(kSamples);
  const auto corner = [&](size_t c) {
    const Vec3& p = posed.vertices[posed.face_vertices[c]];
    const PicturePoint seen = seen_point(picture, {posed.corner_uvs[c][0], 1 - posed.corner_uvs[c][1]});
    return Corner{(p.x - window.left) * scale, (window.top - p.y) * scale, p.z, seen.u, seen.v};
  };
  for (size_t f = 0; f < posed.face_count(); ++f)
    for (size_t c = posed.face_offsets[f] + size_t{1}; c + 1 < posed.face_offsets[f + 1]; ++c)
      fill(picture.pixels, cut_out, {corner(posed.face_offsets[f]), corner(c), corner(c + 1)}, &canvas);
  return reduced(canvas);
}

}  // namespace sinew
