// SPDX-License-Identifier: MIT
// What kind of body a character has, in a word.
#ifndef SINEW_CHARACTER_BODY_CLASS_HPP
#define SINEW_CHARACTER_BODY_CLASS_HPP

#include <optional>
#include <string>
#include <vector>

namespace sinew {

// To add one: its word in body_class.cpp.
enum class BodyClass { kBiped, kQuadruped, kBird, kFish, kSnake, kManyLegged, kOther };

struct BodyGuess {
  BodyClass body = BodyClass::kBiped;
  float certainty = 0;  // 0..1
};

// biped, quadruped, bird, fish, snake, many-legged, other: in the order of the enum.
const std::vector<std::string>& body_class_words();
const std::string& body_class_word(BodyClass body);
std::optional<BodyClass> body_class_of(const std::string& word);

}  // namespace sinew
#endif
