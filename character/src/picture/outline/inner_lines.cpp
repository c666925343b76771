// SPDX-License-Identifier: MIT
// Slits along lines that are drawn inside of a figure.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "picture/outline/figure_parts.hpp"

namespace sinew::picture {
namespace {

// Shares of the longest side of the picture.
constexpr float kWidestStroke = 0.02f, kShortestLine = 0.1f, kThinnestLimb = 0.025f;
constexpr float kContrast = 18;     // of L between a stroke and what is on both sides of it
constexpr float kBorderInk = 0.3f;  // less ink than that at a depth: the outline's own stroke has ended
// The part that a slit separates is a limb if it is so many times as long as its largest depth below the outline. A
// neck or a snout is not.
constexpr float kSlender = 2.4f;
constexpr int32_t kMostBranches = 4;

// The largest (or least) value of each square of 2 * radius + 1 pixels.
template <typename Better>
Grid<float> extreme(const Grid<float>& in, uint32_t radius, const Better& better) {
  const auto along = [&](uint32_t count, uint32_t stride, size_t first, const Grid<float>& from, Grid<float>* to) {
    for (uint32_t i = 0; i < count; ++i) {
      const uint32_t begin = i < radius ? 0 : i - radius, end = std::min(count - 1, i + radius);
      float best = from.values[first + size_t{begin} * stride];
      for (uint32_t k = begin + 1; k <= end; ++k) best = better(best, from.values[first + size_t{k} * stride]);
      to->values[first + size_t{i} * stride] = best;
    }
  };
  Grid<float> rows(in.width, in.height), out(in.width, in.height);
  for (uint32_t y = 0; y < in.height; ++y) along(in.width, 1, size_t{y} * in.width, in, &rows);
  for (uint32_t x = 0; x < in.width; ++x) along(in.height, in.width, x, rows, &out);
  return out;
}

// Lines darker than both of their sides: closing minus the picture (the black top hat).
Mask strokes_of(const Grid<Lab>& colors, const Mask& figure, uint32_t radius) {
  Grid<float> light(colors.width, colors.height, 100);  // as paper where there is no figure
  for (size_t i = 0; i < light.values.size(); ++i)
    if (figure.inside[i] != 0) light.values[i] = colors.values[i][0];
  const Grid<float> closed_light = extreme(extreme(light, radius, [](float a, float b) { return std::max(a, b); }),
                                           radius, [](float a, float b) { return std::min(a, b); });
  Mask out = figure;
  for (size_t i = 0; i < out.inside.size(); ++i)
    out.inside[i] = figure.inside[i] != 0 && closed_light.values[i] - light.values[i] > kContrast ? 1 : 0;
  return out;
}

// How deep the outline's own stroke reaches, in pixels.
float border_depth(const Mask& ink, const Grid<float>& depth, float most) {
  std::vector<size_t> pixels(static_cast<size_t>(most) + 2), inked(pixels.size());
  for (size_t i = 0; i < depth.values.size(); ++i) {
    const auto at = static_cast<size_t>(depth.values[i]);
    if (depth.values[i] <= 0 || at >= pixels.size()) continue;
    ++pixels[at];
    inked[at] += ink.inside[i];
  }
  size_t end = 1;
  while (end + 1 < pixels.size() && static_cast<float>(inked[end]) >= kBorderInk * static_cast<float>(pixels[end]))
    ++end;
  return static_cast<float>(end) + 1;
}

// Paths through ink from one pixel, by breadth. Leaves are where they end.
class InkPaths {
 public:
  explicit InkPaths(const Mask& ink) : ink_(ink), from_(ink.inside.size(), kNone), steps_(ink.inside.size(), 0) {}
  // The path from `start` to the nearest pixel for which `goal` holds; goals need no ink.
  template <typename Goal>
  std::vector<uint32_t> to(uint32_t start, const Goal& goal) {
    spread(start, goal);
    std::vector<uint32_t> way = back_from(reached_.back());
    forget();
    return way;
  }
  // Those to the ends of branches, the longest first, no two ends nearer than `apart` steps of each other.
  std::vector<std::vector<uint32_t>> to_leaves(uint32_t start, uint32_t apart) {
    spread(start, [](uint32_t) { return false; });
    std::vector<std::vector<uint32_t>> out;
    for (size_t r = reached_.size(); r-- > 0 && out.size() < kMostLeaves;) {
      const uint32_t leaf = reached_[r];
      bool ends = true;
      each_around(leaf, [&](uint32_t i) { ends = ends && (from_[i] == kNone || steps_[i] <= steps_[leaf]); });
      const auto near = [&](const std::vector<uint32_t>& other) {
        const auto dx = static_cast<int64_t>(other.back() % ink_.width) - leaf % ink_.width,
                   dy = static_cast<int64_t>(other.back() / ink_.width) - leaf / ink_.width;
        return std::max(std::abs(dx), std::abs(dy)) < apart;
      };
      if (ends && std::none_of(out.begin(), out.end(), near)) out.push_back(back_from(leaf));
    }
    forget();
    return out;
  }

