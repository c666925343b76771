// SPDX-License-Identifier: MIT
// Equal strings; the engine calls memory routines alone.
#ifndef SINEW_CORE_SAME_TEXT_HPP
#define SINEW_CORE_SAME_TEXT_HPP

namespace sinew {

inline bool same_text(const char* a, const char* b) {
  while (*a != 0 && *a == *b) {
    ++a;
    ++b;
  }
  return *a == *b;
}

}  // namespace sinew
#endif
