// SPDX-License-Identifier: MIT
// A thread pool for sinew_bind_options::parallel_for, and a parallel loop over independent items.
#ifndef SINEW_FORMATS_BASE_THREAD_POOL_HPP
#define SINEW_FORMATS_BASE_THREAD_POOL_HPP

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <thread>
#include <vector>

namespace sinew {

// Consists of the calling thread and `threads - 1` others, which sleep between loops. One caller at a time.
class ThreadPool {
 public:
  explicit ThreadPool(unsigned threads);
  ~ThreadPool();
  ThreadPool(const ThreadPool&) = delete;
  ThreadPool& operator=(const ThreadPool&) = delete;

  // body(data, i) for i in 0..count-1; returns when all are done.
  void run(uint32_t count, void (*body)(void* data, uint32_t index), void* data);
  // For sinew_bind_options; `user` is the pool.
  static void parallel_for(void* user, uint32_t count, void (*body)(void* data, uint32_t index), void* data);

 private:
  void work();
  void serve();

  std::vector<std::thread> others_;
  // The current loop; written while all other threads sleep.
  void (*body_)(void*, uint32_t) = nullptr;
  void* data_ = nullptr;
  uint32_t count_ = 0;
  bool stop_ = false;
  std::atomic<uint32_t> next_{0};     // index
  std::atomic<uint32_t> loop_{0};     // counts loops; the other threads wait for a change
  std::atomic<uint32_t> working_{0};  // number of other threads still at work
};

// Calls work(item, thread) once for every item in [0, count), thread in [0, threads). Items start in ascending order.
// After an exception no further item starts; the first exception is rethrown here.
void parallel_for(size_t count, unsigned threads, const std::function<void(size_t item, unsigned thread)>& work);

}  // namespace sinew
#endif
