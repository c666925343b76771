// SPDX-License-Identifier: MIT
#include "picture/outline/choose_part.hpp"

#include <algorithm>

#include "sinew_formats/error.hpp"

namespace sinew::picture {
namespace {

struct Part {
  size_t number = 0, pixels = 0;
  uint32_t left = UINT32_MAX, right = 0, top = UINT32_MAX, bottom = 0;
  uint32_t side() const { return std::max(right - left, bottom - top) + 1; }
};

// Of the least share of the largest one's pixels that makes a figure of its own.
constexpr size_t kFigureShare = 5;
constexpr size_t kMostFigures = 12;

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
    throw Error(name + ": no figure found: nothing stands out from the border of the picture" + cure);
  const size_t all = size_t{mask.width} * mask.height;
  if (largest->pixels * 400 < all && static_cast<float>(largest->side()) < 0.15f * largest_side)
    throw Error(name + ": no figure found: the largest thing is " + std::to_string(largest->side()) + " pixels long" +
                cure);
  if (largest->pixels < 64) throw Error(name + ": no figure found: too few pixels" + cure);
  if (largest->pixels * 50 > all * 49)
    throw Error(name + ": no figure found: all of the picture is one, without a background" + cure);
  std::vector<Part> figures;
  for (const Part& part : parts)
    if (part.pixels * kFigureShare >= largest->pixels) figures.push_back(part);
  if (figures.size() > kMostFigures)
    throw Error(name + ": no figure found: " + std::to_string(figures.size()) +
                " things of about one size, as letters of a text are" + cure);
  std::sort(figures.begin(), figures.end(),
            [](const Part& a, const Part& b) { return a.left + a.right < b.left + b.right; });
  if (number > figures.size())
    throw Error(name + ": there is no figure " + std::to_string(number) + ", found " + std::to_string(figures.size()) +
                " from left to right");
  ChosenPart out = {mask, static_cast<uint32_t>(figures.size()), number};
  size_t wanted = number > 0 ? figures[number - 1].number : largest->number;
  for (size_t f = 0; f < figures.size(); ++f)
    if (figures[f].number == wanted) out.number = static_cast<uint32_t>(f + 1);
  for (size_t i = 0; i < mask.inside.size(); ++i)
    out.mask.inside[i] = mask.inside[i] != 0 && labels.numbers.values[i] == static_cast<int32_t>(wanted) ? 1 : 0;
  return out;
}

}  // namespace sinew::picture
