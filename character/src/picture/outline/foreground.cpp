// SPDX-License-Identifier: MIT
// Background grown inwards from the border; what is left.
#include "picture/outline/foreground.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace sinew::picture {
namespace {

// Shadows are darker by up to so much, of nearly the same hue, and begin softly.
constexpr float kDarkestShadow = 30, kShadowStep = 0.8f;
// The blur of a shadow cannot be measured within this many pixels of the object.
constexpr uint32_t kShadowGap = 4;
// A part that only a wider gap's closing encloses is one, where the figure grows by so much. Less is what lies between legs.
constexpr float kNewPart = 1.35f;
// Share of the longest side, if nothing was closed before.
constexpr float kWidestGap = 0.014f;
constexpr float kSeam = 2;  // pixels between what a gap lets in and its strokes

std::vector<uint32_t> border_of(const Mask& domain, float width) {
  const Grid<float> deep = squared_distance(domain, true);
  std::vector<uint32_t> out;
  for (uint32_t i = 0; i < deep.values.size(); ++i)
    if (domain.inside[i] != 0 && deep.values[i] <= width * width) out.push_back(i);
  return out;
}

// Means of L over 5 x 5 pixels of the same domain, what the background has there taken off.
Grid<float> blurred_light(const Grid<float>& off) {
  Grid<float> rows(off.width, off.height), out(off.width, off.height);
  const auto mean = [](uint32_t at, uint32_t n, const auto& value) {
    const uint32_t first = at < 2 ? 0 : at - 2, last = std::min(n - 1, at + 2);
    float sum = 0;
    for (uint32_t k = first; k <= last; ++k) sum += value(k);
    return sum / static_cast<float>(last - first + 1);
  };
  for (uint32_t y = 0; y < off.height; ++y)
    for (uint32_t x = 0; x < off.width; ++x)
      rows.at(x, y) = mean(x, off.width, [&](uint32_t k) { return off.at(k, y); });
  for (uint32_t y = 0; y < off.height; ++y)
    for (uint32_t x = 0; x < off.width; ++x)
      out.at(x, y) = mean(y, off.height, [&](uint32_t k) { return rows.at(x, k); });
  return out;
}

struct BackgroundLikeness {
  Grid<uint8_t> likeness;
  Grid<float> light;  // blurred
  float step = 0;     // between neighbors in a shadow
};

BackgroundLikeness judge(const Grid<Lab>& colors, const Mask& domain, const Background& background) {
  Grid<float> off(colors.width, colors.height);  // of L
  BackgroundLikeness out = {Grid<uint8_t>(colors.width, colors.height), {}, kShadowStep + 0.3f * background.noise()};
  const float tolerance = background.tolerance();
  for (uint32_t y = 0; y < colors.height; ++y)
    for (uint32_t x = 0; x < colors.width; ++x) {
      const Lab d = background.off(x, y, colors.at(x, y));
      off.at(x, y) = d[0];
      const size_t i = off.index(x, y);
      if (domain.inside[i] == 0) continue;
      const bool shadow = background.smooth() && d[0] < 0 && d[0] > -kDarkestShadow - 2 * background.noise() &&
                          std::hypot(d[1], d[2]) < 0.6f * tolerance + 0.15f * std::abs(d[0]);
      out.likeness.values[i] = length(d) <= tolerance ? kLike : shadow ? kShadow : kUnlike;
    }
  out.light = blurred_light(off);
  return out;
}

// Calls for the four neighbors of a pixel.
template <typename Visit>
void each_neighbor(uint32_t i, uint32_t width, uint32_t height, const Visit& visit) {
  const uint32_t x = i % width, y = i / width;
  if (x > 0) visit(i - 1);
  if (x + 1 < width) visit(i + 1);
  if (y > 0) visit(i - width);
  if (y + 1 < height) visit(i + width);
}

// 1 = reached from the border through what is like the background.
std::vector<uint8_t> grow(const BackgroundLikeness& judged, const std::vector<uint32_t>& border) {
  const uint32_t width = judged.likeness.width, height = judged.likeness.height;
  std::vector<uint8_t> reached(judged.likeness.values.size(), 0);
  std::vector<uint32_t> todo;
  for (const uint32_t i : border)
    if (judged.likeness.values[i] == kLike) reached[i] = 1, todo.push_back(i);
  std::vector<uint32_t> shadows;
  while (!todo.empty()) {
    const uint32_t i = todo.back();
    todo.pop_back();
    if (judged.likeness.values[i] == kShadow) shadows.push_back(i);
    each_neighbor(i, width, height, [&](uint32_t next) {
      if (reached[next] != 0 || judged.likeness.values[next] == kUnlike) return;
      if (judged.likeness.values[next] == kShadow &&
          std::abs(judged.light.values[next] - judged.light.values[i]) > judged.step)
        return;
      reached[next] = 1;
      todo.push_back(next);
    });
  }
  for (uint32_t round = 0; round < kShadowGap; ++round) {
    std::vector<uint32_t> next_shadows;
    for (const uint32_t i : shadows)
      each_neighbor(i, width, height, [&](uint32_t next) {
        if (reached[next] != 0 || judged.likeness.values[next] == kUnlike) return;
        reached[next] = 1;
        next_shadows.push_back(next);
      });
    shadows = std::move(next_shadows);
  }
  return reached;
}

size_t count_of(const std::vector<uint8_t>& bits) {
  return static_cast<size_t>(std::count_if(bits.begin(), bits.end(), [](uint8_t bit) { return bit != 0; }));
}

// The area enclosed by the strokes, with gaps of up to 2 * radius closed.
struct Enclosed {
  Mask barrier;  // the strokes, closed
  Mask inner;    // what lies in them
};
Enclosed enclosed(const Mask& strokes, const Mask& domain, float radius) {
  Enclosed out = {closed(strokes, radius), strokes};
  const Parts outside = parts_of(out.barrier, false);
  std::vector<uint8_t> open(outside.sizes.size(), 0);
  const uint32_t width = strokes.width, height = strokes.height;
  for (uint32_t i = 0; i < strokes.inside.size(); ++i) {
    const int32_t part = outside.numbers.values[i];
    if (part < 0) continue;
    const uint32_t x = i % width, y = i / width;
    if (x == 0 || y == 0 || x + 1 == width || y + 1 == height || domain.inside[i] == 0)
      open[static_cast<size_t>(part)] = 1;
  }
  for (size_t i = 0; i < out.inner.inside.size(); ++i) {
    const int32_t part = outside.numbers.values[i];
    out.inner.inside[i] = part >= 0 && open[static_cast<size_t>(part)] == 0 ? 1 : 0;
  }
  return out;
}

Mask either(Mask a, const Mask& b) {
  for (size_t i = 0; i < a.inside.size(); ++i) a.inside[i] |= b.inside[i];
  return a;
}

// Outlines whose ends do not meet: the least gap whose closing makes a figure of strokes twice as large. A wider one
// that lets in as much as a torso beside a head adds what it encloses, and leaves the rest as it was.
void close_strokes(const Mask& domain, Foreground* out) {
  const size_t ink = count_of(out->mask.inside) - count_of(out->likeness.values);
  if (ink == 0) return;
  const auto largest = static_cast<float>(std::max(domain.width, domain.height));
  const Mask strokes = out->mask;
  size_t pixels = 0;
  for (const float share : {0.0f, 0.004f, 0.008f, 0.014f, 0.022f, 0.03f}) {
    if (!out->drawn && share > kWidestGap) return;
    const float radius = share * largest;
    const Enclosed found = enclosed(strokes, domain, radius);
    const Mask filled = out->drawn ? closed(either(out->mask, found.inner), kSeam) : either(found.barrier, found.inner);
    const size_t count = count_of(filled.inside);
    if (out->drawn ? static_cast<float>(count) < kNewPart * static_cast<float>(pixels) : count < 2 * ink) continue;
    out->drawn = true;
    out->mask = filled;
    pixels = count;
  }
}

// Whether a tenth of the ink has ink all round: no strokes, and nothing to be filled. Quick, for what most pictures show.
bool is_solid(const Foreground& found) {
  const int64_t reach = std::max<int64_t>(3, std::max(found.mask.width, found.mask.height) / 64);
  const auto is_ink = [&](int64_t x, int64_t y) {
    return found.mask.at(x, y) &&
           found.likeness.values[static_cast<size_t>(y) * found.mask.width + static_cast<size_t>(x)] == kUnlike;
  };
  size_t ink = 0, deep = 0;
  for (int64_t y = 0; y < int64_t{found.mask.height}; ++y)
    for (int64_t x = 0; x < int64_t{found.mask.width}; ++x) {
      if (!is_ink(x, y)) continue;
      ++ink;
      deep += is_ink(x - reach, y) && is_ink(x + reach, y) && is_ink(x, y - reach) && is_ink(x, y + reach) ? 1 : 0;
    }
  return deep * 10 > ink;
}

}  // namespace

