// SPDX-License-Identifier: MIT
// Lines and words of a text file with their numbers, and the one form of error message that the text readers (obj, rig)
// use.
#ifndef SINEW_FORMATS_TEXT_TEXT_LINES_HPP
#define SINEW_FORMATS_TEXT_TEXT_LINES_HPP

#include <charconv>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sinew_formats/error.hpp"
#include "text/decimal.hpp"

namespace sinew {

// A piece of a file made fit for one line of a message: cut to 40 bytes, bytes that do not print as \xNN.
inline std::string in_quotes(std::string_view found) {
  constexpr size_t kLongest = 40;
  std::string out = "'";
  for (size_t i = 0; i < found.size() && i < kLongest; ++i) {
    const unsigned char c = static_cast<unsigned char>(found[i]);
    if (c >= 32 && c != 127 && c < 0x80) {
      out += static_cast<char>(c);
    } else {
      static const char kHex[] = "0123456789abcdef";
      out += std::string("\\x") + kHex[c >> 4] + kHex[c & 15];
    }
  }
  return out + (found.size() > kLongest ? "...'" : "'");
}

// A parser's words as part of one line: without its marks for programs, without the bytes that it stumbled over, and
// not with half of the file behind them.
inline std::string one_line(std::string text) {
  constexpr size_t kLongest = 300;
  for (size_t mark; (mark = text.find("[json.exception")) != std::string::npos;) {
    const size_t end = text.find("] ", mark);
    text.erase(mark, end == std::string::npos ? end : end + 2 - mark);
  }
  while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) text.pop_back();
  const bool cut = text.size() > kLongest;
  if (cut) text.resize(kLongest);
  for (char& c : text) c = c == '\n' ? ';' : c < ' ' || c > '~' ? '?' : c;
  return cut ? text + "..." : text;
}

// A number may begin with '+'; not with '+-', which loaders read differently.
inline std::string_view without_plus(std::string_view word) {
  return word.size() > 1 && word[0] == '+' && word[1] != '-' ? word.substr(1) : word;
}

// Decimal number that is finite as a float; nullopt otherwise ("nan", "inf", "1e99", "0x10", "1,5", "").
inline std::optional<float> to_finite_float(std::string_view word) { return decimal_to_float(without_plus(word)); }

inline std::optional<double> to_finite_double(std::string_view word) { return decimal_to_double(without_plus(word)); }

inline std::optional<int64_t> to_integer(std::string_view word) {
  word = without_plus(word);
  int64_t value = 0;
  const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || stop != word.data() + word.size()) return std::nullopt;
  return value;
}

// Walks over the lines of `text` (LF, CRLF or CR), each split into words at blanks. `text` must outlive it.
class TextLines {
 public:
  TextLines(std::string path, std::string_view text) : path_(std::move(path)), text_(text) {}

  bool next() {
    if (at_ >= text_.size()) return false;
    ++number_;
    size_t end = at_;
    while (end < text_.size() && text_[end] != '\n' && text_[end] != '\r') ++end;
    line_ = text_.substr(at_, end - at_);
    at_ = end + (end + 1 < text_.size() && text_[end] == '\r' && text_[end + 1] == '\n' ? 2 : 1);
    words_.clear();
    for (size_t i = 0; i < line_.size();) {
      while (i < line_.size() && is_blank(line_[i])) ++i;
      const size_t start = i;
      while (i < line_.size() && !is_blank(line_[i])) ++i;
      if (i > start) words_.push_back(line_.substr(start, i - start));
    }
    return true;
  }

  size_t number() const { return number_; }  // of the current line, from 1
  std::string_view line() const { return line_; }
  const std::vector<std::string_view>& words() const { return words_; }

  [[noreturn]] void fail(const std::string& expected, std::string_view found) const {
    fail_at(number_, expected, found);
  }
  [[noreturn]] void fail_at(size_t number, const std::string& expected, std::string_view found) const {
    throw Error(path_ + ":" + std::to_string(number) + ": expected " + expected + ", found " + in_quotes(found));
  }

 private:
  static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }

  std::string path_;
  std::string_view text_, line_;
  std::vector<std::string_view> words_;
  size_t at_ = 0, number_ = 0;
};

}  // namespace sinew
#endif
