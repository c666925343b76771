// SPDX-License-Identifier: MIT
// The threads of a batch: one that has no character left takes blocks of rows from those that are still at theirs.
#ifndef SINEW_TRAINER_CORE_TEAM_HPP
#define SINEW_TRAINER_CORE_TEAM_HPP

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <functional>
#include <mutex>
#include <vector>

namespace sinew {

class Team {
 public:
  // Calls work(item) once for every item in [0, count) on up to `threads` threads, in rising order; a thread that finds
  // none left helps in blocks() until all are done. The first exception is thrown again here.
  void run(size_t count, unsigned threads, const std::function<void(size_t item, unsigned thread)>& work);

  // Called from inside run()'s work (anywhere else it is a plain loop): calls work(block) once for every block in
  // [0, count), also on threads that are idle. Blocks must not depend on each other; which thread does one is chance,
  // so sums over blocks belong to the caller, in the order of the blocks.
  void blocks(size_t count, const std::function<void(size_t block)>& work);

  // Processor time of all threads in run() since the beginning, and the sum over its calls of the busiest thread's:
  // what it would take if no thread ever waited for a core.
  double work_seconds() const { return work_seconds_; }
  double busiest_seconds() const { return busiest_seconds_; }

 private:
  struct Job {
    const std::function<void(size_t)>* work = nullptr;
    size_t count = 0;
    std::atomic<size_t> next{0};
    unsigned helpers = 0;  // guarded by mutex_
  };
  void loop(size_t count, unsigned thread, std::atomic<size_t>* next,
            const std::function<void(size_t, unsigned)>& work);
  void help();

  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<Job*> jobs_;         // open ones
  size_t unfinished_ = 0;          // items of run()
  std::atomic<unsigned> idle_{0};  // threads in help() without a job
  double work_seconds_ = 0, busiest_seconds_ = 0;
};

}  // namespace sinew
#endif
