// SPDX-License-Identifier: MIT
// A segment against sixteen boxes with AVX2, eight at a time.
#include "kernels/boxes.hpp"

#if defined(__AVX2__)
#include <immintrin.h>

#include "kernels/boxes_s32_wide.hpp"

namespace sinew {
namespace {

struct BoxesAvx2 {
  using Int32 = __m256i;
  struct Int64 {
    __m256i even, odd;
  };
  static constexpr uint32_t kWidth = 8;

  static SINEW_INLINE __m256i load(const int32_t* from) {
    return _mm256_loadu_si256(static_cast<const __m256i*>(static_cast<const void*>(from)));
  }
  static SINEW_INLINE __m256i all(int32_t value) { return _mm256_set1_epi32(value); }
  static SINEW_INLINE __m256i add(__m256i a, __m256i b) { return _mm256_add_epi32(a, b); }
  static SINEW_INLINE __m256i subtract(__m256i a, __m256i b) { return _mm256_sub_epi32(a, b); }
  static SINEW_INLINE __m256i either(__m256i a, __m256i b) { return _mm256_or_si256(a, b); }

  static SINEW_INLINE Int64 products(__m256i a, __m256i b) {
    return {_mm256_mul_epi32(a, b), _mm256_mul_epi32(_mm256_srli_epi64(a, 32), b)};
  }
  static SINEW_INLINE Int64 add(Int64 a, Int64 b) {
    return {_mm256_add_epi64(a.even, b.even), _mm256_add_epi64(a.odd, b.odd)};
  }
  static SINEW_INLINE Int64 subtract(Int64 a, Int64 b) {
    return {_mm256_sub_epi64(a.even, b.even), _mm256_sub_epi64(a.odd, b.odd)};
  }
  static SINEW_INLINE Int64 either(Int64 a, Int64 b) { return {either(a.even, b.even), either(a.odd, b.odd)}; }

  static SINEW_INLINE uint32_t signs(__m256i a, Int64 b) {
    const __m256i high_halves = _mm256_blend_epi32(_mm256_srli_epi64(b.even, 32), b.odd, 0xAA);
    return static_cast<uint32_t>(_mm256_movemask_ps(_mm256_castsi256_ps(either(a, high_halves))));
  }
};

}  // namespace

bool add_boxes_s32_avx2(BoxKernel* kernel) {
  *kernel = boxes_met_in<BoxesAvx2>;
  return true;
}

}  // namespace sinew
#else
namespace sinew {
bool add_boxes_s32_avx2(BoxKernel*) { return false; }
}  // namespace sinew
#endif