 private:
  static constexpr uint32_t kNone = UINT32_MAX;
  static constexpr size_t kMostLeaves = 16;
  template <typename Visit>
  void each_around(uint32_t at, const Visit& visit) const {
    const int64_t x = at % ink_.width, y = at / ink_.width;
    for (int64_t dy = -1; dy <= 1; ++dy)
      for (int64_t dx = -1; dx <= 1; ++dx)
        if (x + dx >= 0 && y + dy >= 0 && x + dx < ink_.width && y + dy < ink_.height)
          visit(static_cast<uint32_t>((y + dy) * ink_.width + x + dx));
  }
  template <typename Goal>
  void spread(uint32_t start, const Goal& goal) {
    reached_ = {start};
    from_[start] = start;
    for (size_t next = 0; next < reached_.size(); ++next) {
      const uint32_t at = reached_[next];
      bool there = false;
      each_around(at, [&](uint32_t i) {
        if (there || from_[i] != kNone || !(ink_.inside[i] != 0 || goal(i))) return;
        from_[i] = at;
        steps_[i] = steps_[at] + 1;
        reached_.push_back(i);
        there = goal(i);
      });
      if (there) return;
    }
  }
  std::vector<uint32_t> back_from(uint32_t end) const {
    std::vector<uint32_t> way = {end};
    while (from_[way.back()] != way.back()) way.push_back(from_[way.back()]);
    std::reverse(way.begin(), way.end());
    return way;
  }
  void forget() {
    for (const uint32_t i : reached_) from_[i] = kNone, steps_[i] = 0;
  }

