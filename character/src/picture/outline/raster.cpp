// SPDX-License-Identifier: MIT
// Distances, parts and colors on grids.
#include "picture/outline/raster.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace sinew::picture {
namespace {

// Scratch of one row or column of `n` values.
struct Envelope {
  std::vector<double> value, from;  // of the parabolas, and where each begins to be the lowest
  std::vector<uint32_t> position;
  explicit Envelope(size_t n) : value(n), from(n + 1), position(n) {}
};

// One dimension: values[i * step] becomes min over k of values[k * step] + (i - k)^2.
void spread_line(float* values, size_t step, uint32_t n, Envelope* e) {
  size_t count = 0;
  for (uint32_t k = 0; k < n; ++k) {
    const double v = static_cast<double>(values[k * step]);
    if (v >= static_cast<double>(kFar)) continue;
    double begin = -1e30;
    while (count > 0) {
      const double q = e->position[count - 1], w = e->value[count - 1];
      begin = ((v + double{1} * k * k) - (w + q * q)) / (2 * (k - q));
      if (begin > e->from[count - 1]) break;
      --count;
      begin = -1e30;
    }
    e->position[count] = k;
    e->value[count] = v;
    e->from[count] = begin;
    ++count;
  }
  if (count == 0) return;
  size_t at = 0;
  for (uint32_t i = 0; i < n; ++i) {
    while (at + 1 < count && e->from[at + 1] <= i) ++at;
    const double off = double{1} * i - e->position[at];
    values[i * step] = static_cast<float>(e->value[at] + off * off);
  }
}

}  // namespace

void spread_parabolas(Grid<float>* grid) {
  Envelope scratch(std::max(grid->width, grid->height));
  for (uint32_t x = 0; x < grid->width; ++x) spread_line(&grid->values[x], grid->width, grid->height, &scratch);
  for (uint32_t y = 0; y < grid->height; ++y)
    spread_line(&grid->values[size_t{y} * grid->width], 1, grid->width, &scratch);
}

Grid<float> squared_distance(const Mask& mask, bool value) {
  // A frame of one pixel represents what lies outside.
  Grid<float> framed(mask.width + 2, mask.height + 2, value ? 0.0f : kFar);
  for (uint32_t y = 0; y < mask.height; ++y)
    for (uint32_t x = 0; x < mask.width; ++x)
      framed.at(x + 1, y + 1) = (mask.inside[size_t{y} * mask.width + x] != 0) == value ? kFar : 0.0f;
  spread_parabolas(&framed);
  Grid<float> out(mask.width, mask.height);
  for (uint32_t y = 0; y < mask.height; ++y)
    std::copy_n(&framed.at(1, y + 1), mask.width, &out.values[size_t{y} * mask.width]);
  return out;
}

Mask grown(const Mask& mask, float radius) {
  const Grid<float> far = squared_distance(mask, false);
  Mask out = mask;
  for (size_t i = 0; i < out.inside.size(); ++i) out.inside[i] = far.values[i] <= radius * radius ? 1 : 0;
  return out;
}

Mask closed(const Mask& mask, float radius) {
  if (radius <= 0) return mask;
  Mask out = grown(mask, radius);
  const Grid<float> deep = squared_distance(out, true);
  const auto edge = static_cast<uint32_t>(radius) + 1;
  for (uint32_t y = 0; y < out.height; ++y)
    for (uint32_t x = 0; x < out.width; ++x) {
      const size_t i = size_t{y} * out.width + x;
      // At the border of the picture what lies outside says nothing.
      const bool framed = x < edge || y < edge || x + edge >= out.width || y + edge >= out.height;
      out.inside[i] = mask.inside[i] != 0 || (!framed && deep.values[i] > radius * radius) ? 1 : 0;
    }
  return out;
}

