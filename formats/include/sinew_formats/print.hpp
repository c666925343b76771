// SPDX-License-Identifier: MIT
// printf into a string.
#ifndef SINEW_FORMATS_PRINT_HPP
#define SINEW_FORMATS_PRINT_HPP

#include <string>

namespace sinew {

// The text that printf would write, of any length.
std::string print(const char* format, ...)
#if defined(__GNUC__)
    __attribute__((format(printf, 1, 2)))
#endif
    ;

}  // namespace sinew
#endif
