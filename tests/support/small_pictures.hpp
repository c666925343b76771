// SPDX-License-Identifier: MIT
// Pictures for tests: pixels that a function gives, and files of them by libpng and libjpeg.
#ifndef SINEW_TESTS_SMALL_PICTURES_HPP
#define SINEW_TESTS_SMALL_PICTURES_HPP

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "sinew_character/picture/figure.hpp"
#include "sinew_character/picture/picture_file.hpp"

namespace sinew::test {

using Rgba = std::array<uint8_t, 4>;
constexpr Rgba kWhite = {255, 255, 255, 255}, kInk = {30, 28, 34, 255}, kRed = {200, 60, 50, 255},
               kClear = {0, 0, 0, 0};

template <typename ColorAt>
PictureFile picture_of(uint32_t width, uint32_t height, const ColorAt& color_at) {
  PictureFile out;
  out.name = "picture";
  out.pixels.width = width;
  out.pixels.height = height;
  for (uint32_t y = 0; y < height; ++y)
    for (uint32_t x = 0; x < width; ++x) {
      const Rgba c = color_at(static_cast<int>(x), static_cast<int>(y));
      out.pixels.rgba.insert(out.pixels.rgba.end(), c.begin(), c.end());
    }
  out.bytes = std::make_shared<const std::vector<uint8_t>>();
  return out;
}

inline bool in_disc(int x, int y, int cx, int cy, int r) { return (x - cx) * (x - cx) + (y - cy) * (y - cy) <= r * r; }

// Overlap of a mask with what `inside` says, 0..1.
template <typename Inside>
double overlap(const Mask& mask, const Inside& inside) {
  size_t both = 0, either = 0;
  for (uint32_t y = 0; y < mask.height; ++y)
    for (uint32_t x = 0; x < mask.width; ++x) {
      const bool a = mask.at(x, y), b = inside(static_cast<int>(x), static_cast<int>(y));
      both += a && b ? 1 : 0;
      either += a || b ? 1 : 0;
    }
  return either > 0 ? static_cast<double>(both) / static_cast<double>(either) : 1;
}

// Of stored blocks and right checksums, so that any size is cheap: rows of filter 0.
//   color_type  0 gray, 2 RGB, 3 palette, 6 RGBA, as in a PNG
//   palette      RGB triples, for color_type 3
std::vector<uint8_t> png_bytes(uint32_t width, uint32_t height, int depth, int color_type,
                               const std::vector<uint8_t>& rows, const std::vector<uint8_t>& palette = {});

}  // namespace sinew::test
#endif
