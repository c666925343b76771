// SPDX-License-Identifier: MIT
// What kind of body an outline is of, by a small network of its own.
#ifndef SINEW_CHARACTER_PICTURE_OUTLINE_CLASS_HPP
#define SINEW_CHARACTER_PICTURE_OUTLINE_CLASS_HPP

#include <array>
#include <cstdint>

#include "sinew_character/picture/body_class.hpp"
#include "sinew_character/picture/figure.hpp"

namespace sinew {

constexpr int kOutlineCells = 24, kOutlineFeatures = 245, kOutlineClasses = 6;

// How much of each cell of the square about the figure it covers, 0..255, rows from the top.
using OutlineCells = std::array<std::array<int32_t, kOutlineCells>, kOutlineCells>;
OutlineCells outline_cells(const Mask& mask);

// 0..255: of pairs of rows and of columns how often the figure begins in one, how much it covers, where it begins and ends; width,
// height, area, fullness, likeness of both halves; cells of twice the size.
std::array<int32_t, kOutlineFeatures> outline_features(const OutlineCells& cells);

// One hidden layer over outline_features() of the figure and of its mirror image, trained by scripts/outline_class.py on drawn
// characters and clip art. Integers up to the choice; the certainty is its softmax. Never kOther; an empty mask is a biped
// with certainty 0.
BodyGuess class_of_outline(const Mask& mask);

}  // namespace sinew
#endif
