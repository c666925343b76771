// SPDX-License-Identifier: MIT
// Softmax with AVX2, eight candidates at a time.
#include "kernels/softmax.hpp"

#if defined(__AVX2__)
#include <immintrin.h>

#include "kernels/softmax_s16_wide.hpp"

namespace sinew {
namespace {

struct SoftmaxAvx2 {
  using Int32 = __m256i;
  struct Reals {
    __m256d low, high;
  };
  static constexpr uint32_t kWidth = 8;

  static SINEW_INLINE __m256i load(const void* from, uint32_t n) {
    int16_t copy[kWidth] = {-1, -1, -1, -1, -1, -1, -1, -1};
    if (n < kWidth) {
      for (uint32_t i = 0; i < n; ++i) copy[i] = static_cast<const int16_t*>(from)[i];
      from = copy;
    }
    return _mm256_cvtepi16_epi32(_mm_loadu_si128(static_cast<const __m128i*>(from)));
  }
  static SINEW_INLINE void store(uint32_t* to, __m256i value, uint32_t n) {
    if (n == kWidth) return _mm256_storeu_si256(static_cast<__m256i*>(static_cast<void*>(to)), value);
    const __m256i mask =
        _mm256_cmpgt_epi32(_mm256_set1_epi32(static_cast<int32_t>(n)), _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7));
    _mm256_maskstore_epi32(static_cast<int32_t*>(static_cast<void*>(to)), mask, value);
  }
  static SINEW_INLINE __m256i all(int32_t value) { return _mm256_set1_epi32(value); }
  static SINEW_INLINE __m256i subtract(__m256i a, __m256i b) { return _mm256_sub_epi32(a, b); }
  static SINEW_INLINE __m256i larger(__m256i a, __m256i b) { return _mm256_max_epi32(a, b); }
  static SINEW_INLINE int32_t largest(__m256i a) {
    const __m128i four = _mm_max_epi32(_mm256_castsi256_si128(a), _mm256_extracti128_si256(a, 1));
    const __m128i two = _mm_max_epi32(four, _mm_shuffle_epi32(four, 0x4E));
    return _mm_cvtsi128_si32(_mm_max_epi32(two, _mm_shuffle_epi32(two, 0xB1)));
  }
  static SINEW_INLINE __m256i present(__m256i logits, __m256i joints) {
    return _mm256_blendv_epi8(logits, all(kAbsentLogit), _mm256_cmpeq_epi32(joints, all(-1)));
  }

  static SINEW_INLINE Reals add(Reals a, Reals b) {
    return {_mm256_add_pd(a.low, b.low), _mm256_add_pd(a.high, b.high)};
  }
  static SINEW_INLINE double sum(Reals a) {
    const __m256d four = _mm256_add_pd(a.low, a.high);
    const __m128d two = _mm_add_pd(_mm256_castpd256_pd128(four), _mm256_extractf128_pd(four, 1));
    return _mm_cvtsd_f64(_mm_add_sd(two, _mm_unpackhi_pd(two, two)));
  }
  // An entry of the table and the next one in 64 bits.
  static SINEW_INLINE __m256 pairs(__m128i steps) {
    const long long* const table = static_cast<const long long*>(static_cast<const void*>(kPowers.q30));
    return _mm256_castsi256_ps(_mm256_i32gather_epi64(table, steps, sizeof(kPowers.q30[0])));
  }
  static SINEW_INLINE __m256i in_order(__m256 a) { return _mm256_permute4x64_epi64(_mm256_castps_si256(a), 0xD8); }
  static SINEW_INLINE Reals powers(__m256i d) {
    const __m256i steps = _mm256_and_si256(_mm256_srli_epi32(d, kFineBits), all(kSteps - 1));
    const __m256i fine = _mm256_and_si256(d, all((1 << kFineBits) - 1));
    const __m256 low = pairs(_mm256_castsi256_si128(steps)), high = pairs(_mm256_extracti128_si256(steps, 1));
    const __m256i value = in_order(_mm256_shuffle_ps(low, high, 0x88));
    const __m256i drop = subtract(value, in_order(_mm256_shuffle_ps(low, high, 0xDD)));
    const __m256i between = subtract(value, _mm256_srli_epi32(_mm256_mullo_epi32(drop, fine), kFineBits));
    const __m256i power = _mm256_srlv_epi32(between, _mm256_srli_epi32(d, 10));
    return {_mm256_cvtepi32_pd(_mm256_castsi256_si128(power)), _mm256_cvtepi32_pd(_mm256_extracti128_si256(power, 1))};
  }
  static SINEW_INLINE __m128i quotient(__m256d x, double offset, double factor) {
    const __m256d dividend = _mm256_add_pd(_mm256_mul_pd(x, _mm256_set1_pd(65536.0)), _mm256_set1_pd(offset));
    return _mm256_cvttpd_epi32(_mm256_mul_pd(dividend, _mm256_set1_pd(factor)));
  }
  static SINEW_INLINE __m256i quotients(Reals x, double offset, double factor) {
    return _mm256_set_m128i(quotient(x.high, offset, factor), quotient(x.low, offset, factor));
  }
  static SINEW_INLINE __m256i at_least(__m256i a, uint32_t smallest) {
    return _mm256_andnot_si256(_mm256_cmpgt_epi32(all(static_cast<int32_t>(smallest)), a), a);
  }
};

}  // namespace

bool add_softmax_s16_avx2(SoftmaxKernel* kernel) {
  *kernel = softmax<SoftmaxAvx2>;
  return true;
}

}  // namespace sinew
#else
namespace sinew {
bool add_softmax_s16_avx2(SoftmaxKernel*) { return false; }
}  // namespace sinew
#endif
