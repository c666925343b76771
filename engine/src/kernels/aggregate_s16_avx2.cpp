// SPDX-License-Identifier: MIT
// Aggregations over one-rings, candidates, parts and all rows with AVX2, 16 channels at a time.
#include "kernels/variants.hpp"

#if defined(__AVX2__)
#include "kernels/aggregate_s16_256.hpp"

namespace sinew {
namespace {

struct AggregateAvx2 : Channels256 {
  struct Sums {
    __m256i low, high;
  };
  struct Divider {
    __m256i multiplier, offset;
  };

  static SINEW_INLINE __m256i largest(__m256i a, __m256i b) { return _mm256_max_epi16(a, b); }

  static SINEW_INLINE Sums zero_sums() { return {_mm256_setzero_si256(), _mm256_setzero_si256()}; }
  static SINEW_INLINE Sums add(Sums sums, __m256i values) {
    return {_mm256_add_epi32(sums.low, _mm256_cvtepi16_epi32(_mm256_castsi256_si128(values))),
            _mm256_add_epi32(sums.high, _mm256_cvtepi16_epi32(_mm256_extracti128_si256(values, 1)))};
  }
  static SINEW_INLINE Sums load_sums(const int32_t* from) {
    const __m256i* const registers = static_cast<const __m256i*>(static_cast<const void*>(from));
    return {_mm256_loadu_si256(registers), _mm256_loadu_si256(registers + 1)};
  }
  static SINEW_INLINE void store_sums(int32_t* to, Sums sums) {
    __m256i* const registers = static_cast<__m256i*>(static_cast<void*>(to));
    _mm256_storeu_si256(registers, sums.low);
    _mm256_storeu_si256(registers + 1, sums.high);
  }

  static SINEW_INLINE Divider divider(MeanDivision division) {
    return {_mm256_set1_epi32(static_cast<int32_t>(division.multiplier)),
            _mm256_set1_epi32(static_cast<int32_t>(division.offset))};
  }
  static SINEW_INLINE __m256i divide(const Divider& by, __m256i sums) {
    const __m256i dividend = _mm256_add_epi32(_mm256_add_epi32(sums, sums), by.offset);
    const __m256i even = _mm256_srli_epi64(_mm256_mul_epu32(dividend, by.multiplier), 32);
    const __m256i odd = _mm256_mul_epu32(_mm256_srli_epi64(dividend, 32), by.multiplier);
    return _mm256_blend_epi32(even, odd, 0xAA);
  }
  static SINEW_INLINE __m256i means(const Divider& by, Sums sums) {
    const __m256i packed = _mm256_packus_epi32(divide(by, sums.low), divide(by, sums.high));
    return _mm256_xor_si256(_mm256_permute4x64_epi64(packed, 0xD8), _mm256_set1_epi16(INT16_MIN));
  }

  static SINEW_INLINE uint32_t find_of_8(const uint16_t* joints, uint16_t joint) {
    const __m128i row = _mm_loadu_si128(static_cast<const __m128i*>(static_cast<const void*>(joints)));
    const __m128i equal = _mm_cmpeq_epi16(row, _mm_set1_epi16(static_cast<int16_t>(joint)));
    const uint32_t mask = static_cast<uint32_t>(_mm_movemask_epi8(equal));
    return mask == 0 ? 8 : lowest_bit(mask) / 2;
  }
};

}  // namespace

bool add_aggregates_s16_avx2(Kernels* kernels) {
  add_aggregates<AggregateAvx2>(kernels);
  return true;
}

}  // namespace sinew
#else
namespace sinew {
bool add_aggregates_s16_avx2(Kernels*) { return false; }
}  // namespace sinew
#endif
