// SPDX-License-Identifier: MIT
// Ways to run sinew_bind_options::parallel_for: real threads, and single-threaded orders that no real one is stranger than.
#ifndef SINEW_TESTS_LENT_THREADS_HPP
#define SINEW_TESTS_LENT_THREADS_HPP

#include <algorithm>
#include <cstdint>
#include <thread>
#include <vector>

namespace sinew_test {

using LoopBody = void (*)(void*, uint32_t);

// What was asked for; `user` of the functions below.
struct LoopLog {
  uint32_t loops = 0, largest = 0;
  void note(uint32_t count) {
    ++loops;
    largest = std::max(largest, count);
  }
};

// Every piece on a thread of its own, all at once.
inline void run_on_threads(void* user, uint32_t count, LoopBody body, void* data) {
  static_cast<LoopLog*>(user)->note(count);
  std::vector<std::thread> threads;
  for (uint32_t i = 0; i < count; ++i) threads.emplace_back([=] { body(data, i); });
  for (std::thread& thread : threads) thread.join();
}
// The last piece first.
inline void run_backwards(void* user, uint32_t count, LoopBody body, void* data) {
  static_cast<LoopLog*>(user)->note(count);
  for (uint32_t i = count; i-- > 0;) body(data, i);
}

}  // namespace sinew_test
#endif
