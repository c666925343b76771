// SPDX-License-Identifier: MIT
// The border of a figure as closed lines that a user can drag, and back.
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "picture/mesh/plane_mesh.hpp"
#include "picture/outline/figure_parts.hpp"
#include "picture/outline/raster.hpp"
#include "sinew_character/picture/figure.hpp"
#include "sinew_formats/error.hpp"

namespace sinew {
namespace {

constexpr double kOutlineTolerance = 0.6;  // of the mesh's outline as well

void check_lines(const PictureFile& picture, const Outline& outline) {
  for (size_t l = 0; l < outline.size(); ++l) {
    if (outline[l].size() < 3)
      throw Error(picture.name + ": line " + std::to_string(l) +
                  " of the outline: expected three places or more, found " + std::to_string(outline[l].size()));
    for (const auto& point : outline[l])
      if (!std::isfinite(point[0]) || !std::isfinite(point[1]))
        throw Error(picture.name + ": line " + std::to_string(l) + " of the outline: a place is not finite");
  }
}

// Where a level line through pixels' middles crosses the lines, from left to right.
std::vector<double> crossings_of(const Outline& outline, double y, double step) {
  std::vector<double> crossings;
  for (const auto& line : outline)
    for (size_t i = 0; i < line.size(); ++i) {
      const auto &a = line[i], &b = line[(i + 1) % line.size()];
      const double ax = double{a[0]} / step, ay = double{a[1]} / step, bx = double{b[0]} / step,
                   by = double{b[1]} / step;
      if ((ay > y) != (by > y)) crossings.push_back(ax + (bx - ax) * (y - ay) / (by - ay));
    }
  std::sort(crossings.begin(), crossings.end());
  return crossings;
}

}  // namespace

Outline outline_of(const Figure& figure) {
  std::vector<picture::Loop> loops = picture::contours_of(figure.mask);
  std::stable_sort(loops.begin(), loops.end(),
                   [](const picture::Loop& a, const picture::Loop& b) { return a.size() > b.size(); });
  Outline out;
  for (const picture::Loop& loop : loops) {
    std::vector<std::array<float, 2>> line;
    for (const size_t i : picture::simplified(loop, kOutlineTolerance, 1e9))
      line.push_back({static_cast<float>(loop[i][0] * figure.step), static_cast<float>(loop[i][1] * figure.step)});
    if (line.size() >= 3) out.push_back(std::move(line));
  }
  return out;
}

Figure figure_of_outline(const PictureFile& picture, const Outline& outline, const FigureOptions& options) {
  check_lines(picture, outline);
  Figure out;
  out.step = picture::step_of(picture.pixels);
  out.source = FigureSource::kMask;
  Mask inside;
  inside.width = (picture.pixels.width + out.step - 1) / out.step;
  inside.height = (picture.pixels.height + out.step - 1) / out.step;
  inside.inside.assign(size_t{inside.width} * inside.height, 0);
  for (uint32_t y = 0; y < inside.height; ++y) {
    const std::vector<double> crossings = crossings_of(outline, y + 0.5, out.step);
    for (size_t c = 0; c + 1 < crossings.size(); c += 2) {
      const auto first = static_cast<int64_t>(std::ceil(std::max(crossings[c], 0.0) - 0.5)),
                 last = static_cast<int64_t>(std::ceil(std::min(crossings[c + 1], double(inside.width)) - 0.5));
      for (int64_t x = first; x < last; ++x) inside.inside[size_t{y} * inside.width + static_cast<size_t>(x)] = 1;
    }
  }
  picture::ChosenPart chosen = picture::choose_part(picture.name, inside, options.number);
  out.mask = std::move(chosen.mask);
  out.count = chosen.count;
  out.number = chosen.number;
  if (options.cut) picture::cut_inner_lines(picture::reduce(picture.pixels, out.step).colours, &out);
  return out;
}

}  // namespace sinew
