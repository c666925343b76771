// SPDX-License-Identifier: MIT
// Median of values.
#ifndef SINEW_FORMATS_MEDIAN_HPP
#define SINEW_FORMATS_MEDIAN_HPP

#include <algorithm>
#include <cstddef>
#include <vector>

namespace sinew {

// Returns the median, the upper one of two. Reorders the values; needs at least one.
template <class T>
T median(std::vector<T>* values) {
  const auto middle = values->begin() + static_cast<std::ptrdiff_t>(values->size() / 2);
  std::nth_element(values->begin(), middle, values->end());
  return *middle;
}

}  // namespace sinew
#endif
