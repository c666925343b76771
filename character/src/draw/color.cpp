// SPDX-License-Identifier: MIT
// Colors of pictures: conversions, one color per joint, weights and errors as vertex colors.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "sinew_character/draw/image.hpp"

namespace sinew {
namespace {

float linear_of(uint8_t byte) {
  const float x = static_cast<float>(byte) / 255;
  return x <= 0.04045f ? x / 12.92f : std::pow((x + 0.055f) / 1.055f, 2.4f);
}

const std::array<float, 256>& linear_table() {
  static const std::array<float, 256> table = [] {
    std::array<float, 256> t{};
    for (size_t i = 0; i < t.size(); ++i) t[i] = linear_of(static_cast<uint8_t>(i));
    return t;
  }();
  return table;
}

// Oklab (Ottosson 2020) keeps lightness and colorfulness even over all hues, which HSV does not.
Linear oklch(float lightness, float chroma, float hue) {
  const float a = chroma * std::cos(hue), b = chroma * std::sin(hue);
  const float l = lightness + 0.3963377774f * a + 0.2158037573f * b;
  const float m = lightness - 0.1055613458f * a - 0.0638541728f * b;
  const float s = lightness - 0.0894841775f * a - 1.2914855480f * b;
  const float l3 = l * l * l, m3 = m * m * m, s3 = s * s * s;
  return {4.0767416621f * l3 - 3.3077115913f * m3 + 0.2309699292f * s3,
          -1.2684380046f * l3 + 2.6097574011f * m3 - 0.3413193965f * s3,
          -0.0041960863f * l3 - 0.7034186147f * m3 + 1.7076147010f * s3};
}

}  // namespace

Linear to_linear(const std::array<uint8_t, 3>& srgb) {
  const auto& table = linear_table();
  return {table[srgb[0]], table[srgb[1]], table[srgb[2]]};
}

std::array<uint8_t, 3> to_srgb(const Linear& light) {
  std::array<uint8_t, 3> out{};
  for (size_t i = 0; i < 3; ++i) {
    const float x = std::clamp(light[i], 0.0f, 1.0f);
    const float y = x <= 0.0031308f ? 12.92f * x : 1.055f * std::pow(x, 1 / 2.4f) - 0.055f;
    out[i] = static_cast<uint8_t>(std::lround(y * 255));
  }
  return out;
}

std::array<uint8_t, 3> joint_color(size_t joint) {
  // Steps of the golden angle never come close to an earlier hue for long; three tones tell apart those that do.
  constexpr double golden_angle = std::numbers::pi * (3 - 2.23606797749978969);
  constexpr std::array<std::array<float, 2>, 3> tones = {{{0.72f, 0.15f}, {0.58f, 0.17f}, {0.84f, 0.12f}}};
  const auto& tone = tones[joint % tones.size()];
  const double hue = std::fmod(0.5 + golden_angle * static_cast<double>(joint), 2 * std::numbers::pi);
  return to_srgb(oklch(tone[0], tone[1], static_cast<float>(hue)));
}

std::vector<std::array<uint8_t, 3>> weight_colors(const Character& character) {
  constexpr std::array<uint8_t, 3> unbound = {150, 150, 150};
  std::vector<Linear> palette;
  for (size_t j = 0; j < character.joints.size(); ++j) palette.push_back(to_linear(joint_color(j)));
  std::vector<std::array<uint8_t, 3>> colors(character.vertices.size(), unbound);
  for (size_t v = 0; v < std::min(colors.size(), character.influences.size()); ++v) {
    Linear light{};
    float sum = 0;
    for (const Influence& influence : character.influences[v]) {
      if (influence.joint >= palette.size() || !(influence.weight > 0)) continue;
      for (size_t i = 0; i < 3; ++i) light[i] += influence.weight * palette[influence.joint][i];
      sum += influence.weight;
    }
    if (sum <= 0) continue;
    for (float& x : light) x /= sum;
    colors[v] = to_srgb(light);
  }
  return colors;
}

std::vector<std::array<uint8_t, 3>> heat_colors(const std::vector<float>& values, float scale) {
  // Lightness rises to yellow at the middle, then red takes over: small errors recede, large ones stand out.
  constexpr std::array<std::array<float, 3>, 5> stops = {
      {{34, 48, 102}, {58, 116, 158}, {246, 222, 110}, {238, 128, 44}, {196, 22, 34}}};
  std::vector<std::array<uint8_t, 3>> colors(values.size());
  for (size_t v = 0; v < values.size(); ++v) {
    const float share = scale > 0 ? std::clamp(values[v] / scale, 0.0f, 1.0f) : 0.0f;
    const float at = share * static_cast<float>(stops.size() - 1);
    const size_t low = std::min(static_cast<size_t>(at), stops.size() - 2);
    const float t = at - static_cast<float>(low);
    for (size_t i = 0; i < 3; ++i)
      colors[v][i] = static_cast<uint8_t>(std::lround(stops[low][i] + t * (stops[low + 1][i] - stops[low][i])));
  }
  return colors;
}

}  // namespace sinew