Foreground find_foreground(const Grid<Lab>& colors, const Mask& domain) {
  const auto largest = static_cast<float>(std::max(domain.width, domain.height));
  const std::vector<uint32_t> border = border_of(domain, std::max(4.0f, 0.025f * largest));
  Foreground out;
  out.mask = domain;
  out.likeness = Grid<uint8_t>(domain.width, domain.height, kUnlike);
  if (border.empty()) return out;
  const Background first(colors, border);
  std::vector<uint8_t> reached, likeness;
  {
    BackgroundLikeness judged = judge(colors, domain, first);
    reached = grow(judged, border);
    likeness = std::move(judged.likeness.values);
  }
  // Again by all that was found, shadows left out.
  std::vector<uint32_t> known;
  for (uint32_t i = 0; i < reached.size(); ++i)
    if (reached[i] != 0 && likeness[i] == kLike) known.push_back(i);
  if (known.size() < border.size() / 4) return out;
  const Background second(colors, known);
  const BackgroundLikeness judged = judge(colors, domain, second);
  reached = grow(judged, border);
  for (size_t i = 0; i < reached.size(); ++i) {
    out.mask.inside[i] = domain.inside[i] != 0 && reached[i] == 0 ? 1 : 0;
    out.likeness.values[i] = out.mask.inside[i] != 0 ? judged.likeness.values[i] : uint8_t{kUnlike};
  }
  close_strokes(domain, &out);
  return out;
}

bool fill_outline(const Foreground& found, const Mask& domain, Mask* part) {
  Foreground alone = {*part, found.likeness, false};
  for (size_t i = 0; i < part->inside.size(); ++i)
    if (part->inside[i] == 0) alone.likeness.values[i] = kUnlike;
  if (is_solid(alone)) return false;
  close_strokes(domain, &alone);
  if (alone.drawn) *part = std::move(alone.mask);
  return alone.drawn;
}

}  // namespace sinew::picture
