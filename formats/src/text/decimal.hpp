// SPDX-License-Identifier: MIT
// Decimal text to float and back, in every locale alike: the standard's functions, or the C library's where the
// compiler's library has none for floats yet (libc++ before 20, so emscripten and Apple's).
#ifndef SINEW_FORMATS_TEXT_DECIMAL_HPP
#define SINEW_FORMATS_TEXT_DECIMAL_HPP

#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>

#include "sinew_formats/print.hpp"

namespace sinew {

// Without the standard's functions. They need the C locale, which a program has that does not ask for another.
namespace plain {

inline bool is_decimal(std::string_view word) {
  size_t at = !word.empty() && word[0] == '-' ? 1 : 0, digits = 0;
  const auto skip_digits = [&] {
    for (; at < word.size() && word[at] >= '0' && word[at] <= '9'; ++at) ++digits;
  };
  skip_digits();
  if (at < word.size() && word[at] == '.') {
    ++at;
    skip_digits();
  }
  if (digits == 0) return false;
  if (at < word.size() && (word[at] == 'e' || word[at] == 'E')) {
    ++at;
    if (at < word.size() && (word[at] == '-' || word[at] == '+')) ++at;
    digits = 0;
    skip_digits();
    if (digits == 0) return false;
  }
  return at == word.size();
}

inline std::optional<float> to_float(std::string_view word) {
  if (!is_decimal(word)) return std::nullopt;
  const float value = std::strtof(std::string(word).c_str(), nullptr);
  if (!std::isfinite(value)) return std::nullopt;
  return value;
}

inline std::optional<double> to_double(std::string_view word) {
  if (!is_decimal(word)) return std::nullopt;
  return std::strtod(std::string(word).c_str(), nullptr);
}

inline std::string shortest(float value) {
  char text[32];
  for (int digits = 1;; ++digits) {
    std::snprintf(text, sizeof text, "%.*g", digits, static_cast<double>(value));
    if (digits == 9 || std::strtof(text, nullptr) == value) return text;
  }
}

inline std::string fixed(double value, int digits) { return print("%.*f", digits, value); }

}  // namespace plain

// Decimal number ("-1.5e-3") that is finite as a float; nullopt otherwise ("nan", "inf", "1e99", "0x10", "1,5", "+1",
// ""). One that is too small for a float is 0.
inline std::optional<float> decimal_to_float(std::string_view word) {
#if defined(__cpp_lib_to_chars)
  float value = 0;
  const auto end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, value);
  if (error == std::errc::result_out_of_range && stop == end) {
    // Also reported for numbers too small for a float; "1e99" is not.
    const size_t exponent = word.find_first_of("eE");
    if (exponent == std::string_view::npos || exponent + 1 >= word.size() || word[exponent + 1] != '-')
      return std::nullopt;
    return 0.0f;
  }
  if (error != std::errc() || stop != end || !std::isfinite(value)) return std::nullopt;
  return value;
#else
  return plain::to_float(word);
#endif
}

// The same with the precision of a double; what no float can hold is refused as well.
inline std::optional<double> decimal_to_double(std::string_view word) {
  if (!decimal_to_float(word)) return std::nullopt;
#if defined(__cpp_lib_to_chars)
  double value = 0;
  const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  return error == std::errc() ? value : 0.0;  // too small for a double
#else
  return plain::to_double(word);
#endif
}

// The shortest text that reads back as the same float.
inline std::string shortest_decimal(float value) {
#if defined(__cpp_lib_to_chars)
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
#else
  return plain::shortest(value);
#endif
}

// As printf's %.*f.
inline std::string fixed_decimal(double value, int digits) {
#if defined(__cpp_lib_to_chars)
  char text[400];
  return {text, std::to_chars(text, text + sizeof text, value, std::chars_format::fixed, digits).ptr};
#else
  return plain::fixed(value, digits);
#endif
}

}  // namespace sinew
#endif
