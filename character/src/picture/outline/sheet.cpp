// SPDX-License-Identifier: MIT
#include "picture/outline/sheet.hpp"

#include <algorithm>
#include <array>

namespace sinew::picture {

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

}  // namespace sinew::picture
