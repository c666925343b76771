// SPDX-License-Identifier: MIT
// A loop over independent items on several threads; the first exception is handed to the caller.
#ifndef SINEW_FORMATS_BASE_PARALLEL_HPP
#define SINEW_FORMATS_BASE_PARALLEL_HPP

#include <cstddef>
#include <functional>

namespace sinew {

// Calls work(item, thread) once for every item in [0, count), thread in [0, threads). Items start in rising order. After
// an exception no further item starts; the first one is thrown again here.
void parallel_for(size_t count, unsigned threads, const std::function<void(size_t item, unsigned thread)>& work);

}  // namespace sinew
#endif
