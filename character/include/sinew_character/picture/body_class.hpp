// SPDX-License-Identifier: MIT
// Kinds of bodies by name, and the kind of an outline.
#ifndef SINEW_CHARACTER_BODY_CLASS_HPP
#define SINEW_CHARACTER_BODY_CLASS_HPP

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sinew/sinew.h"
#include "sinew_character/picture/figure.hpp"

namespace sinew {

// To add one: its word in outline_class.cpp.
enum class BodyClass { kBiped, kQuadruped, kBird, kFish, kSnake, kManyLegged, kOther };

struct BodyGuess {
  BodyClass body = BodyClass::kBiped;
  float certainty = 0;  // 0..1
  BodyClass second = BodyClass::kQuadruped;
  float second_certainty = 0;
};

// biped, quadruped, bird, fish, snake, many-legged, other: in the order of the enum.
const std::vector<std::string>& body_class_words();
const std::string& body_class_word(BodyClass body);
std::optional<BodyClass> body_class_of(const std::string& word);

// The engine's sinew_category of a class, and back. Categories are in the order of classes, behind SINEW_CATEGORY_ANY.
inline uint32_t category_of(BodyClass body) { return static_cast<uint32_t>(body) + SINEW_CATEGORY_BIPED; }
inline BodyClass body_of_category(uint32_t category) { return static_cast<BodyClass>(category - SINEW_CATEGORY_BIPED); }

// The kind of body of an outline, by a small network.

constexpr int kOutlineCells = 24, kOutlineClasses = 6;

// How much of each cell of the square about the figure it covers, 0..255, rows from the top.
using OutlineCells = std::array<std::array<int32_t, kOutlineCells>, kOutlineCells>;
OutlineCells outline_cells(const Mask& mask);

// Three layers of kernels and a hidden one over the cells of the figure and of its mirror image, trained by scripts/outline_class.py
// on drawn characters and clip art. Integers up to the choice; certainties are its softmax. Never kOther; an empty mask is a biped
// with certainty 0.
BodyGuess class_of_outline(const Mask& mask);

}  // namespace sinew
#endif
