// SPDX-License-Identifier: MIT
// Slits between limbs and the body that they are drawn against.
#include "sinew_character/picture/free_limbs.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "picture/outline/figure_parts.hpp"

namespace sinew {
namespace {

using Point = std::array<float, 2>;

constexpr float kAttached = 0.4f;  // of its first bone, what stays on the body
constexpr float kTouches = 1.5f;   // half widths: where the figure goes on for more, there is body beside the limb
constexpr float kBefore = 1.6f;    // half widths: farther from the outline a limb lies before the body
constexpr float kRoom = 1.1f;      // half widths from the bone to the slit
constexpr float kLeastRun = 1.5f;  // half widths that a slit is long
constexpr float kMiddle = 0.8f;    // of the distance to the torso's middle, which a slit is nearer than
constexpr size_t kFewest = 8;      // pixels of a limb

// A point of a bone, with how far the figure goes on to both of its sides.
struct Sample {
  Point at, along, inwards;
  float inside, outside;  // how far
  float middle;           // to the body's
};

Point moved(const Point& p, const Point& direction, float length) {
  return {p[0] + length * direction[0], p[1] + length * direction[1]};
}

bool is_in(const Mask& mask, const Point& p) {
  return mask.at(static_cast<int64_t>(std::floor(p[0])), static_cast<int64_t>(std::floor(p[1])));
}

float way_out(const Mask& mask, const Point& from, const Point& direction) {
  float way = 0;
  while (is_in(mask, moved(from, direction, way))) way += 0.5f;
  return way;
}

// A pixel apart, from where the limb leaves the body to its end.
std::vector<Sample> samples_of(const DrawnLimb& limb, const Mask& mask) {
  std::vector<Sample> out;
  for (size_t b = 0; b + 1 < limb.points.size(); ++b) {
    const Point from = limb.points[b], to = limb.points[b + 1];
    const float length = std::hypot(to[0] - from[0], to[1] - from[1]);
    if (length < 1) continue;
    const Point along = {(to[0] - from[0]) / length, (to[1] - from[1]) / length};
    for (float t = b == 0 ? kAttached * length : 0; t < length; ++t) {
      const Point at = moved(from, along, t);
      Point inwards = {-along[1], along[0]};
      float middle = inwards[0] * (limb.body[0] - at[0]) + inwards[1] * (limb.body[1] - at[1]);
      if (middle < 0) inwards = {along[1], -along[0]}, middle = -middle;
      if (!is_in(mask, at)) continue;
      out.push_back(
          {at, along, inwards, way_out(mask, at, inwards), way_out(mask, at, {-inwards[0], -inwards[1]}), middle});
    }
  }
  return out;
}

// The mean width to the outside over two half widths along the limb, half at least: bones do not lie in the middle of a limb everywhere.
std::vector<float> even_widths(const std::vector<Sample>& samples, float half) {
  std::vector<float> out;
  const auto reach = static_cast<size_t>(half) + 1;
  for (size_t k = 0; k < samples.size(); ++k) {
    const size_t first = k < reach ? 0 : k - reach, last = std::min(samples.size(), k + reach + 1);
    float sum = 0;
    for (size_t i = first; i < last; ++i) sum += std::min(samples[i].outside, kBefore * half);
    out.push_back(std::max(half, sum / static_cast<float>(last - first)));
  }
  return out;
}

class Slit {
 public:
  Slit(const std::vector<Sample>& samples, const std::vector<float>& widths, const Mask& mask)
      : samples_(samples), widths_(widths), mask_(mask) {}

  // Beside samples first .. last. nullopt where neither end of it comes out of the figure.
  std::optional<std::vector<Point>> beside(size_t first, size_t last) {
    bool open = first > 0 && leaves(first, false);
    std::reverse(path_.begin(), path_.end());
    for (size_t k = first; k <= last; ++k) path_.push_back(point(k));
    open = (last + 1 < samples_.size() ? leaves(last, true) : goes_round(last)) || open;
    return open ? std::optional(path_) : std::nullopt;
  }

 private:
  Point point(size_t k) const { return moved(samples_[k].at, samples_[k].inwards, kRoom * widths_[k]); }

