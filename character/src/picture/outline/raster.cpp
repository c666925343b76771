// SPDX-License-Identifier: MIT
#include "picture/outline/raster.hpp"

#include <algorithm>
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
  // A frame of one pixel stands for what lies outside.
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

}  // namespace sinew::picture
