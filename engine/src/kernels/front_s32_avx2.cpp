// SPDX-License-Identifier: MIT
// The factorisation's inner loops with AVX2: vpmuldq on the even and the odd int32 of a register.
#include "kernels/front.hpp"

#if defined(__AVX2__)
#include <immintrin.h>

#include "kernels/front_s32_wide.hpp"

namespace sinew {
namespace {

struct FrontAvx2 {
  using Int32 = __m256i;
  using Mask = __m256i;
  struct Values {
    __m256i even, odd;
  };
  using Sums = Values;
  static constexpr uint32_t kWidth = 8;

  static SINEW_INLINE Mask first(uint32_t n) {
    return _mm256_cmpgt_epi32(_mm256_set1_epi32(static_cast<int32_t>(n)), _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7));
  }
  static SINEW_INLINE __m256i load(const int32_t* from) {
    return _mm256_loadu_si256(static_cast<const __m256i*>(static_cast<const void*>(from)));
  }
  static SINEW_INLINE __m256i load(const int32_t* from, Mask mask) { return _mm256_maskload_epi32(from, mask); }
  static SINEW_INLINE void store(void* to, __m256i value) { _mm256_storeu_si256(static_cast<__m256i*>(to), value); }
  static SINEW_INLINE void store(int32_t* to, __m256i value, Mask mask) { _mm256_maskstore_epi32(to, mask, value); }

  static SINEW_INLINE Values values(__m256i row) { return {row, _mm256_srli_epi64(row, 32)}; }
  static SINEW_INLINE Sums zero() { return {_mm256_setzero_si256(), _mm256_setzero_si256()}; }
  static SINEW_INLINE Sums add(Sums sums, Values values, int32_t factor) {
    const __m256i factors = _mm256_set1_epi32(factor);
    return {_mm256_add_epi64(sums.even, _mm256_mul_epi32(values.even, factors)),
            _mm256_add_epi64(sums.odd, _mm256_mul_epi32(values.odd, factors))};
  }
  // No arithmetic shift is needed for the low 32 bits.
  static SINEW_INLINE __m256i less(__m256i out, Sums sums) {
    const __m256i half = _mm256_set1_epi64x(1 << (kFrontBits - 1));
    const __m256i low = _mm256_srli_epi64(_mm256_add_epi64(sums.even, half), kFrontBits);
    const __m256i high = _mm256_slli_epi64(_mm256_add_epi64(sums.odd, half), 32 - kFrontBits);
    return _mm256_sub_epi32(out, _mm256_blend_epi32(low, high, 0xAA));
  }
  static SINEW_INLINE void store_sums(int64_t* to, Sums sums) {
    const __m256i low = _mm256_unpacklo_epi64(sums.even, sums.odd), high = _mm256_unpackhi_epi64(sums.even, sums.odd);
    store(to, _mm256_permute2x128_si256(low, high, 0x20));
    store(to + 4, _mm256_permute2x128_si256(low, high, 0x31));
  }
};

}  // namespace

bool add_front_s32_avx2(FrontKernels* kernels) {
  add_fronts<FrontAvx2>(kernels);
  return true;
}

}  // namespace sinew

#else

namespace sinew {

bool add_front_s32_avx2(FrontKernels*) { return false; }

}  // namespace sinew

#endif
