// SPDX-License-Identifier: MIT
// The words of USD's text form, one after the other, with their lines.
#ifndef SINEW_FORMATS_USD_USD_TOKENS_HPP
#define SINEW_FORMATS_USD_USD_TOKENS_HPP

#include <string>
#include <string_view>

namespace sinew {

enum class UsdWord { kEnd, kName, kNumber, kString, kAsset, kPath, kMark };

class UsdTokens {
 public:
  // `text` must outlive it.
  UsdTokens(std::string path, std::string_view text) : path_(std::move(path)), text_(text) { next(); }

  UsdWord kind() const { return kind_; }
  std::string_view raw() const { return raw_; }            // a name, a mark, a number as it is written
  const std::string& content() const { return content_; }  // of a string, an asset, a path
  double number() const { return number_; }
  bool is_mark(char c) const { return kind_ == UsdWord::kMark && raw_[0] == c; }
  bool is_name(std::string_view name) const { return kind_ == UsdWord::kName && raw_ == name; }
  bool on_new_line() const { return new_line_; }  // there is a line's end before it

  void next();
  // Throws Error with the line: expected, and the word that is there.
  [[noreturn]] void fail(const std::string& expected) const;

 private:
  void skip_blanks();
  void read_string(char quote);
  void read_asset();
  void read_path();
  void read_number();
  [[noreturn]] void fail_open(const std::string& what) const;

  const std::string path_;
  const std::string_view text_;
  size_t at_ = 0, line_ = 1;
  UsdWord kind_ = UsdWord::kEnd;
  std::string_view raw_;
  std::string content_;
  double number_ = 0;
  bool new_line_ = false;
};

}  // namespace sinew
#endif
