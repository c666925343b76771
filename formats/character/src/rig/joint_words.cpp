// SPDX-License-Identifier: MIT
// Cuts names of joints into words.
#include "rig/joint_words.hpp"

namespace sinew {
namespace {

bool is_lower(char c) { return c >= 'a' && c <= 'z'; }
bool is_upper(char c) { return c >= 'A' && c <= 'Z'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_beyond_ascii(char c) { return (static_cast<unsigned char>(c) & 0x80u) != 0; }

// U+FF21..3A and U+FF41..5A, in UTF-8 EF BC A1..BA and EF BD 81..9A, to A..Z and a..z.
std::string with_plain_letters(const std::string& name) {
  std::string out;
  for (size_t i = 0; i < name.size(); ++i) {
    const auto byte = [&](size_t at) { return at < name.size() ? static_cast<unsigned char>(name[at]) : 0u; };
    if (byte(i) == 0xEF && byte(i + 1) == 0xBC && byte(i + 2) >= 0xA1 && byte(i + 2) <= 0xBA) {
      out += static_cast<char>('A' + (byte(i + 2) - 0xA1));
      i += 2;
    } else if (byte(i) == 0xEF && byte(i + 1) == 0xBD && byte(i + 2) >= 0x81 && byte(i + 2) <= 0x9A) {
      out += static_cast<char>('a' + (byte(i + 2) - 0x81));
      i += 2;
    } else {
      out += name[i];
    }
  }
  return out;
}

}  // namespace

std::vector<std::string> words_of(const std::string& name) {
  const std::string text = with_plain_letters(name);
  std::vector<std::string> words;
  std::string word;
  const auto end_word = [&] {
    if (!word.empty()) words.push_back(word);
    word.clear();
  };
  for (size_t i = 0; i < text.size(); ++i) {
    const char c = text[i], before = i > 0 ? text[i - 1] : ' ', after = i + 1 < text.size() ? text[i + 1] : ' ';
    if (!is_lower(c) && !is_upper(c) && !is_beyond_ascii(c)) {
      end_word();
      continue;
    }
    const bool starts = is_upper(c) && (is_lower(before) || (is_upper(before) && is_lower(after)));
    if (starts || (is_beyond_ascii(c) != is_beyond_ascii(before) && !word.empty())) end_word();
    word += is_upper(c) ? static_cast<char>(c - 'A' + 'a') : c;
  }
  end_word();
  return words;
}

int number_at_end(const std::string& name) {
  size_t end = name.size();
  // .001 and _021 are appended: a separator and at least two digits behind a character that is none.
  for (size_t digits = 0; digits < end; ++digits) {
    if (is_digit(name[end - 1 - digits])) continue;
    const char separator = name[end - 1 - digits];
    if (digits >= 2 && (separator == '.' || separator == '_')) end -= digits + 1;
    break;
  }
  size_t first = end;
  while (first > 0 && is_digit(name[first - 1]) && end - first < 4) --first;
  return first == end ? -1 : std::stoi(name.substr(first, end - first));
}

}  // namespace sinew
