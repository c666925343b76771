// SPDX-License-Identifier: MIT
#include "picture/outline/lab.hpp"

#include <algorithm>
#include <cmath>

namespace sinew::picture {
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
      out.colours.at(x, y) = lab_of(sum[0] * share, sum[1] * share, sum[2] * share);
    }
  return out;
}

}  // namespace sinew::picture