  const Mask& ink_;
  std::vector<uint32_t> from_, steps_, reached_;
};

// Up to its first corner: where it rotates by 50 degrees within 2 * `reach` pixels, another line goes on.
void end_at_corner(uint32_t width, size_t reach, std::vector<uint32_t>* way) {
  constexpr float kCosine = 0.643f;
  const auto towards = [&](size_t from, size_t to) {
    const std::array<float, 2> d = {static_cast<float>((*way)[to] % width) - static_cast<float>((*way)[from] % width),
                                    static_cast<float>((*way)[to] / width) - static_cast<float>((*way)[from] / width)};
    const float n = std::max(std::hypot(d[0], d[1]), 1e-6f);
    return std::array<float, 2>{d[0] / n, d[1] / n};
  };
  for (size_t i = reach; i + reach < way->size(); ++i) {
    const std::array<float, 2> before = towards(i - reach, i), after = towards(i, i + reach);
    if (before[0] * after[0] + before[1] * after[1] >= kCosine) continue;
    way->resize(i);
    return;
  }
}

struct Search {
  const Grid<float>& depth;  // of the figure's pixels below its border
  float border;              // how deep the outline's stroke is
  float shortest, thinnest;  // of a line, and of what it frees
  uint32_t reach;            // pixels, of a widest stroke: what is nearer than that is one point
};

// The longest lines without a corner of one part of the inner ink, each from where it leaves the outline's stroke:
// slits in `figure`. How many.
//   inside, out  paths through `inner`, and from there out of the figure
size_t cut_part(const Search& search, const std::vector<uint32_t>& anchors, InkPaths* inside, InkPaths* out,
                Mask* inner, Mask* figure) {
  size_t cuts = 0;
  for (int32_t branch = 0; branch < kMostBranches; ++branch) {
    std::vector<uint32_t> longest;
    for (const uint32_t anchor : anchors) {
      if (inner->inside[anchor] == 0) continue;
      for (std::vector<uint32_t>& way : inside->to_leaves(anchor, search.reach)) {
        end_at_corner(inner->width, search.reach, &way);
        if (way.size() > longest.size()) longest = std::move(way);
      }
    }
    if (static_cast<float>(longest.size()) < search.shortest) break;
    const auto below = [&](uint32_t a, uint32_t b) { return search.depth.values[a] < search.depth.values[b]; };
    const float deepest = search.depth.values[*std::max_element(longest.begin(), longest.end(), below)];
    const bool slender = static_cast<float>(longest.size()) >= kSlender * deepest;
    // A line along the outline is the outline's stroke; one that ends at it divides the figure from border to border.
    const auto is_deep = [&](uint32_t i) {
      return search.depth.values[i] > std::max(search.thinnest, 2.5f * search.border);
    };
    const auto deep = static_cast<size_t>(std::count_if(longest.begin(), longest.end(), is_deep));
    const bool free_end = search.depth.values[longest.back()] > 2 * search.border;
    if (slender && free_end && 2 * deep > longest.size()) {
      std::vector<uint32_t> slit = longest;
      const auto outside = [&](uint32_t i) { return search.depth.values[i] <= 0; };
      const std::vector<uint32_t> way = out->to(longest.front(), outside);
      slit.insert(slit.end(), way.begin(), way.end());
      if (open_slit(slit, figure)) ++cuts;
    }
    take_out(longest, search.reach / 2, inner);  // its pixels are used up
  }
  return cuts;
}

}  // namespace

void cut_inner_lines(const Grid<Lab>& colors, Figure* figure) {
  const auto side = static_cast<float>(std::max(colors.width, colors.height));
  const auto radius = std::max(2u, static_cast<uint32_t>(0.5f * kWidestStroke * side + 0.5f));
  const Mask ink = strokes_of(colors, figure->mask, radius);
  Grid<float> depth = squared_distance(figure->mask, true);
  for (float& d : depth.values) d = std::sqrt(d);
  const Search search = {depth, border_depth(ink, depth, 2 * kWidestStroke * side), kShortestLine * side,
                         kThinnestLimb * side, 2 * radius};
  Mask inner = ink;
  for (size_t i = 0; i < inner.inside.size(); ++i)
    if (depth.values[i] <= search.border) inner.inside[i] = 0;
  const Parts parts = parts_of(inner, true);
  std::vector<std::vector<uint32_t>> anchors(
      parts.sizes.size());  // pixels next to the outline's stroke, one of each such point
  std::vector<uint8_t> near(ink.inside.size(), 0);
  for (uint32_t i = 0; i < inner.inside.size(); ++i) {
    const int32_t part = parts.numbers.values[i];
    if (part < 0 || depth.values[i] > search.border + 1.5f || near[i] != 0) continue;
    anchors[static_cast<size_t>(part)].push_back(i);
    const uint32_t x = i % inner.width, y = i / inner.width;
    for (uint32_t v = y; v < std::min(inner.height, y + radius); ++v)
      for (uint32_t u = x < radius ? 0 : x - radius; u < std::min(inner.width, x + radius); ++u)
        near[size_t{v} * inner.width + u] = 1;
  }
  Mask outwards = ink;  // its border is half paper, and no ink
  for (size_t i = 0; i < outwards.inside.size(); ++i)
    if (depth.values[i] > 0 && depth.values[i] <= search.border + 1) outwards.inside[i] = 1;
  InkPaths inside(inner), out(outwards);
  size_t cuts = 0;
  for (size_t p = 0; p < parts.sizes.size(); ++p)
    if (static_cast<float>(parts.sizes[p]) >= search.shortest)
      cuts += cut_part(search, anchors[p], &inside, &out, &inner, &figure->mask);
  figure->notes.push_back(
      cuts == 0 ? "no line runs from the outline into the figure, so nothing was cut; cut by hand with --mask"
                : std::to_string(cuts) + (cuts == 1 ? " line that runs" : " lines that run") +
                      " into the figure were cut open, a guess; see them with --mask-out, cut by hand with --mask");
}

}  // namespace sinew::picture
