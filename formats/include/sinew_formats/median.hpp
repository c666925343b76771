// SPDX-License-Identifier: MIT
// The middle of values.
#ifndef SINEW_FORMATS_MEDIAN_HPP
#define SINEW_FORMATS_MEDIAN_HPP

#include <algorithm>
#include <cstddef>
#include <vector>

namespace sinew {

// The value that half of the others are not above, the upper one of two. Values change their order; there is one at least.
template <class T>
T median(std::vector<T>* values) {
  const auto middle = values->begin() + static_cast<std::ptrdiff_t>(values->size() / 2);
  std::nth_element(values->begin(), middle, values->end());
  return *middle;
}

}  // namespace sinew
#endif
