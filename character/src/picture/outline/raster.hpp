// SPDX-License-Identifier: MIT
// Grids of numbers, and distances on them.
#ifndef SINEW_CHARACTER_PICTURE_OUTLINE_RASTER_HPP
#define SINEW_CHARACTER_PICTURE_OUTLINE_RASTER_HPP

#include <cstdint>
#include <vector>

#include "sinew_character/picture/figure.hpp"

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
// Connected pixels that are `value`: over corners as well for figures (8 neighbours), over edges alone for what is none (4).
Parts parts_of(const Mask& mask, bool value);

}  // namespace sinew::picture
#endif
