// SPDX-License-Identifier: MIT
// From pixels to a figure, by alpha, a user's mask or lines, or the background; its border as lines that a user can drag.
#include "sinew_character/picture/figure.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "picture/mesh/plane_mesh.hpp"
#include "picture/outline/figure_parts.hpp"
#include "picture/outline/foreground.hpp"
#include "picture/outline/raster.hpp"
#include "sinew_formats/error.hpp"

namespace sinew {
namespace picture {
namespace {

constexpr uint8_t kOpaque = 128;

Mask empty_mask(uint32_t width, uint32_t height, uint8_t value = 0) {
  return {width, height, std::vector<uint8_t>(size_t{width} * height, value)};
}

// A picture whose background is cut away; a few see-through pixels are none.
bool is_cut_out(const Grid<uint8_t>& alpha) {
  const auto clear = std::count_if(alpha.values.begin(), alpha.values.end(), [](uint8_t a) { return a < kOpaque; });
  return static_cast<size_t>(clear) * 200 >= alpha.values.size();
}

Figure figure_from(const std::string& name, const Mask& mask, const FigureOptions& options, uint32_t step,
                   FigureSource source) {
  ChosenPart chosen = choose_part(name, mask, options.number);
  Figure out;
  out.mask = std::move(chosen.mask);
  out.step = step;
  out.count = chosen.count;
  out.number = chosen.number;
  out.source = source;
  if (out.count > 1 && options.number == 0)
    out.notes.push_back("there are " + std::to_string(out.count) + " figures in the picture; the largest, number " +
                        std::to_string(out.number) + " from the left, was taken (choose another with --figure N)");
  return out;
}

Figure figure_on(const std::string& name, const Grid<Lab>& colors, const Mask& domain, const FigureOptions& options,
                 uint32_t step) {
  const Foreground found = find_foreground(colors, domain);
  Figure out = figure_from(name, found.mask, options, step, FigureSource::kBackground);
  if (!found.drawn && !fill_outline(found, domain, &out.mask)) open_holes(found.likeness, &out.mask);
  return out;
}

Figure figure_in(const std::string& name, const Reduced& reduced, const FigureOptions& options, uint32_t step) {
  const uint32_t width = reduced.alpha.width, height = reduced.alpha.height;
  if (is_cut_out(reduced.alpha)) {
    Mask mask = empty_mask(width, height);
    for (size_t i = 0; i < mask.inside.size(); ++i) mask.inside[i] = reduced.alpha.values[i] >= kOpaque ? 1 : 0;
    return figure_from(name, mask, options, step, FigureSource::kAlpha);
  }
  Figure out = figure_on(name, reduced.colors, empty_mask(width, height, 1), options, step);
  if (const std::optional<Mask> sheet = sheet_of(out.mask)) {
    try {
      Figure on_sheet = figure_on(name, reduced.colors, *sheet, options, step);
      on_sheet.notes.push_back("the picture shows a sheet of paper, so the figure on it was taken, a guess");
      return on_sheet;
    } catch (const OutOfMemory&) {
      throw;
    } catch (const Error&) {  // an empty sheet is a figure
    }
  }
  return out;
}

}  // namespace
}  // namespace picture

Figure find_figure(const PictureFile& picture, const FigureOptions& options) {
  const uint32_t step = picture::step_of(picture.pixels);
  const picture::Reduced reduced = picture::reduce(picture.pixels, step);
  Figure out = picture::figure_in(picture.name, reduced, options, step);
  if (options.cut) picture::cut_inner_lines(reduced.colors, &out);
  return out;
}

Figure figure_of_mask(const PictureFile& picture, const PictureFile& mask, const FigureOptions& options) {
  using namespace picture;
  const uint32_t step = step_of(picture.pixels);
  const uint32_t width = (picture.pixels.width + step - 1) / step, height = (picture.pixels.height + step - 1) / step;
  const double shape = double{1} * picture.pixels.width / picture.pixels.height,
               mask_shape = double{1} * mask.pixels.width / mask.pixels.height;
  if (shape > 1.02 * mask_shape || mask_shape > 1.02 * shape)
    throw Error(mask.name + ": expected a mask with the size of its picture, " + std::to_string(picture.pixels.width) +
                " x " + std::to_string(picture.pixels.height) + ", found " + std::to_string(mask.pixels.width) + " x " +
                std::to_string(mask.pixels.height));
  Mask inside = empty_mask(width, height);
  for (uint32_t y = 0; y < height; ++y)
    for (uint32_t x = 0; x < width; ++x) {
      const size_t mx = (size_t{2} * x + 1) * mask.pixels.width / (size_t{2} * width),
                   my = (size_t{2} * y + 1) * mask.pixels.height / (size_t{2} * height);
      const uint8_t* p = &mask.pixels.rgba[(my * mask.pixels.width + mx) * 4];
      inside.inside[size_t{y} * width + x] = p[0] + p[1] + p[2] > 3 * 127 && p[3] >= kOpaque ? 1 : 0;
    }
  Figure out = figure_from(mask.name, inside, options, step, FigureSource::kMask);
  if (options.cut) cut_inner_lines(reduce(picture.pixels, step).colors, &out);
  return out;
}

Mask full_mask(const PictureFile& picture, const Figure& figure) {
  Mask out = picture::empty_mask(picture.pixels.width, picture.pixels.height);
  for (uint32_t y = 0; y < out.height; ++y)
    for (uint32_t x = 0; x < out.width; ++x)
      out.inside[size_t{y} * out.width + x] = figure.mask.at(x / figure.step, y / figure.step) ? 1 : 0;
  return out;
}

namespace {

constexpr double kOutlineTolerance = 0.6;  // of the mesh's outline as well

void check_lines(const PictureFile& picture, const Outline& outline) {
  for (size_t l = 0; l < outline.size(); ++l) {
    if (outline[l].size() < 3)
      throw Error(picture.name + ": line " + std::to_string(l) +
                  " of the outline: expected at least three positions, found " + std::to_string(outline[l].size()));
    for (const auto& point : outline[l])
      if (!std::isfinite(point[0]) || !std::isfinite(point[1]))
        throw Error(picture.name + ": line " + std::to_string(l) + " of the outline: a position is not finite");
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
  if (options.cut) picture::cut_inner_lines(picture::reduce(picture.pixels, out.step).colors, &out);
  return out;
}

}  // namespace sinew
