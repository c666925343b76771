// SPDX-License-Identifier: MIT
// What kind of body a character has, in a word.
#ifndef SINEW_CHARACTER_BODY_CLASS_HPP
#define SINEW_CHARACTER_BODY_CLASS_HPP

#include <optional>
#include <string>
#include <vector>

#include "sinew/sinew.h"

namespace sinew {

// To add one: its word in outline_class.cpp.
enum class BodyClass { kBiped, kQuadruped, kBird, kFish, kSnake, kManyLegged, kOther };

struct BodyGuess {
  BodyClass body = BodyClass::kBiped;
  float certainty = 0;  // 0..1
};

// biped, quadruped, bird, fish, snake, many-legged, other: in the order of the enum.
const std::vector<std::string>& body_class_words();
const std::string& body_class_word(BodyClass body);
std::optional<BodyClass> body_class_of(const std::string& word);

// The engine's sinew_category of a class, and back. Categories are in the order of classes, behind SINEW_CATEGORY_ANY.
inline uint32_t category_of(BodyClass body) { return static_cast<uint32_t>(body) + SINEW_CATEGORY_BIPED; }
inline BodyClass body_of_category(uint32_t category) { return static_cast<BodyClass>(category - SINEW_CATEGORY_BIPED); }

}  // namespace sinew
#endif
