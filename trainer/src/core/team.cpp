// SPDX-License-Identifier: MIT
// A loop over characters whose idle threads help with the rows of the others.
#include "core/team.hpp"

#include <time.h>

#include <algorithm>
#include <numeric>

#include "sinew_formats/base/thread_pool.hpp"

namespace sinew {

namespace {

double processor_seconds() {  // of this thread
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

}  // namespace

void Team::run(size_t count, unsigned threads, const std::function<void(size_t, unsigned)>& work) {
  threads = std::max(threads, 1u);
  unfinished_ = count;
  std::atomic<size_t> next{0};
  std::vector<double> seconds(threads, 0.0);
  // As many items as threads, so each thread gets one loop; one that is late finds the work done and its time is small.
  parallel_for(threads, threads, [&](size_t, unsigned thread) {
    const double start = processor_seconds();
    loop(count, thread, &next, work);
    seconds[thread] += processor_seconds() - start;
  });
  work_seconds_ += std::accumulate(seconds.begin(), seconds.end(), 0.0);
  busiest_seconds_ += *std::max_element(seconds.begin(), seconds.end());
}

void Team::loop(size_t count, unsigned thread, std::atomic<size_t>* next,
                const std::function<void(size_t, unsigned)>& work) {
  const auto finished = [this] {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (--unfinished_ == 0) changed_.notify_all();
  };
  for (size_t item = (*next)++; item < count; item = (*next)++) {
    try {
      work(item, thread);
    } catch (...) {
      finished();
      throw;
    }
    finished();
  }
  help();
}

void Team::blocks(size_t count, const std::function<void(size_t)>& work) {
  if (count < 2 || idle_ == 0) {
    for (size_t block = 0; block < count; ++block) work(block);
    return;
  }
  Job job;
  job.work = &work;
  job.count = count;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    jobs_.push_back(&job);
  }
  changed_.notify_all();
  for (size_t block = job.next++; block < count; block = job.next++) work(block);
  std::unique_lock<std::mutex> lock(mutex_);
  jobs_.erase(std::find(jobs_.begin(), jobs_.end(), &job));
  changed_.wait(lock, [&] { return job.helpers == 0; });
}

void Team::help() {
  std::unique_lock<std::mutex> lock(mutex_);
  while (unfinished_ > 0) {
    const auto open = std::find_if(jobs_.begin(), jobs_.end(), [](const Job* job) { return job->next < job->count; });
    if (open == jobs_.end()) {
      ++idle_;
      changed_.wait(lock);
      --idle_;
      continue;
    }
    Job* job = *open;
    ++job->helpers;
    lock.unlock();
    for (size_t block = job->next++; block < job->count; block = job->next++) (*job->work)(block);
    lock.lock();
    if (--job->helpers == 0) changed_.notify_all();
  }
}

}  // namespace sinew
