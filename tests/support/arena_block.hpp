// SPDX-License-Identifier: MIT
// A block of memory for pieces of a stage that a test runs on their own.
#ifndef SINEW_TESTS_SUPPORT_ARENA_BLOCK_HPP
#define SINEW_TESTS_SUPPORT_ARENA_BLOCK_HPP

#include <cstdlib>

#include "core/arena.hpp"

namespace sinew_test {

// The arena goes with the block.
struct Block {
  explicit Block(size_t bytes)
      : bytes_((bytes + 63) / 64 * 64), memory(std::aligned_alloc(64, bytes_)), arena(memory, bytes_) {}
  ~Block() { std::free(memory); }
  Block(const Block&) = delete;
  Block& operator=(const Block&) = delete;
  size_t bytes_;
  void* memory;
  sinew::Arena arena;
};

}  // namespace sinew_test
#endif
