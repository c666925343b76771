// SPDX-License-Identifier: MIT
// Disjoint sets of numbers: the smallest of a set is its root.
#ifndef SINEW_CORE_UNION_FIND_HPP
#define SINEW_CORE_UNION_FIND_HPP

#include <stdint.h>

namespace sinew {

// parents: of each number one of its set that is not larger, itself for a root. Halves the path on each search.
inline uint32_t find_root(uint32_t* parents, uint32_t i) {
  while (parents[i] != i) {
    parents[i] = parents[parents[i]];
    i = parents[i];
  }
  return i;
}

inline void join_sets(uint32_t* parents, uint32_t a, uint32_t b) {
  a = find_root(parents, a);
  b = find_root(parents, b);
  if (a < b) parents[b] = a;
  if (b < a) parents[a] = b;
}

}  // namespace sinew
#endif
