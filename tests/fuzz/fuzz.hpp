// SPDX-License-Identifier: MIT
// What every fuzz target shares. A target is one function over arbitrary bytes; libFuzzer calls it (SINEW_BUILD_FUZZ),
// and so does replay_test.cpp with the corpus in git.
#ifndef SINEW_TESTS_FUZZ_HPP
#define SINEW_TESTS_FUZZ_HPP

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size);

namespace sinew::test {

// Not a sinew::Error: no target catches it, so libFuzzer reports a crash and GoogleTest a failure with this text.
class BrokenProperty : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

inline void demand(bool holds, const std::string& property) {
  if (!holds) throw BrokenProperty("broken property: " + property);
}

// Bytes of an input as numbers; zeros behind its end, so that every input means something.
class Bytes {
 public:
  Bytes(const uint8_t* data, size_t size) : data_(data), size_(size) {}

  uint8_t u8() { return at_ < size_ ? data_[at_++] : uint8_t{0}; }
  uint16_t u16() {
    const uint8_t low = u8();
    return static_cast<uint16_t>(low | u8() << 8);
  }
  uint32_t u32() {
    const uint32_t low = u16();
    return low | static_cast<uint32_t>(u16()) << 16;
  }
  // 0..n-1
  uint32_t below(uint32_t n) { return u8() % n; }

 private:
  const uint8_t* data_;
  size_t size_, at_ = 0;
};

}  // namespace sinew::test
#endif
