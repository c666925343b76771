// SPDX-License-Identifier: MIT
#include "sinew_character/picture/body_class.hpp"

#include <algorithm>

namespace sinew {

const std::vector<std::string>& body_class_words() {
  static const std::vector<std::string> words = {"biped", "quadruped", "bird", "fish", "snake", "many-legged", "other"};
  return words;
}

const std::string& body_class_word(BodyClass body) { return body_class_words()[static_cast<size_t>(body)]; }

std::optional<BodyClass> body_class_of(const std::string& word) {
  const auto& words = body_class_words();
  const auto found = std::find(words.begin(), words.end(), word);
  if (found == words.end()) return std::nullopt;
  return static_cast<BodyClass>(found - words.begin());
}

}  // namespace sinew
