// SPDX-License-Identifier: MIT
// The caller's threads (sinew_bind_options::parallel_for): how a stage hands out independent work.
#ifndef SINEW_CORE_THREADS_HPP
#define SINEW_CORE_THREADS_HPP

#include <stdint.h>

#include "core/build.hpp"
#include "sinew/sinew.h"

namespace sinew {

// Work is shared among `lanes`, whatever threads there are: without parallel_for they run one after the other. Scratch
// that work writes is there once per lane, so that the workspace is a function of this number alone.
struct Threads {
  uint32_t lanes = 1;  // 1..SINEW_MAX_THREADS
  sinew_parallel_for parallel_for = nullptr;
  void* user = nullptr;

  // Number of lanes; a constant in builds without threads.
  uint32_t lane_count() const { return kHasThreads ? lanes : 1; }

  // body(index, lane) for every index in [0, count). Lane l takes l, l + lanes, ...: fixed, so nothing is shared that
  // threads would have to agree on, and interleaved, so that neighbors of unlike cost are spread. A body writes only
  // what belongs to its index or its lane, which makes every order of calls the same. Not to be nested.
  template <class Body>
  void each(uint32_t count, const Body& body) const {
    if (!kHasThreads) {
      for (uint32_t index = 0; index < count; ++index) body(index, 0);
      return;
    }
    const uint32_t used = count < lanes ? count : lanes;
    const Job<Body> job = {&body, count, used};
    if (used < 2 || parallel_for == nullptr) {
      for (uint32_t lane = 0; lane < used; ++lane) Job<Body>::run(const_cast<Job<Body>*>(&job), lane);
    } else {
      parallel_for(user, used, Job<Body>::run, const_cast<Job<Body>*>(&job));
    }
  }

  // The same over the pieces [begin, end) of [0, count), `size` each and the last one shorter: body(begin, end, lane).
  // Without threads it is one piece, which may be empty.
  template <class Body>
  void ranges(uint32_t count, uint32_t size, const Body& body) const {
    if (!kHasThreads) return body(0, count, 0);
    each((count + size - 1) / size, [&](uint32_t index, uint32_t lane) {
      const uint32_t begin = index * size;
      body(begin, count - begin < size ? count : begin + size, lane);
    });
  }

  // For results that are worked out side by side and added up one after the other: make(index, slot) for a round of
  // indices, slots from 0 to below round_size(count), then take(index, slot) for the same on the calling thread.
  template <class Make, class Take>
  void rounds(uint32_t count, const Make& make, const Take& take) const {
    if (!kHasThreads) {
      for (uint32_t index = 0; index < count; ++index) {
        make(index, 0);
        take(index, 0);
      }
      return;
    }
    const uint32_t round = round_size(count);
    for (uint32_t first = 0; first < count; first += round) {
      const uint32_t some = count - first < round ? count - first : round;
      ranges(some, kRoundPiece, [&](uint32_t begin, uint32_t end, uint32_t) {
        for (uint32_t slot = begin; slot < end; ++slot) make(first + slot, slot);
      });
      for (uint32_t slot = 0; slot < some; ++slot) take(first + slot, slot);
    }
  }
  // Rounds keep the lanes busy and their results in the cache. Never falls as the count grows.
  uint32_t round_size(uint32_t count) const {
    const uint32_t most = kHasThreads ? kRoundPiece * 8 * lane_count() : 1;
    return count < most ? count : most;
  }

 private:
  static constexpr uint32_t kRoundPiece = 64;

  template <class Body>
  struct Job {
    const Body* body;
    uint32_t count, lanes;
    static void run(void* data, uint32_t lane) {
      const Job& job = *static_cast<const Job*>(data);
      for (uint32_t index = lane; index < job.count; index += job.lanes) (*job.body)(index, lane);
    }
  };
};

// Work of another stage that a stage takes along, on a lane of its own where it has few pieces. It reports no progress.
struct WorkBeside {
  void (*run)(void* data) = nullptr;
  void* data = nullptr;
};

}  // namespace sinew
#endif
