// SPDX-License-Identifier: MIT
// Softmax with AVX-512, eight candidates at a time: their doubles fill one register. Sixteen at a time took two to
// three times as long.
#include "kernels/softmax.hpp"

#if defined(__AVX512F__) && defined(__AVX512BW__) && defined(__AVX512VL__)
#include <immintrin.h>

#include "kernels/softmax_s16_wide.hpp"

namespace sinew {
namespace {

struct SoftmaxAvx512 {
  using Int32 = __m256i;
  using Reals = __m512d;
  static constexpr uint32_t kWidth = 8;

  static SINEW_INLINE __mmask8 first(uint32_t n) { return static_cast<__mmask8>((1u << n) - 1); }
  static SINEW_INLINE __m256i load(const void* from, uint32_t n) {
    const __m128i* const row = static_cast<const __m128i*>(from);
    return _mm256_cvtepi16_epi32(n == kWidth ? _mm_loadu_si128(row)
                                             : _mm_mask_loadu_epi16(_mm_set1_epi16(-1), first(n), row));
  }
  static SINEW_INLINE void store(uint32_t* to, __m256i value, uint32_t n) {
    if (n == kWidth) return _mm256_storeu_si256(static_cast<__m256i*>(static_cast<void*>(to)), value);
    _mm256_mask_storeu_epi32(to, first(n), value);
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
    return _mm256_mask_mov_epi32(logits, _mm256_cmpeq_epi32_mask(joints, all(-1)), all(kAbsentLogit));
  }

  static SINEW_INLINE __m512d add(__m512d a, __m512d b) { return _mm512_add_pd(a, b); }
  static SINEW_INLINE double sum(__m512d a) { return _mm512_reduce_add_pd(a); }
  static SINEW_INLINE __m512d powers(__m256i d) {
    const __m256i steps = _mm256_and_si256(_mm256_srli_epi32(d, kFineBits), all(kSteps - 1));
    const __m256i fine = _mm256_and_si256(d, all((1 << kFineBits) - 1));
    // An entry of the table and the next one in 64 bits.
    const __m512i pairs = _mm512_i32gather_epi64(steps, kPowers.q30, sizeof(kPowers.q30[0]));
    const __m256i value = _mm512_cvtepi64_epi32(pairs);
    const __m256i drop = subtract(value, _mm512_cvtepi64_epi32(_mm512_srli_epi64(pairs, 32)));
    const __m256i between = subtract(value, _mm256_srli_epi32(_mm256_mullo_epi32(drop, fine), kFineBits));
    return _mm512_cvtepi32_pd(_mm256_srlv_epi32(between, _mm256_srli_epi32(d, 10)));
  }
  static SINEW_INLINE __m256i quotients(__m512d x, double offset, double factor) {
    const __m512d dividend = _mm512_add_pd(_mm512_mul_pd(x, _mm512_set1_pd(65536.0)), _mm512_set1_pd(offset));
    return _mm512_cvttpd_epi32(_mm512_mul_pd(dividend, _mm512_set1_pd(factor)));
  }
  static SINEW_INLINE __m256i at_least(__m256i a, uint32_t smallest) {
    return _mm256_maskz_mov_epi32(_mm256_cmpge_epi32_mask(a, all(static_cast<int32_t>(smallest))), a);
  }
};

}  // namespace

bool add_softmax_s16_avx512(SoftmaxKernel* kernel) {
  *kernel = softmax<SoftmaxAvx512>;
  return true;
}

}  // namespace sinew
#else
namespace sinew {
bool add_softmax_s16_avx512(SoftmaxKernel*) { return false; }
}  // namespace sinew
#endif
