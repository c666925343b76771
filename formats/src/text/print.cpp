// SPDX-License-Identifier: MIT
// printf into a string: once for its length, once for its text.
#include "sinew_formats/print.hpp"

#include <cstdarg>
#include <cstdio>

#include "sinew_formats/error.hpp"

namespace sinew {

std::string print(const char* format, ...) {
  va_list arguments, again;
  va_start(arguments, format);
  va_copy(again, arguments);
  const int length = std::vsnprintf(nullptr, 0, format, arguments);
  va_end(arguments);
  std::string text(length > 0 ? static_cast<size_t>(length) : 0, '\0');
  if (length > 0) std::vsnprintf(text.data(), text.size() + 1, format, again);
  va_end(again);
  if (length < 0) throw Error(std::string("cannot print \"") + format + "\"");
  return text;
}

}  // namespace sinew
