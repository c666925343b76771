// SPDX-License-Identifier: MIT
// 256-bit registers for linear_s16_tiles.hpp; AVX2 and AVX-VNNI differ in one instruction.
#ifndef SINEW_KERNELS_LINEAR_S16_256_HPP
#define SINEW_KERNELS_LINEAR_S16_256_HPP

#include <immintrin.h>

#include "kernels/linear_s16_tiles.hpp"

namespace sinew {
namespace {

// Dot::dot() is the multiply-add.
template <class Dot>
struct Registers256 : Dot {
  using Int32 = __m256i;
  using Pairs = __m256i;
  static constexpr int kWidth = 8, kGroups = 1, kFinish = 1;
  // 6 rows x 2 registers of sums, 2 of weights, an input and a product fill the 16 registers.
  static constexpr int kRows[kGroups + 1] = {0, 6};

  static SINEW_INLINE Int32 zero() { return _mm256_setzero_si256(); }
  static SINEW_INLINE Int32 load(const int32_t* from) {
    return _mm256_loadu_si256(static_cast<const __m256i*>(static_cast<const void*>(from)));
  }
  static SINEW_INLINE void store(int32_t* to, Int32 value) {
    _mm256_storeu_si256(static_cast<__m256i*>(static_cast<void*>(to)), value);
  }
  static SINEW_INLINE Int32 add(Int32 a, Int32 b) { return _mm256_add_epi32(a, b); }
  static SINEW_INLINE Pairs broadcast(int32_t pair) { return _mm256_set1_epi32(pair); }
  static SINEW_INLINE Pairs load_pairs(const int16_t* from) {
    return _mm256_load_si256(static_cast<const __m256i*>(static_cast<const void*>(from)));
  }
  static SINEW_INLINE __m256i requantize(__m256i sum, const int32_t* shifts, const int32_t* factors, __m128i residual,
                                         int32_t low, int32_t high) {
    if (factors != nullptr) {
      sum = _mm256_add_epi32(sum, _mm256_mullo_epi32(_mm256_cvtepi16_epi32(residual), load(factors)));
    }
    sum = _mm256_srav_epi32(sum, load(shifts));
    return _mm256_min_epi32(_mm256_max_epi32(sum, _mm256_set1_epi32(low)), _mm256_set1_epi32(high));
  }
  static SINEW_INLINE void finish(const Int32* sums, const int32_t* shifts, const int32_t* factors,
                                  const int16_t* residual, int32_t low, int32_t high, uint32_t count, int16_t* out) {
    __m256i values = _mm256_setzero_si256();
    if (factors != nullptr) {
      int16_t copy[16] = {};
      if (count < 16) memcpy(copy, residual, count * sizeof(int16_t));
      values = _mm256_loadu_si256(static_cast<const __m256i*>(static_cast<const void*>(count < 16 ? copy : residual)));
    }
    const __m256i a = requantize(sums[0], shifts, factors, _mm256_castsi256_si128(values), low, high);
    const __m256i b = requantize(sums[1], shifts + 8, factors == nullptr ? nullptr : factors + 8,
                                 _mm256_extracti128_si256(values, 1), low, high);
    const __m256i packed = _mm256_permute4x64_epi64(_mm256_packs_epi32(a, b), 0xD8);  // halves back in order
    if (count == 16) {
      _mm256_storeu_si256(static_cast<__m256i*>(static_cast<void*>(out)), packed);
    } else {
      int16_t copy[16];
      _mm256_storeu_si256(static_cast<__m256i*>(static_cast<void*>(copy)), packed);
      memcpy(out, copy, count * sizeof(int16_t));
    }
  }
};

}  // namespace
}  // namespace sinew
#endif
