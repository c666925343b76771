// SPDX-License-Identifier: MIT
// Pictures as grids of numbers: distances and parts on them, and colors as eyes part them.
#ifndef SINEW_CHARACTER_PICTURE_OUTLINE_RASTER_HPP
#define SINEW_CHARACTER_PICTURE_OUTLINE_RASTER_HPP

#include <array>
#include <cstdint>
#include <vector>

#include "sinew_character/picture/figure.hpp"
#include "sinew_character/picture/picture_file.hpp"

namespace sinew::picture {

// [height x width]
template <typename T>
struct Grid {
  uint32_t width = 0, height = 0;
  std::vector<T> values;
  Grid() = default;
  Grid(uint32_t w, uint32_t h, T value = T{}) : width(w), height(h), values(size_t{w} * h, value) {}
  size_t index(uint32_t x, uint32_t y) const { return size_t{y} * width + x; }
  T& at(uint32_t x, uint32_t y) { return values[index(x, y)]; }
  const T& at(uint32_t x, uint32_t y) const { return values[index(x, y)]; }
};

// min over all q of values[q] + |p - q|^2, in place: two passes of lower envelopes of parabolas (Felzenszwalb, Huttenlocher, Distance Transforms of
// Sampled Functions, 2012). Values from kFar on do not count.
constexpr float kFar = 1e12f;
void spread_parabolas(Grid<float>* grid);

// Squared distance to the nearest pixel that is not `value`; what lies outside the mask is no figure.
Grid<float> squared_distance(const Mask& mask, bool value);

// Grown by `radius` pixels, and shrunk; closing is the first and then the second.
Mask grown(const Mask& mask, float radius);
Mask closed(const Mask& mask, float radius);

struct Parts {
  Grid<int32_t> numbers;      // part of each pixel or -1
  std::vector<size_t> sizes;  // pixels
};
// Connected pixels that are `value`: over corners as well for figures (8 neighbors), over edges alone for what is none (4).
Parts parts_of(const Mask& mask, bool value);

// Colors as eyes part them: CIE 1976 L*a*b*, white D65 (IEC 61966-2-1 for sRGB).

using Lab = std::array<float, 3>;  // L 0..100, a and b about -100..100

// The picture in means of step x step pixels; what is transparent is left out of a mean.
struct Reduced {
  Grid<Lab> colors;
  Grid<uint8_t> alpha;  // 0..255
};
Reduced reduce(const Pixels& pixels, uint32_t step);
// Outlines are found at up to 1,280 pixels a side.
uint32_t step_of(const Pixels& pixels);

}  // namespace sinew::picture
#endif
