// SPDX-License-Identifier: MIT
// Sixteen channels in 256 bits for aggregate_s16_wide.hpp, with AVX2 as with AVX-512.
#ifndef SINEW_KERNELS_AGGREGATE_S16_256_HPP
#define SINEW_KERNELS_AGGREGATE_S16_256_HPP

#include <immintrin.h>

#include "kernels/aggregate_s16_wide.hpp"

namespace sinew {
namespace {

struct Channels256 {
  using Int16 = __m256i;
  static constexpr int kWidth = 16, kMeanRegisters = 3;

  static SINEW_INLINE __m256i load(const int16_t* from) {
    return _mm256_loadu_si256(static_cast<const __m256i*>(static_cast<const void*>(from)));
  }
  static SINEW_INLINE void store(int16_t* to, __m256i value) {
    _mm256_storeu_si256(static_cast<__m256i*>(static_cast<void*>(to)), value);
  }
};

}  // namespace
}  // namespace sinew
#endif
