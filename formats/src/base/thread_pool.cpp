// SPDX-License-Identifier: MIT
// The threads stay between two loops, because a bind has a hundred of them.
#include "sinew_formats/base/thread_pool.hpp"

#include <algorithm>
#include <exception>
#include <mutex>

namespace sinew {

ThreadPool::ThreadPool(unsigned threads) {
  for (unsigned i = 1; i < threads; ++i) others_.emplace_back([this] { serve(); });
}

ThreadPool::~ThreadPool() {
  stop_ = true;
  ++loop_;
  loop_.notify_all();
  for (std::thread& thread : others_) thread.join();
}

void ThreadPool::parallel_for(void* user, uint32_t count, void (*body)(void*, uint32_t), void* data) {
  static_cast<ThreadPool*>(user)->run(count, body, data);
}

void ThreadPool::run(uint32_t count, void (*body)(void*, uint32_t), void* data) {
  body_ = body;
  data_ = data;
  count_ = count;
  next_ = 0;
  working_ = static_cast<uint32_t>(others_.size());
  ++loop_;
  loop_.notify_all();
  work();
  for (uint32_t left = working_; left != 0; left = working_) working_.wait(left);
}

void ThreadPool::work() {
  for (uint32_t i = next_++; i < count_; i = next_++) body_(data_, i);
}

void ThreadPool::serve() {
  uint32_t seen = 0;
  for (;;) {
    loop_.wait(seen);
    seen = loop_;
    if (stop_) return;
    work();
    if (--working_ == 0) working_.notify_one();
  }
}

void parallel_for(size_t count, unsigned threads, const std::function<void(size_t, unsigned)>& work) {
  std::atomic<size_t> next{0};
  std::exception_ptr failure;
  std::mutex failure_mutex;
  auto loop = [&](unsigned thread) {
    try {
      for (size_t item = next++; item < count; item = next++) work(item, thread);
    } catch (...) {
      next = count;
      const std::lock_guard<std::mutex> lock(failure_mutex);
      if (!failure) failure = std::current_exception();
    }
  };
  const unsigned used = static_cast<unsigned>(std::min<size_t>(std::max(threads, 1u), count));
  ThreadPool(used).run(
      used, [](void* data, uint32_t thread) { (*static_cast<decltype(loop)*>(data))(thread); }, &loop);
  if (failure) std::rethrow_exception(failure);
}

}  // namespace sinew