Parts parts_of(const Mask& mask, bool value) {
  Parts out;
  out.numbers = Grid<int32_t>(mask.width, mask.height, -1);
  std::vector<uint32_t> todo;
  const auto wanted = [&](size_t i) { return (mask.inside[i] != 0) == value && out.numbers.values[i] < 0; };
  for (size_t first = 0; first < mask.inside.size(); ++first) {
    if (!wanted(first)) continue;
    const auto number = static_cast<int32_t>(out.sizes.size());
    out.sizes.push_back(0);
    out.numbers.values[first] = number;
    todo.push_back(static_cast<uint32_t>(first));
    while (!todo.empty()) {
      const uint32_t i = todo.back();
      todo.pop_back();
      ++out.sizes.back();
      const int64_t x = i % mask.width, y = i / mask.width;
      for (int64_t dy = -1; dy <= 1; ++dy)
        for (int64_t dx = -1; dx <= 1; ++dx) {
          if (!value && dx != 0 && dy != 0) continue;
          if (x + dx < 0 || y + dy < 0 || x + dx >= int64_t{mask.width} || y + dy >= int64_t{mask.height}) continue;
          const auto next = static_cast<size_t>((y + dy) * int64_t{mask.width} + x + dx);
          if (!wanted(next)) continue;
          out.numbers.values[next] = number;
          todo.push_back(static_cast<uint32_t>(next));
        }
    }
  }
  return out;
}

namespace {

std::array<float, 256> linear_table() {
  std::array<float, 256> table{};
  for (size_t i = 0; i < 256; ++i) {
    const double v = static_cast<double>(i) / 255;
    table[i] = static_cast<float>(v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4));
  }
  return table;
}

// The curve of L*a*b* at 4096 points of 0..1.
std::array<float, 4097> curve_table() {
  std::array<float, 4097> table{};
  for (size_t i = 0; i < table.size(); ++i) {
    const double t = static_cast<double>(i) / 4096;
    table[i] = static_cast<float>(t > 216.0 / 24389 ? std::cbrt(t) : (24389.0 / 27 * t + 16) / 116);
  }
  return table;
}

Lab lab_of(float r, float g, float b) {
  static const std::array<float, 4097> curve = curve_table();
  const auto f = [](float t) { return curve[static_cast<size_t>(std::clamp(t, 0.0f, 1.0f) * 4096 + 0.5f)]; };
  const float x = f((0.4124564f * r + 0.3575761f * g + 0.1804375f * b) / 0.95047f);
  const float y = f(0.2126729f * r + 0.7151522f * g + 0.0721750f * b);
  const float z = f((0.0193339f * r + 0.1191920f * g + 0.9503041f * b) / 1.08883f);
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

}  // namespace

uint32_t step_of(const Pixels& pixels) {
  constexpr uint32_t kWorkSide = 1280;
  return (std::max(pixels.width, pixels.height) + kWorkSide - 1) / kWorkSide;
}

Reduced reduce(const Pixels& pixels, uint32_t step) {
  static const std::array<float, 256> linear = linear_table();
  const uint32_t width = (pixels.width + step - 1) / step, height = (pixels.height + step - 1) / step;
  Reduced out = {Grid<Lab>(width, height), Grid<uint8_t>(width, height)};
  for (uint32_t y = 0; y < height; ++y)
    for (uint32_t x = 0; x < width; ++x) {
      std::array<float, 3> sum{};
      uint32_t alpha = 0, count = 0;
      for (uint32_t fy = y * step; fy < std::min(pixels.height, (y + 1) * step); ++fy)
        for (uint32_t fx = x * step; fx < std::min(pixels.width, (x + 1) * step); ++fx) {
          const uint8_t* p = &pixels.rgba[(size_t{fy} * pixels.width + fx) * 4];
          for (size_t c = 0; c < 3; ++c) sum[c] += linear[p[c]] * static_cast<float>(p[3]);
          alpha += p[3];
          ++count;
        }
      out.alpha.at(x, y) = static_cast<uint8_t>((alpha + count / 2) / count);
      const float share = alpha > 0 ? 1 / static_cast<float>(alpha) : 0;
      out.colors.at(x, y) = lab_of(sum[0] * share, sum[1] * share, sum[2] * share);
    }
  return out;
}

}  // namespace sinew::picture
