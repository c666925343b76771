// SPDX-License-Identifier: MIT
#include "picture/outline/holes.hpp"

#include <algorithm>

namespace sinew::picture {

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
  // What hangs together with nothing else is drawn inside of a hole, which is none then.
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
