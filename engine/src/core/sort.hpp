// SPDX-License-Identifier: MIT
// Sorting without recursion or allocation, O(n log n) in the worst case: heapsort in place, and a radix sort with
// scratch for long arrays of 64-bit keys.
#ifndef SINEW_CORE_SORT_HPP
#define SINEW_CORE_SORT_HPP

#include <stddef.h>
#include <stdint.h>

#include "core/build.hpp"

namespace sinew {

// Sorts data[0, count) so that less(data[i + 1], data[i]) is never true. Equal elements keep no order: make keys
// unique.
template <class T, class Less>
void heap_sort(T* data, size_t count, Less less) {
  if (count < 2) return;
  auto sift = [&](size_t root, size_t end) {
    T value = data[root];
    for (size_t child = 2 * root + 1; child < end; child = 2 * root + 1) {
      if (child + 1 < end && less(data[child], data[child + 1])) ++child;
      if (!less(value, data[child])) break;
      data[root] = data[child];
      root = child;
    }
    data[root] = value;
  };
  for (size_t i = count / 2; i-- > 0;) sift(i, count);
  for (size_t end = count - 1; end > 0; --end) {
    T last = data[end];
    data[end] = data[0];
    data[0] = last;
    sift(0, end);
  }
}

// Sorts numbers ascending. Insertion up to where a heap is faster: most rows are short (a vertex's neighbors, a
// border).
template <class T>
void sort_ascending(T* values, size_t count) {
  if (kSmallCode || count > 128) {
    heap_sort(values, count, [](T a, T b) { return a < b; });
    return;
  }
  for (size_t i = 1; i < count; ++i) {
    const T value = values[i];
    size_t at = i;
    for (; at > 0 && values[at - 1] > value; --at) values[at] = values[at - 1];
    values[at] = value;
  }
}

// Sorts (key, payload) pairs by key, stable: 8-bit digits from the low end, digits that all keys share are skipped.
//   keys, payloads                  [count] in and out
//   scratch_keys, scratch_payloads  [count] overwritten
inline void radix_sort_pairs(uint64_t* keys, uint32_t* payloads, size_t count, uint64_t* scratch_keys,
                             uint32_t* scratch_payloads) {
  uint64_t* from_keys = keys;
  uint32_t* from = payloads;
  uint64_t* to_keys = scratch_keys;
  uint32_t* to = scratch_payloads;
  for (int shift = 0; shift < 64; shift += 8) {
    size_t offsets[257] = {};
    for (size_t i = 0; i < count; ++i) ++offsets[((from_keys[i] >> shift) & 255u) + 1];
    bool shared = false;
    for (int digit = 0; digit < 256; ++digit) {
      if (offsets[digit + 1] == count) shared = true;
    }
    if (shared) continue;
    for (int digit = 0; digit < 256; ++digit) offsets[digit + 1] += offsets[digit];
    for (size_t i = 0; i < count; ++i) {
      const size_t at = offsets[(from_keys[i] >> shift) & 255u]++;
      to_keys[at] = from_keys[i];
      to[at] = from[i];
    }
    uint64_t* const swap_keys = from_keys;
    from_keys = to_keys;
    to_keys = swap_keys;
    uint32_t* const swap = from;
    from = to;
    to = swap;
  }
  if (from_keys == keys) return;
  for (size_t i = 0; i < count; ++i) {
    keys[i] = from_keys[i];
    payloads[i] = from[i];
  }
}

}  // namespace sinew
#endif
