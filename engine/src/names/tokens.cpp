// SPDX-License-Identifier: MIT
// Cuts joint names into tokens; no other file does.
#include "names/tokens.hpp"

#include <stddef.h>
#include <string.h>

#include "names/words.hpp"

namespace sinew::names {
namespace {

bool is_upper(char c) { return c >= 'A' && c <= 'Z'; }
bool is_lower(char c) { return c >= 'a' && c <= 'z'; }
bool is_letter(char c) { return is_upper(c) || is_lower(c); }
bool is_beyond_ascii(char c) { return (static_cast<unsigned char>(c) & 0x80u) != 0; }
bool is_kept(char c) { return is_letter(c) || is_digit(c) || is_beyond_ascii(c); }

// Whether a word ends between a and b; c stands behind b.
bool ends_word(char a, char b, char c) {
  return (is_lower(a) && is_upper(b)) || (is_upper(a) && is_upper(b) && is_lower(c)) || is_digit(a) != is_digit(b) ||
         is_beyond_ascii(a) != is_beyond_ascii(b);
}

// U+FF21..3A and U+FF41..5A, in UTF-8 EF BC A1..BA and EF BD 81..9A: A..Z and a..z, else 0.
char plain_letter(const char* s, int left) {
  if (left < 3 || static_cast<uint8_t>(s[0]) != 0xEF) return 0;
  const uint8_t second = static_cast<uint8_t>(s[1]), third = static_cast<uint8_t>(s[2]);
  if (second == 0xBC && third >= 0xA1 && third <= 0xBA) return static_cast<char>('A' + (third - 0xA1));
  if (second == 0xBD && third >= 0x81 && third <= 0x9A) return static_cast<char>('a' + (third - 0x81));
  return 0;
}

}  // namespace

bool Text::is(const char* word) const {
  for (int i = 0; i < length; ++i) {
    if (word[i] != at[i]) return false;  // a shorter word ends with 0, which is in no text
  }
  return word[length] == 0;
}

bool Text::ends_with(const char* word) const {
  const int size = length_of(word);
  return size <= length && memcmp(at + length - size, word, static_cast<size_t>(size)) == 0;
}

bool Text::begins_with(const char* word) const {
  const int size = length_of(word);
  return size <= length && memcmp(at, word, static_cast<size_t>(size)) == 0;
}

Tokens::Tokens(const char* name) {
  if (name == nullptr) return;
  const char* start = name;
  int length = 0;
  for (const char* c = name; *c != 0; ++c) {
    if (length < INT16_MAX / 2) ++length;
    if ((*c != ':' && *c != '|') || !is_kept(c[1])) continue;
    start = c + 1;
    length = 0;
  }
  const int all = length_of(start);
  if (all > kMostNameBytes) start += all - kMostNameBytes;
  length = all < kMostNameBytes ? all : kMostNameBytes;
  const ptrdiff_t first = start - name;
  int16_t from[kMostNameBytes + 1];
  int kept = 0, source = 0;
  while (source < length) {
    from[kept] = static_cast<int16_t>(source);
    const char plain = plain_letter(start + source, length - source);
    buffer_[kept++] = plain != 0 ? plain : start[source];
    source += plain != 0 ? 3 : 1;
  }
  from[kept] = static_cast<int16_t>(length);
  kept = length_without_id(buffer_, kept);
  memset(buffer_ + kept, 0, 3);
  for (int i = 0; i < kept && count < kMostTokens;) {
    if (!is_kept(buffer_[i])) {
      ++i;
      continue;
    }
    int last = i;
    while (last + 1 < kept && is_kept(buffer_[last + 1]) &&
           !ends_word(buffer_[last], buffer_[last + 1], buffer_[last + 2]))
      ++last;
    token[count] = {buffer_ + i, last + 1 - i};
    // A name beyond 32 kB has no bytes that a caller could exchange.
    const bool near = first < INT16_MAX - kMostNameBytes;
    begin[count] = near ? static_cast<int16_t>(first + from[i]) : int16_t{0};
    end[count] = near ? static_cast<int16_t>(first + from[last + 1]) : int16_t{0};
    ++count;
    i = last + 1;
  }
  for (int i = 0; i < kept; ++i) {
    if (is_upper(buffer_[i])) buffer_[i] = static_cast<char>(buffer_[i] - 'A' + 'a');
  }
}

int length_without_id(const char* name, int length) {
  constexpr int kId = 3, kGap = 2;
  const int behind = length - kId;
  if (behind <= kGap || name[behind - 1] != '_' || name[behind - kGap] != '_') return length;
  char id[kId];
  int digits = 0;
  for (int i = 0; i < kId; ++i) {
    const char c = name[behind + i];
    if (!is_letter(c) && !is_digit(c)) return length;
    digits += is_digit(c) ? 1 : 0;
    id[i] = is_upper(c) ? static_cast<char>(c - 'A' + 'a') : c;
  }
  return digits == kId || find_word({id, kId}) != nullptr ? length : behind - kGap;
}

uint32_t hash_of(const Text& text, uint32_t seed) {
  uint32_t hash = seed;
  for (int i = 0; i < text.length; ++i) hash = (hash ^ static_cast<uint8_t>(text.at[i])) * 16777619u;
  return hash;
}

}  // namespace sinew::names
