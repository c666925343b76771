// SPDX-License-Identifier: MIT
// Which part of a mask is the figure, whether it is a sheet of paper, and where it has holes.
#include "picture/outline/figure_parts.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "sinew_formats/error.hpp"

namespace sinew::picture {
namespace {

struct Part {
  size_t number = 0, pixels = 0;
  uint32_t left = UINT32_MAX, right = 0, top = UINT32_MAX, bottom = 0;
  uint32_t side() const { return std::max(right - left, bottom - top) + 1; }
};

// Least share of the largest one's pixels that makes a separate figure.
constexpr size_t kFigureShare = 5;
constexpr size_t kMostFigures = 12;
constexpr size_t kCrumb = 40;  // pixels that a slit may split off

// Without crumbs; false: it falls in two.
bool keep_in_one(Mask* mask) {
  const Parts parts = parts_of(*mask, true);
  if (parts.sizes.empty()) return false;
  const auto main = std::max_element(parts.sizes.begin(), parts.sizes.end()) - parts.sizes.begin();
  for (size_t p = 0; p < parts.sizes.size(); ++p)
    if (static_cast<std::ptrdiff_t>(p) != main && parts.sizes[p] > kCrumb) return false;
  for (size_t i = 0; i < mask->inside.size(); ++i)
    if (parts.numbers.values[i] != main) mask->inside[i] = 0;
  return true;
}

}  // namespace

ChosenPart choose_part(const std::string& name, const Mask& mask, uint32_t number) {
  const auto largest_side = static_cast<float>(std::max(mask.width, mask.height));
  const Mask touching = grown(mask, std::max(1.5f, 0.003f * largest_side));
  const Parts labels = parts_of(touching, true);
  std::vector<Part> parts(labels.sizes.size());
  for (uint32_t y = 0; y < mask.height; ++y)
    for (uint32_t x = 0; x < mask.width; ++x) {
      if (mask.inside[size_t{y} * mask.width + x] == 0) continue;
      Part& part = parts[static_cast<size_t>(labels.numbers.at(x, y))];
      ++part.pixels;
      part.left = std::min(part.left, x);
      part.right = std::max(part.right, x);
      part.top = std::min(part.top, y);
      part.bottom = std::max(part.bottom, y);
    }
  for (size_t p = 0; p < parts.size(); ++p) parts[p].number = p;
  const auto largest =
      std::max_element(parts.begin(), parts.end(), [](const Part& a, const Part& b) { return a.pixels < b.pixels; });
  const std::string cure = "; draw the figure on a plain background, or give its outline with --mask";
  if (largest == parts.end() || largest->pixels == 0)
    throw Error(name + ": no figure found: nothing differs from the border of the picture" + cure);
  const size_t all = size_t{mask.width} * mask.height;
  if (largest->pixels * 400 < all && static_cast<float>(largest->side()) < 0.15f * largest_side)
    throw Error(name + ": no figure found: the largest object is " + std::to_string(largest->side()) + " pixels long" +
                cure);
  if (largest->pixels < 64) throw Error(name + ": no figure found: too few pixels" + cure);
  if (largest->pixels * 50 > all * 49) throw Error(name + ": no figure found: the picture has no background" + cure);
  std::vector<Part> figures;
  for (const Part& part : parts)
    if (part.pixels * kFigureShare >= largest->pixels) figures.push_back(part);
  if (figures.size() > kMostFigures)
    throw Error(name + ": no figure found: " + std::to_string(figures.size()) +
                " objects of similar size, such as letters of a text" + cure);
  std::sort(figures.begin(), figures.end(),
            [](const Part& a, const Part& b) { return a.left + a.right < b.left + b.right; });
  if (number > figures.size())
    throw Error(name + ": no figure " + std::to_string(number) + ", found " + std::to_string(figures.size()) +
                " from left to right");
  ChosenPart out = {mask, static_cast<uint32_t>(figures.size()), number};
  size_t wanted = number > 0 ? figures[number - 1].number : largest->number;
  for (size_t f = 0; f < figures.size(); ++f)
    if (figures[f].number == wanted) out.number = static_cast<uint32_t>(f + 1);
  for (size_t i = 0; i < mask.inside.size(); ++i)
    out.mask.inside[i] = mask.inside[i] != 0 && labels.numbers.values[i] == static_cast<int32_t>(wanted) ? 1 : 0;
  return out;
}

std::optional<Mask> sheet_of(const Mask& part) {
  constexpr double kLeastShare = 0.25, kLeastOverlap = 0.93;
  constexpr double kNoFigure = 0.6;  // of the picture: more than a figure fills, whatever its shape
  // Corners: farthest along the diagonals.
  std::array<std::array<int64_t, 2>, 4> corners{};
  std::array<int64_t, 4> best;
  best.fill(INT64_MIN);
  int64_t pixels = 0;
  const Parts holes = parts_of(part, false);
  std::vector<uint8_t> open(holes.sizes.size(), 0);
  for (uint32_t y = 0; y < part.height; ++y)
    for (uint32_t x = 0; x < part.width; ++x)
      if (const int32_t hole = holes.numbers.at(x, y);
          hole >= 0 && (x == 0 || y == 0 || x + 1 == part.width || y + 1 == part.height))
        open[static_cast<size_t>(hole)] = 1;
  Mask filled = part;
  for (uint32_t y = 0; y < part.height; ++y)
    for (uint32_t x = 0; x < part.width; ++x) {
      const int32_t hole = holes.numbers.at(x, y);
      const bool in = hole < 0 || open[static_cast<size_t>(hole)] == 0;
      filled.inside[size_t{y} * part.width + x] = in ? 1 : 0;
      if (!in) continue;
      ++pixels;
      const int64_t sx = x, sy = y;
      const std::array<int64_t, 4> far = {-sx - sy, sx - sy, sx + sy, sy - sx};
      for (size_t c = 0; c < 4; ++c)
        if (far[c] > best[c]) best[c] = far[c], corners[c] = {sx, sy};
    }
  int64_t both = 0, quadrilateral = 0;
  for (uint32_t y = 0; y < part.height; ++y)
    for (uint32_t x = 0; x < part.width; ++x) {
      bool in = true;  // clockwise as seen, y down
      for (size_t c = 0; c < 4 && in; ++c) {
        const auto &a = corners[c], &b = corners[(c + 1) % 4];
        in = (b[0] - a[0]) * (int64_t{y} - a[1]) - (b[1] - a[1]) * (int64_t{x} - a[0]) >= 0;
      }
      if (!in) continue;
      ++quadrilateral;
      both += filled.inside[size_t{y} * part.width + x];
    }
  const double all = double{1} * part.width * part.height;
  const auto either = static_cast<double>(pixels + quadrilateral - both);
  const bool is_paper =
      static_cast<double>(both) >= kLeastOverlap * either || static_cast<double>(pixels) >= kNoFigure * all;
  if (static_cast<double>(pixels) < kLeastShare * all || !is_paper) return std::nullopt;
  const Grid<float> deep = squared_distance(filled, true);
  const float rim = std::max(3.0f, 0.012f * static_cast<float>(std::max(part.width, part.height)));
  for (size_t i = 0; i < filled.inside.size(); ++i) filled.inside[i] = deep.values[i] > rim * rim ? 1 : 0;
  return filled;
}

void take_out(const std::vector<uint32_t>& pixels, int64_t radius, Mask* mask) {
  for (const uint32_t i : pixels) {
    const int64_t x = i % mask->width, y = i / mask->width;
    for (int64_t dy = -radius; dy <= radius; ++dy)
      for (int64_t dx = -radius; dx <= radius; ++dx)
        if (mask->at(x + dx, y + dy)) mask->inside[static_cast<size_t>((y + dy) * mask->width + x + dx)] = 0;
  }
}

bool open_slit(const std::vector<uint32_t>& pixels, Mask* mask) {
  Mask tried = *mask;
  take_out(pixels, 1, &tried);
  if (!keep_in_one(&tried)) return false;
  *mask = std::move(tried);
  return true;
}

void open_holes(const Grid<uint8_t>& likeness, Mask* figure) {
  constexpr size_t kLeastShare = 1000, kLitShare = 4, kLeastIsland = 12;
  const auto pixels = static_cast<size_t>(std::count(figure->inside.begin(), figure->inside.end(), uint8_t{1}));
  Mask candidates = *figure;
  for (size_t i = 0; i < candidates.inside.size(); ++i)
    candidates.inside[i] = figure->inside[i] != 0 && likeness.values[i] != kUnlike ? 1 : 0;
  const Parts parts = parts_of(candidates, true);
  std::vector<size_t> lit(parts.sizes.size(), 0);
  for (size_t i = 0; i < likeness.values.size(); ++i)
    if (parts.numbers.values[i] >= 0 && likeness.values[i] == kLike)
      ++lit[static_cast<size_t>(parts.numbers.values[i])];
  const auto hole = [&](int32_t part) {
    return part >= 0 && parts.sizes[static_cast<size_t>(part)] * kLeastShare >= pixels &&
           lit[static_cast<size_t>(part)] * kLitShare >= parts.sizes[static_cast<size_t>(part)];
  };
  Mask opened = *figure;
  for (size_t i = 0; i < opened.inside.size(); ++i)
    if (hole(parts.numbers.values[i])) opened.inside[i] = 0;
  // A component without neighbors is drawn inside a hole; the hole is closed then.
  const Parts rest = parts_of(opened, true);
  if (rest.sizes.empty()) return;
  const auto main = static_cast<int32_t>(std::max_element(rest.sizes.begin(), rest.sizes.end()) - rest.sizes.begin());
  std::vector<uint8_t> drawn_in(parts.sizes.size(), 0);
  const uint32_t width = figure->width, height = figure->height;
  for (uint32_t i = 0; i < opened.inside.size(); ++i) {
    const int32_t island = rest.numbers.values[i];
    if (island < 0 || island == main || rest.sizes[static_cast<size_t>(island)] < kLeastIsland) continue;
    const uint32_t x = i % width, y = i / width;
    for (const uint32_t next :
         {x > 0 ? i - 1 : i, x + 1 < width ? i + 1 : i, y > 0 ? i - width : i, y + 1 < height ? i + width : i})
      if (const int32_t part = parts.numbers.values[next]; part >= 0) drawn_in[static_cast<size_t>(part)] = 1;
  }
  for (size_t i = 0; i < opened.inside.size(); ++i) {
    const int32_t part = parts.numbers.values[i];
    if (hole(part) && drawn_in[static_cast<size_t>(part)] == 0) figure->inside[i] = 0;
  }
}

}  // namespace sinew::picture
