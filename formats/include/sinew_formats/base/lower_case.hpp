// SPDX-License-Identifier: MIT
// Text in lower case, whatever the locale.
#ifndef SINEW_FORMATS_BASE_LOWER_CASE_HPP
#define SINEW_FORMATS_BASE_LOWER_CASE_HPP

#include <string>
#include <string_view>

namespace sinew {

// A to Z become a to z; all other bytes stay.
inline std::string lower_case(std::string_view text) {
  std::string out(text);
  for (char& c : out)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return out;
}

}  // namespace sinew
#endif
