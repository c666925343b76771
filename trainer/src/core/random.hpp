// SPDX-License-Identifier: MIT
// Seeded random numbers of the trainer: one 64-bit word of state, so that a checkpoint can hold it.
#ifndef SINEW_TRAINER_CORE_RANDOM_HPP
#define SINEW_TRAINER_CORE_RANDOM_HPP

#include <cmath>
#include <cstdint>

namespace sinew {

// Steele, Lea, Flood 2014, "Fast splittable pseudorandom number generators": the output function of SplitMix64.
inline uint64_t mix64(uint64_t z) {
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
  return z ^ (z >> 31);
}

// One seed out of several numbers; different arguments give unrelated seeds.
inline uint64_t mix_seeds(uint64_t a, uint64_t b, uint64_t c = 0) {
  return mix64(mix64(mix64(a + 0x9E3779B97F4A7C15ull) + b + 0x632BE59BD9B4E019ull) + c + 0xD1B54A32D192ED03ull);
}

class Random {
 public:
  explicit Random(uint64_t seed) : state_(seed) {}
  uint64_t next() { return mix64(state_ += 0x9E3779B97F4A7C15ull); }
  double uniform() { return static_cast<double>(next() >> 11) * 0x1.0p-53; }  // [0, 1)
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  uint32_t below(uint32_t bound) {  // [0, bound); the bias of 2^-32 * bound does not matter here
    return static_cast<uint32_t>(((next() >> 32) * bound) >> 32);
  }
  double normal() {  // Box and Muller; the second value is thrown away so that the state stays one word
    const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform()));
    return radius * std::cos(6.283185307179586 * uniform());
  }
  uint64_t state() const { return state_; }

 private:
  uint64_t state_;
};

}  // namespace sinew
#endif
