// SPDX-License-Identifier: MIT
// Workspace arena: hands out pieces of the caller's one block, or only counts them.
//
// The size query runs the same functions as a bind, with a measuring arena. Such a function takes its memory, calls
// those that it always calls, and leaves out the work where arena.measuring(). So the order of allocations is written
// once. The work takes no memory: what it took would be missing from the size query, and every bind would fail.
#ifndef SINEW_CORE_ARENA_HPP
#define SINEW_CORE_ARENA_HPP

#include <stddef.h>
#include <stdint.h>

#include "core/build.hpp"

namespace sinew {

// A count that does not fit size_t becomes SIZE_MAX, which no arena grants.
inline size_t checked(uint64_t count) { return count > SIZE_MAX ? SIZE_MAX : static_cast<size_t>(count); }

class Arena {
 public:
  // A measuring arena: alloc() returns null and counts bytes; used() and high_water() tell the need.
  Arena() = default;
  // A real arena over [base, base + size_bytes). base must be aligned to 64.
  Arena(void* base, size_t size_bytes) : base_(static_cast<uint8_t*>(base)), size_(size_bytes) {}

  bool measuring() const { return base_ == nullptr; }
  // False once any allocation did not fit (or a size overflowed); stays false.
  bool ok() const { return ok_; }
  size_t used() const { return used_; }
  size_t high_water() const { return high_; }

  // Room for count objects of T, 64-byte aligned, uninitialized. Null when measuring or full: check ok() after a group.
  template <class T>
  T* alloc(size_t count) {
    return static_cast<T*>(take(count, sizeof(T)));
  }

  // Stack discipline: everything allocated after mark() is given back by release().
  size_t mark() const { return used_; }
  void release(size_t mark) { used_ = mark; }

 private:
  SINEW_ONCE void* take(size_t count, size_t size) {
    const bool fits = count <= (SIZE_MAX / 4) / size;
    const size_t rounded = fits ? (count * size + 63u) & ~static_cast<size_t>(63u) : 0;
    if (!fits || used_ + rounded < used_ || (base_ != nullptr && used_ + rounded > size_)) {
      ok_ = false;
      return nullptr;
    }
    uint8_t* p = base_ != nullptr ? base_ + used_ : nullptr;
    used_ += rounded;
    if (used_ > high_) high_ = used_;
    return p;
  }

  uint8_t* base_ = nullptr;
  size_t size_ = 0;
  size_t used_ = 0;
  size_t high_ = 0;
  bool ok_ = true;
};

// Gives back at its end what was taken from the arena since its beginning.
class ArenaScope {
 public:
  explicit ArenaScope(Arena& arena) : arena_(arena), mark_(arena.mark()) {}
  ~ArenaScope() { arena_.release(mark_); }
  ArenaScope(const ArenaScope&) = delete;
  ArenaScope& operator=(const ArenaScope&) = delete;

 private:
  Arena& arena_;
  const size_t mark_;
};

}  // namespace sinew
#endif
