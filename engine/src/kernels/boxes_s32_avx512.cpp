// SPDX-License-Identifier: MIT
// A segment against sixteen boxes with AVX-512, all at once.
#include "kernels/boxes.hpp"

#if defined(__AVX512F__) && defined(__AVX512DQ__)
#include <immintrin.h>

#include "kernels/boxes_s32_wide.hpp"

namespace sinew {
namespace {

struct BoxesAvx512 {
  using Int32 = __m512i;
  struct Int64 {
    __m512i even, odd;
  };
  static constexpr uint32_t kWidth = 16;

  static SINEW_INLINE __m512i load(const int32_t* from) { return _mm512_loadu_si512(from); }
  static SINEW_INLINE __m512i all(int32_t value) { return _mm512_set1_epi32(value); }
  static SINEW_INLINE __m512i add(__m512i a, __m512i b) { return _mm512_add_epi32(a, b); }
  static SINEW_INLINE __m512i subtract(__m512i a, __m512i b) { return _mm512_sub_epi32(a, b); }
  static SINEW_INLINE __m512i either(__m512i a, __m512i b) { return _mm512_or_si512(a, b); }

  static SINEW_INLINE Int64 products(__m512i a, __m512i b) {
    return {_mm512_mul_epi32(a, b), _mm512_mul_epi32(_mm512_srli_epi64(a, 32), b)};
  }
  static SINEW_INLINE Int64 add(Int64 a, Int64 b) {
    return {_mm512_add_epi64(a.even, b.even), _mm512_add_epi64(a.odd, b.odd)};
  }
  static SINEW_INLINE Int64 subtract(Int64 a, Int64 b) {
    return {_mm512_sub_epi64(a.even, b.even), _mm512_sub_epi64(a.odd, b.odd)};
  }
  static SINEW_INLINE Int64 either(Int64 a, Int64 b) { return {either(a.even, b.even), either(a.odd, b.odd)}; }

  static SINEW_INLINE uint32_t signs(__m512i a, Int64 b) {
    const __m512i high_halves = _mm512_mask_blend_epi32(0xAAAA, _mm512_srli_epi64(b.even, 32), b.odd);
    return _mm512_movepi32_mask(either(a, high_halves));
  }
};

}  // namespace

bool add_boxes_s32_avx512(BoxKernel* kernel) {
  *kernel = boxes_met_in<BoxesAvx512>;
  return true;
}

}  // namespace sinew
#else
namespace sinew {
bool add_boxes_s32_avx512(BoxKernel*) { return false; }
}  // namespace sinew
#endif
