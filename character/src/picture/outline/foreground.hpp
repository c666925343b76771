// SPDX-License-Identifier: MIT
// Background grown inwards from the border of a picture, or of a sheet in it, by what it looks like; what is left is foreground.
#ifndef SINEW_CHARACTER_PICTURE_OUTLINE_FOREGROUND_HPP
#define SINEW_CHARACTER_PICTURE_OUTLINE_FOREGROUND_HPP

#include <array>
#include <cstdint>
#include <vector>

#include "picture/outline/raster.hpp"

namespace sinew::picture {

// Model of a picture's background, estimated from pixels that probably belong to it: a color that changes smoothly,
// with ruled lines; or, where that does not fit, a few flat colors.
class Background {
 public:
  //   samples  indices of pixels; a share of them, of less than half, may be no background. At least one
  Background(const Grid<Lab>& colors, const std::vector<uint32_t>& samples);

  // Color minus the background's there; by the nearest of several flat ones.
  Lab off(uint32_t x, uint32_t y, const Lab& color) const;
  // Differences (CIE 1976) up to it are background.
  float tolerance() const { return tolerance_; }
  float noise() const { return noise_; }  // of L, a standard deviation
  bool smooth() const { return flats_.empty(); }

 private:
  using Surface = std::array<double, 6>;  // of 1, x, y, xx, xy, yy, with x and y 0..1
  void fit_surface(const Grid<Lab>& colors, const std::vector<uint32_t>& samples);
  void fit_lines(const Grid<Lab>& colors, const std::vector<uint32_t>& samples);
  void fit_flats(const Grid<Lab>& colors, const std::vector<uint32_t>& samples);
  Lab surface_at(uint32_t x, uint32_t y) const;

  uint32_t width_, height_;
  std::array<Surface, 3> surface_{};
  std::vector<Lab> rows_, columns_;  // what ruled lines add
  std::vector<Lab> flats_;
  float tolerance_ = 0, noise_ = 0;
};

float length(const Lab& difference);

// The class of a pixel by its color alone.
enum Likeness : uint8_t { kUnlike = 0, kShadow = 1, kLike = 2 };

struct Foreground {
  Mask mask;  // not reached from the border
  Grid<uint8_t>
      likeness;        // Likeness of `mask`'s pixels: holes and paper inside of outlines look as the background does
  bool drawn = false;  // outlines on paper: the figure is what they enclose
};

// `domain` marks the valid pixels; others are neither.
Foreground find_foreground(const Grid<Lab>& colors, const Mask& domain);

// The same for one part of what was found, beside strokes of other things: an outline drawing is filled. False where it is none, unchanged then.
bool fill_outline(const Foreground& found, const Mask& domain, Mask* part);

}  // namespace sinew::picture
#endif
