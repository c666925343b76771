// SPDX-License-Identifier: MIT
// Values as USD's text form has them.
#ifndef SINEW_FORMATS_USD_USD_TEXT_HPP
#define SINEW_FORMATS_USD_USD_TEXT_HPP

#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "sinew_formats/base/affine.hpp"
#include "sinew_formats/print.hpp"
#include "text/decimal.hpp"

namespace sinew {

// The shortest text of a float; 0 for what is not finite.
inline std::string usd_number(double value) {
  const float number = static_cast<float>(value);
  return std::isfinite(number) ? shortest_decimal(number == 0 ? 0.0f : number) : "0";
}

inline std::string usd_number(int value) { return std::to_string(value); }

// (a, b, c) of `width` numbers from `at` on.
inline std::string usd_tuple(const std::vector<double>& numbers, size_t at, size_t width) {
  std::string out = "(";
  for (size_t i = 0; i < width; ++i) out += (i > 0 ? ", " : "") + usd_number(numbers[at + i]);
  return out + ")";
}

inline std::string usd_tuple(const std::vector<double>& numbers) { return usd_tuple(numbers, 0, numbers.size()); }

// [(a, b), (c, d)] of numbers in a row.
inline std::string usd_tuples(const std::vector<double>& numbers, size_t width) {
  std::string out = "[";
  for (size_t i = 0; i + width <= numbers.size(); i += width) out += (i > 0 ? ", " : "") + usd_tuple(numbers, i, width);
  return out + "]";
}

template <class Value>
std::string usd_list(const std::vector<Value>& values) {
  std::string out = "[";
  for (const Value value : values) out += (out.size() > 1 ? ", " : "") + usd_number(value);
  return out + "]";
}

// Rows are those of matrices for row vectors: translations are in the last one.
inline std::string usd_matrix(const Affine& m) {
  std::string out = "( ";
  for (size_t c = 0; c < 4; ++c)
    out += print("%s(%.15g, %.15g, %.15g, %d)", c > 0 ? ", " : "", m[c] + 0.0, m[4 + c] + 0.0, m[8 + c] + 0.0,
                 c == 3 ? 1 : 0);
  return out + " )";
}

inline std::string usd_matrices(const std::vector<Affine>& all) {
  std::string out = "[";
  for (const Affine& m : all) out += (out.size() > 1 ? ", " : "") + usd_matrix(m);
  return out + "]";
}

inline std::string usd_string(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    out += static_cast<unsigned char>(c) < 32 ? ' ' : c;
  }
  return out + "\"";
}

inline std::string usd_tokens(const std::vector<std::string>& texts) {
  std::string out = "[";
  for (const std::string& text : texts) out += (out.size() > 1 ? ", " : "") + usd_string(text);
  return out + "]";
}

// Letters, digits and _, no digit first.
inline std::string usd_identifier(const std::string& name) {
  std::string out;
  for (const char c : name) {
    const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_', digit = c >= '0' && c <= '9';
    if (digit && out.empty()) out += '_';
    out += letter || digit ? c : '_';
  }
  return out.empty() ? "_" : out;
}

// One that is not yet among `taken`, which gets it.
inline std::string usd_free_name(const std::string& name, std::set<std::string>* taken) {
  const std::string base = usd_identifier(name);
  std::string out = base;
  for (size_t number = 2; !taken->insert(out).second; ++number) out = base + "_" + std::to_string(number);
  return out;
}

// Metadata of a prim that keeps the name of what it was made of; "" where the prim is called so.
inline std::string usd_name_line(const std::string& indent, const std::string& prim, const std::string& name) {
  if (prim == name || name.empty()) return "";
  return indent + "customData = {\n" + indent + "    string name = " + usd_string(name) + "\n" + indent + "}\n";
}

}  // namespace sinew
#endif
