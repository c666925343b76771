// SPDX-License-Identifier: MIT
// In-place heapsort: deterministic, no recursion, no allocation, O(n log n) in the worst case.
#ifndef SINEW_CORE_SORT_HPP
#define SINEW_CORE_SORT_HPP

#include <stddef.h>

namespace sinew {

// Sorts data[0, count) so that less(data[i + 1], data[i]) is never true. Equal elements keep no order: make keys unique.
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

}  // namespace sinew
#endif
