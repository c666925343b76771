// SPDX-License-Identifier: MIT
#include "usd/usd_tokens.hpp"

#include <cmath>

#include "text/text_lines.hpp"

namespace sinew {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

// Names may have letters of any language, whose bytes are above 127.
bool begins_name(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || static_cast<unsigned char>(c) >= 128;
}

}  // namespace

void UsdTokens::skip_blanks() {
  new_line_ = at_ == 0;
  while (at_ < text_.size()) {
    const char c = text_[at_];
    if (c == '\n') {
      ++line_;
      new_line_ = true;
    }
    if (c == ' ' || c == '\t' || c == '\n' || c == '\r') {
      ++at_;
    } else if (c == '#' || text_.substr(at_, 2) == "//") {
      while (at_ < text_.size() && text_[at_] != '\n') ++at_;
    } else if (text_.substr(at_, 2) == "/*") {
      const size_t end = text_.find("*/", at_ + 2);
      if (end == std::string_view::npos) fail_open("a comment");
      for (; at_ < end + 2; ++at_) line_ += text_[at_] == '\n' ? 1 : 0;
    } else {
      return;
    }
  }
}

void UsdTokens::next() {
  skip_blanks();
  content_.clear();
  if (at_ >= text_.size()) {
    kind_ = UsdWord::kEnd;
    raw_ = {};
    return;
  }
  const size_t start = at_;
  const char c = text_[at_], after = at_ + 1 < text_.size() ? text_[at_ + 1] : '\0';
  if (c == '"' || c == '\'') {
    read_string(c);
  } else if (c == '@') {
    read_asset();
  } else if (c == '<') {
    read_path();
  } else if (is_digit(c) || ((c == '-' || c == '+' || c == '.') && (is_digit(after) || after == '.')) ||
             text_.substr(at_, 4) == "-inf") {
    read_number();
  } else if (begins_name(c)) {
    kind_ = UsdWord::kName;
    while (at_ < text_.size() && (begins_name(text_[at_]) || is_digit(text_[at_]) || text_[at_] == ':')) ++at_;
  } else {
    kind_ = UsdWord::kMark;
    ++at_;
  }
  raw_ = text_.substr(start, at_ - start);
}

void UsdTokens::read_string(char quote) {
  kind_ = UsdWord::kString;
  const std::string three(3, quote);
  const bool is_long = text_.substr(at_, 3) == three;
  at_ += is_long ? 3 : 1;
  while (at_ < text_.size()) {
    const char c = text_[at_];
    if (is_long ? text_.substr(at_, 3) == three : c == quote) {
      at_ += is_long ? 3 : 1;
      return;
    }
    if (c == '\n' && !is_long) break;
    line_ += c == '\n' ? 1 : 0;
    if (c == '\\' && at_ + 1 < text_.size()) {
      const char escaped = text_[++at_];
      content_ += escaped == 'n' ? '\n' : escaped == 't' ? '\t' : escaped == 'r' ? '\r' : escaped;
      line_ += escaped == '\n' ? 1 : 0;
    } else {
      content_ += c;
    }
    ++at_;
  }
  fail_open("a string");
}

void UsdTokens::read_asset() {
  kind_ = UsdWord::kAsset;
  const std::string_view mark = text_.substr(at_, 3) == "@@@" ? "@@@" : "@";
  const size_t begin = at_ + mark.size(), end = text_.find(mark, begin);
  if (end == std::string_view::npos) fail_open("the path of a file");
  content_ = text_.substr(begin, end - begin);
  if (content_.find('\n') != std::string::npos) fail_open("the path of a file");
  at_ = end + mark.size();
}

void UsdTokens::read_path() {
  kind_ = UsdWord::kPath;
  const size_t end = text_.find_first_of(">\n", at_);
  if (end == std::string_view::npos || text_[end] != '>') fail_open("a path");
  content_ = text_.substr(at_ + 1, end - at_ - 1);
  at_ = end + 1;
}

void UsdTokens::read_number() {
  kind_ = UsdWord::kNumber;
  const size_t start = at_;
  if (text_.substr(at_, 4) == "-inf") {
    at_ += 4;
    number_ = -HUGE_VAL;
    return;
  }
  while (at_ < text_.size() && (is_digit(text_[at_]) || text_[at_] == '.' || text_[at_] == '-' || text_[at_] == '+' ||
                                text_[at_] == 'e' || text_[at_] == 'E'))
    ++at_;
  const std::optional<double> value = to_finite_double(text_.substr(start, at_ - start));
  raw_ = text_.substr(start, at_ - start);
  if (!value) fail("a number");
  number_ = *value;
}

void UsdTokens::fail_open(const std::string& what) const {
  throw Error(path_ + ":" + std::to_string(line_) + ": expected the end of " + what + ", found none");
}

void UsdTokens::fail(const std::string& expected) const {
  throw Error(path_ + ":" + std::to_string(line_) + ": expected " + expected + ", found " +
              (kind_ == UsdWord::kEnd ? "the end of the file" : in_quotes(raw_)));
}

}  // namespace sinew
