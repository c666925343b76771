// SPDX-License-Identifier: MIT
// The table of powers that softmax interpolates, for its definition and its variants: a copy in each.
#ifndef SINEW_KERNELS_SOFTMAX_S16_POWERS_HPP
#define SINEW_KERNELS_SOFTMAX_S16_POWERS_HPP

#include <stdint.h>

namespace sinew {
namespace {

constexpr uint32_t kStepBits = 6;  // 64 table steps per octave: linear interpolation is off by at most 1.5e-5
constexpr uint32_t kFineBits = 10 - kStepBits;
constexpr uint32_t kSteps = 1u << kStepBits;

constexpr uint64_t sqrt_floor(uint64_t v) {
  uint64_t root = 0;
  for (uint64_t bit = static_cast<uint64_t>(1) << 31; bit != 0; bit >>= 1) {
    if ((root | bit) * (root | bit) <= v) root |= bit;
  }
  return root;
}

// 2^(-i / 64) in Q30, i = 0..64, made by the compiler: 2^(-1/2), 2^(-1/4) ... are repeated square roots of 1/2 in Q31,
// and the entry for i is the product of those whose bit is set in i.
struct PowerTable {
  uint32_t q30[kSteps + 1];
  constexpr PowerTable() : q30() {
    uint64_t roots[kStepBits] = {};
    uint64_t root = static_cast<uint64_t>(1) << 30;  // 1/2
    for (uint32_t b = kStepBits; b-- > 0;) {
      root = sqrt_floor(root << 31);
      roots[b] = root;
    }
    for (uint32_t i = 0; i < kSteps; ++i) {
      uint64_t value = static_cast<uint64_t>(1) << 31;
      for (uint32_t b = 0; b < kStepBits; ++b) {
        if ((i >> b) & 1u) value = (value * roots[b] + (1u << 30)) >> 31;
      }
      q30[i] = static_cast<uint32_t>((value + 1) >> 1);
    }
    q30[kSteps] = 1u << 29;
  }
};
constexpr PowerTable kPowers;

}  // namespace
}  // namespace sinew
#endif
