// SPDX-License-Identifier: MIT
// A loop over a few pieces of work on threads that stay, because a bind has a hundred of them.
#include "sinew_character/jobs/thread_pool.hpp"

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

}  // namespace sinew
