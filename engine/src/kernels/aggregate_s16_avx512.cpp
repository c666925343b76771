// SPDX-License-Identifier: MIT
// Means over one-rings, parts and all rows with AVX-512, 16 channels at a time: their sums fill one register. Maxima
// gain nothing over AVX2.
#include "kernels/variants.hpp"

#if defined(__AVX512BW__) && defined(__AVX512VL__)
#include "kernels/aggregate_s16_256.hpp"

namespace sinew {
namespace {

struct AggregateAvx512 : Channels256 {
  using Sums = __m512i;
  struct Divider {
    __m512i multiplier, offset;
  };

  static SINEW_INLINE __m512i zero_sums() { return _mm512_setzero_si512(); }
  static SINEW_INLINE __m512i add(__m512i sums, __m256i values) {
    return _mm512_add_epi32(sums, _mm512_cvtepi16_epi32(values));
  }
  static SINEW_INLINE __m512i load_sums(const int32_t* from) { return _mm512_loadu_si512(from); }
  static SINEW_INLINE void store_sums(int32_t* to, __m512i sums) { _mm512_storeu_si512(to, sums); }

  static SINEW_INLINE Divider divider(MeanDivision division) {
    return {_mm512_set1_epi32(static_cast<int32_t>(division.multiplier)),
            _mm512_set1_epi32(static_cast<int32_t>(division.offset))};
  }
  static SINEW_INLINE __m256i means(const Divider& by, __m512i sums) {
    const __m512i dividend = _mm512_add_epi32(_mm512_add_epi32(sums, sums), by.offset);
    const __m512i even = _mm512_srli_epi64(_mm512_mul_epu32(dividend, by.multiplier), 32);
    const __m512i odd = _mm512_mul_epu32(_mm512_srli_epi64(dividend, 32), by.multiplier);
    const __m512i quotients = _mm512_mask_mov_epi32(even, 0xAAAA, odd);
    return _mm256_xor_si256(_mm512_cvtepi32_epi16(quotients), _mm256_set1_epi16(INT16_MIN));
  }

  static SINEW_INLINE uint32_t find_of_8(const uint16_t* joints, uint16_t joint) {
    const __m128i row = _mm_loadu_si128(static_cast<const __m128i*>(static_cast<const void*>(joints)));
    const uint32_t equal = _mm_cmpeq_epi16_mask(row, _mm_set1_epi16(static_cast<int16_t>(joint)));
    return equal == 0 ? 8 : lowest_bit(equal);
  }
};

}  // namespace

bool add_means_s16_avx512(Kernels* kernels) {
  add_means<AggregateAvx512>(kernels);
  return true;
}

}  // namespace sinew
#else
namespace sinew {
bool add_means_s16_avx512(Kernels*) { return false; }
}  // namespace sinew
#endif
