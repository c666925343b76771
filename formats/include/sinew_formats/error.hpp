// SPDX-License-Identifier: MIT
// The exception of the tools: a job cannot go on. Its text is one line: what, where, what was expected, what to do.
#ifndef SINEW_FORMATS_ERROR_HPP
#define SINEW_FORMATS_ERROR_HPP

#include <stdexcept>
#include <string>

namespace sinew {

class Error : public std::runtime_error {
 public:
  explicit Error(const std::string& line) : std::runtime_error(line) {}
};

// There is no memory for what the job needs in one piece; the text says how much that is.
class OutOfMemory : public Error {
 public:
  using Error::Error;
};

}  // namespace sinew
#endif
