// SPDX-License-Identifier: MIT
// Bytes of a model file in memory that the engine accepts.
#ifndef SINEW_TESTS_ALIGNED_BYTES_HPP
#define SINEW_TESTS_ALIGNED_BYTES_HPP

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace sinew::test {

// Bytes at an address divisible by 64, as a caller would hold a model or a workspace.
class AlignedBytes {
 public:
  explicit AlignedBytes(size_t size) : size_(size), words_(size / 64 + 1) {}
  explicit AlignedBytes(const std::vector<uint8_t>& bytes) : AlignedBytes(bytes.size()) {
    std::copy(bytes.begin(), bytes.end(), data());
  }
  uint8_t* data() { return reinterpret_cast<uint8_t*>(words_.data()); }
  const uint8_t* data() const { return reinterpret_cast<const uint8_t*>(words_.data()); }
  size_t size() const { return size_; }

 private:
  struct alignas(64) Block {
    uint8_t bytes[64];
  };
  size_t size_;
  std::vector<Block> words_;
};

}  // namespace sinew::test
#endif
