// SPDX-License-Identifier: MIT
// Threads are started anew for each loop.
#include "sinew_formats/base/parallel.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace sinew {

void parallel_for(size_t count, unsigned threads, const std::function<void(size_t, unsigned)>& work) {
  std::atomic<size_t> next{0};
  std::exception_ptr failure;
  std::mutex failure_mutex;
  const auto loop = [&](unsigned thread) {
    try {
      for (size_t item = next++; item < count; item = next++) work(item, thread);
    } catch (...) {
      next = count;
      const std::lock_guard<std::mutex> lock(failure_mutex);
      if (!failure) failure = std::current_exception();
    }
  };
  const size_t used = std::min<size_t>(std::max(threads, 1u), count);
  std::vector<std::thread> others;
  // Starting a thread takes some 20 us, a training step 50 ms or more: a standing pool would gain nothing.
  for (size_t t = 1; t < used; ++t) others.emplace_back(loop, static_cast<unsigned>(t));
  loop(0);
  for (std::thread& other : others) other.join();
  if (failure) std::rethrow_exception(failure);
}

}  // namespace sinew
