// SPDX-License-Identifier: MIT
// The factorisation's inner loops with AVX-512: vpmuldq on the even and the odd int32 of a register.
#include "kernels/front.hpp"

#if defined(__AVX512F__)
#include <immintrin.h>

#include "kernels/front_s32_wide.hpp"

namespace sinew {
namespace {

struct FrontAvx512 {
  using Int32 = __m512i;
  using Mask = __mmask16;
  struct Values {
    __m512i even, odd;
  };
  using Sums = Values;
  static constexpr uint32_t kWidth = 16;

  static SINEW_INLINE Mask first(uint32_t n) { return static_cast<Mask>((1u << n) - 1); }
  static SINEW_INLINE __m512i load(const int32_t* from) { return _mm512_loadu_si512(from); }
  static SINEW_INLINE __m512i load(const int32_t* from, Mask mask) { return _mm512_maskz_loadu_epi32(mask, from); }
  static SINEW_INLINE void store(int32_t* to, __m512i value) { _mm512_storeu_si512(to, value); }
  static SINEW_INLINE void store(int32_t* to, __m512i value, Mask mask) { _mm512_mask_storeu_epi32(to, mask, value); }

  static SINEW_INLINE Values values(__m512i row) { return {row, _mm512_srli_epi64(row, 32)}; }
  static SINEW_INLINE Sums zero() { return {_mm512_setzero_si512(), _mm512_setzero_si512()}; }
  static SINEW_INLINE Sums add(Sums sums, Values values, int32_t factor) {
    const __m512i factors = _mm512_set1_epi32(factor);
    return {_mm512_add_epi64(sums.even, _mm512_mul_epi32(values.even, factors)),
            _mm512_add_epi64(sums.odd, _mm512_mul_epi32(values.odd, factors))};
  }
  // No arithmetic shift is needed for the low 32 bits.
  static SINEW_INLINE __m512i less(__m512i out, Sums sums) {
    const __m512i half = _mm512_set1_epi64(1 << (kFrontBits - 1));
    const __m512i low = _mm512_srli_epi64(_mm512_add_epi64(sums.even, half), kFrontBits);
    const __m512i high = _mm512_slli_epi64(_mm512_add_epi64(sums.odd, half), 32 - kFrontBits);
    return _mm512_sub_epi32(out, _mm512_mask_blend_epi32(0xAAAA, low, high));
  }
  static SINEW_INLINE void store_sums(int64_t* to, Sums sums) {
    const __m512i first_half = _mm512_setr_epi64(0, 8, 1, 9, 2, 10, 3, 11),
                  second_half = _mm512_setr_epi64(4, 12, 5, 13, 6, 14, 7, 15);
    _mm512_storeu_si512(to, _mm512_permutex2var_epi64(sums.even, first_half, sums.odd));
    _mm512_storeu_si512(to + 8, _mm512_permutex2var_epi64(sums.even, second_half, sums.odd));
  }
};

}  // namespace

bool add_front_s32_avx512(FrontKernels* kernels) {
  add_fronts<FrontAvx512>(kernels);
  return true;
}

}  // namespace sinew

#else

namespace sinew {

bool add_front_s32_avx512(FrontKernels*) { return false; }

}  // namespace sinew

#endif
