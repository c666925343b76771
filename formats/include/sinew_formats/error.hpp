// SPDX-License-Identifier: MIT
// The exception of readers, writers and jobs. Its text is one line: where, what is wrong (expected, found), the
// remedy.
#ifndef SINEW_FORMATS_ERROR_HPP
#define SINEW_FORMATS_ERROR_HPP

#include <stdexcept>
#include <string>

namespace sinew {

class Error : public std::runtime_error {
 public:
  explicit Error(const std::string& line) : std::runtime_error(line) {}
};

// A block of memory could not be allocated; the text has its size.
class OutOfMemory : public Error {
 public:
  using Error::Error;
};

}  // namespace sinew
#endif
