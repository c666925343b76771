// SPDX-License-Identifier: MIT
// What the background of a picture looks like, told from pixels that are likely to be some: a colour that changes smoothly, with ruled lines; or, where
// that does not fit, a few flat colours.
#ifndef SINEW_CHARACTER_PICTURE_OUTLINE_BACKGROUND_HPP
#define SINEW_CHARACTER_PICTURE_OUTLINE_BACKGROUND_HPP

#include <array>
#include <cstdint>
#include <vector>

#include "picture/outline/lab.hpp"

namespace sinew::picture {

class Background {
 public:
  //   samples  indices of pixels; a share of them, of less than half, may be no background. At least one
  Background(const Grid<Lab>& colours, const std::vector<uint32_t>& samples);

  // Colour minus the background's there; by the nearest of several flat ones.
  Lab off(uint32_t x, uint32_t y, const Lab& colour) const;
  // Differences (CIE 1976) up to it are background.
  float tolerance() const { return tolerance_; }
  float noise() const { return noise_; }  // of L, a standard deviation
  bool smooth() const { return flats_.empty(); }

 private:
  using Surface = std::array<double, 6>;  // of 1, x, y, xx, xy, yy, with x and y 0..1
  void fit_surface(const Grid<Lab>& colours, const std::vector<uint32_t>& samples);
  void fit_lines(const Grid<Lab>& colours, const std::vector<uint32_t>& samples);
  void fit_flats(const Grid<Lab>& colours, const std::vector<uint32_t>& samples);
  Lab surface_at(uint32_t x, uint32_t y) const;

  uint32_t width_, height_;
  std::array<Surface, 3> surface_{};
  std::vector<Lab> rows_, columns_;  // what ruled lines add
  std::vector<Lab> flats_;
  float tolerance_ = 0, noise_ = 0;
};

float length(const Lab& difference);

}  // namespace sinew::picture
#endif
