// SPDX-License-Identifier: MIT
// Random numbers that are the same with every standard library.
#ifndef SINEW_TESTS_SUPPORT_RANDOM_HPP
#define SINEW_TESTS_SUPPORT_RANDOM_HPP

#include <cmath>
#include <cstdint>
#include <random>

namespace sinew::test {

class Random {
 public:
  explicit Random(uint32_t seed) : engine_(seed) {}
  uint32_t below(uint32_t n) { return static_cast<uint32_t>(engine_()) % n; }
  int32_t between(int32_t low, int32_t high) {
    return low + static_cast<int32_t>(below(static_cast<uint32_t>(high - low + 1)));
  }
  double uniform() { return static_cast<double>(engine_()) / 4294967296.0; }
  double normal() { return std::sqrt(-2 * std::log(1 - uniform())) * std::cos(6.283185307179586 * uniform()); }
  std::mt19937& engine() { return engine_; }

 private:
  std::mt19937 engine_;
};

}  // namespace sinew::test
#endif
