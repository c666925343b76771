// SPDX-License-Identifier: MIT
// Random numbers for property tests: the same on every machine for a seed.
#ifndef SINEW_TEST_DRAW_HPP
#define SINEW_TEST_DRAW_HPP

#include <cstdint>
#include <random>

namespace sinew_test {

class Draw {
 public:
  explicit Draw(uint32_t seed) : random_(seed) {}
  uint32_t below(uint32_t n) { return static_cast<uint32_t>(random_() % n); }
  bool chance(uint32_t percent) { return below(100) < percent; }
  float range(float low, float high) {
    return low + (high - low) * static_cast<float>(static_cast<double>(random_() >> 11) * 0x1p-53);
  }

 private:
  std::mt19937_64 random_;
};

}  // namespace sinew_test

#endif