  // Goes on beside the limb until it is out, at most two half widths.
  bool leaves(size_t from, bool forwards) {
    const auto most = static_cast<size_t>(2 * widths_[from]) + 2;
    const size_t before = path_.size();
    for (size_t i = 1; i <= most; ++i) {
      if (forwards ? from + i >= samples_.size() : i > from) break;
      path_.push_back(point(forwards ? from + i : from - i));
      if (!is_in(mask_, path_.back())) return true;
    }
    path_.resize(before);
    return false;
  }

  // Round the limb's end to the outline.
  bool goes_round(size_t last) {
    const Sample& end = samples_[last];
    const float radius = kRoom * widths_[last], step = 0.5f / std::max(radius, 1.0f);
    const Point outwards = {-end.inwards[0], -end.inwards[1]};
    for (float angle = 0; angle < std::numbers::pi_v<float>; angle += step) {
      path_.push_back(moved(moved(end.at, end.inwards, radius * std::cos(angle)), end.along, radius * std::sin(angle)));
      if (!is_in(mask_, path_.back())) return true;
    }
    for (float way = radius; way < 2 * kBefore * widths_[last]; ++way) {
      path_.push_back(moved(end.at, outwards, way));
      if (!is_in(mask_, path_.back())) return true;
    }
    return false;
  }

  const std::vector<Sample>& samples_;
  const std::vector<float>& widths_;
  const Mask& mask_;
  std::vector<Point> path_;
};

std::vector<uint32_t> pixels_of(const std::vector<Point>& path, const Mask& mask) {
  std::vector<uint32_t> out;
  for (size_t i = 0; i + 1 < path.size(); ++i) {
    const float length = std::hypot(path[i + 1][0] - path[i][0], path[i + 1][1] - path[i][1]);
    const auto steps = static_cast<size_t>(2 * length) + 1;
    for (size_t s = 0; s <= steps; ++s) {
      const float t = static_cast<float>(s) / static_cast<float>(steps);
      const Point p = {path[i][0] + t * (path[i + 1][0] - path[i][0]), path[i][1] + t * (path[i + 1][1] - path[i][1])};
      if (!is_in(mask, p)) continue;
      out.push_back(static_cast<uint32_t>(p[1]) * mask.width + static_cast<uint32_t>(p[0]));
    }
  }
  return out;
}

bool free_limb(const DrawnLimb& limb, Figure* figure) {
  const std::vector<Sample> samples = samples_of(limb, figure->mask);
  if (samples.size() < kFewest) return false;
  std::vector<float> widths;
  for (const Sample& s : samples) widths.push_back(s.outside);
  const auto typical = widths.begin() + static_cast<std::ptrdiff_t>(widths.size() / 2);
  std::nth_element(widths.begin(), typical, widths.end());
  const float half = *typical;
  widths = even_widths(samples, half);
  const auto touches = [&](const Sample& s) {
    return s.outside <= kBefore * half && s.inside > kTouches * half && kRoom * half < kMiddle * s.middle;
  };
  bool any = false;
  for (size_t first = 0; first < samples.size();) {
    size_t end = first;
    while (end < samples.size() && touches(samples[end])) ++end;
    if (static_cast<float>(end - first) >= kLeastRun * half) {
      const std::optional<std::vector<Point>> path = Slit(samples, widths, figure->mask).beside(first, end - 1);
      if (path && picture::open_slit(pixels_of(*path, figure->mask), &figure->mask)) {
        figure->slits.push_back(*path);
        any = true;
      }
    }
    first = end + 1;
  }
  return any;
}

}  // namespace

size_t free_limbs(const std::vector<DrawnLimb>& limbs, Figure* figure) {
  std::string names;
  size_t count = 0;
  for (const DrawnLimb& limb : limbs) {
    if (!free_limb(limb, figure)) continue;
    names += (count++ == 0 ? "" : ", ") + limb.name;
  }
  if (count > 0)
    figure->notes.push_back("cut free from the body, a guess: " + names + "; --whole keeps the figure in one piece");
  return count;
}

}  // namespace sinew
