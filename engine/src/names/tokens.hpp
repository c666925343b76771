// SPDX-License-Identifier: MIT
// A joint's name, cut into words and numbers: every tool writes LeftHandIK, left_hand_ik or Bip01 L Hand IK in its own way.
#ifndef SINEW_NAMES_TOKENS_HPP
#define SINEW_NAMES_TOKENS_HPP

#include <stdint.h>

namespace sinew::names {

constexpr int kMostNameBytes = 128;  // the last ones of a name are read
constexpr int kMostTokens = 48;      // the first ones of these

constexpr int kMostTextBytes = 1 << 20;  // of a name or word; what lies behind is not read

// ASCII.
inline bool is_digit(char c) { return c >= '0' && c <= '9'; }

// strlen() without the C library.
inline int length_of(const char* text) {
  int length = 0;
  while (length < kMostTextBytes && text[length] != 0) ++length;
  return length;
}

// Bytes before an id that a tool appended to make names unique: Head__k3W. Two underscores, then three letters and digits, no number and no
// word of the table.
int length_without_id(const char* name, int length);

// The first of `c` in `text`, or null.
inline const char* find_letter(const char* text, char c) {
  for (int i = 0; i < kMostTextBytes && text[i] != 0; ++i) {
    if (text[i] == c) return text + i;
  }
  return nullptr;
}

// A word in lower case, or a number. Not terminated.
struct Text {
  const char* at = nullptr;
  int length = 0;

  bool is(const char* word) const;
  bool ends_with(const char* word) const;
  bool begins_with(const char* word) const;
  bool is_number() const { return length > 0 && is_digit(at[0]); }
};

// A new word begins at a capital behind a small letter, at the last of several capitals before a small letter, where letters
// and digits meet, and behind anything else. Full-width letters of Japanese rigs are letters; other characters beyond ASCII
// are words of their own. What stands before the last colon or bar is a maker's prefix.
class Tokens {
 public:
  int count = 0;
  Text token[kMostTokens];
  int16_t begin[kMostTokens];  // bytes of the caller's name
  int16_t end[kMostTokens];

  // From UTF-8; null has no words.
  explicit Tokens(const char* name);
  Tokens(const Tokens&) = delete;
  Tokens& operator=(const Tokens&) = delete;

 private:
  char buffer_[kMostNameBytes + 4];
};

uint32_t hash_of(const Text& text, uint32_t seed = 2166136261u);  // FNV-1a

}  // namespace sinew::names
#endif
