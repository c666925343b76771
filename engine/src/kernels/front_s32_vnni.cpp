// SPDX-License-Identifier: MIT
// The factorisation's inner loops with AVX-512: vpmuldq on the even and the odd int32 of a register.
#include "kernels/front.hpp"

#if defined(__AVX512F__)
#include <immintrin.h>

#include "kernels/isolated.hpp"

namespace sinew {
namespace {

// The low 32 bits of (sum + half) >> kFrontBits; no arithmetic shift is needed for them.
SINEW_INLINE __m512i rounded(__m512i even, __m512i odd) {
  const __m512i half = _mm512_set1_epi64(1 << (kFrontBits - 1));
  const __m512i low = _mm512_srli_epi64(_mm512_add_epi64(even, half), kFrontBits);
  const __m512i high = _mm512_slli_epi64(_mm512_add_epi64(odd, half), 32 - kFrontBits);
  return _mm512_mask_blend_epi32(0xAAAA, low, high);
}

template <uint32_t kColumns>
SINEW_INLINE void update(const int32_t* g, size_t stride, uint32_t pivots, uint32_t rows, int32_t* target,
                         size_t target_stride) {
  for (uint32_t i = 0; i < rows; i += 16) {
    const uint32_t left = rows - i;
    const __mmask16 mask = static_cast<__mmask16>(left < 16 ? (1u << left) - 1 : 0xFFFF);
    __m512i even[kColumns], odd[kColumns];
    SINEW_UNROLL
    for (uint32_t c = 0; c < kColumns; ++c) even[c] = odd[c] = _mm512_setzero_si512();
    const int32_t* column = g;
    for (uint32_t k = 0; k < pivots; ++k, column += stride) {
      const __m512i values = _mm512_maskz_loadu_epi32(mask, column + i);
      const __m512i others = _mm512_srli_epi64(values, 32);
      SINEW_UNROLL
      for (uint32_t c = 0; c < kColumns; ++c) {
        const __m512i factor = _mm512_set1_epi32(column[c]);
        even[c] = _mm512_add_epi64(even[c], _mm512_mul_epi32(values, factor));
        odd[c] = _mm512_add_epi64(odd[c], _mm512_mul_epi32(others, factor));
      }
    }
    SINEW_UNROLL
    for (uint32_t c = 0; c < kColumns; ++c) {
      int32_t* const out = target + c * target_stride + i;
      _mm512_mask_storeu_epi32(out, mask,
                               _mm512_sub_epi32(_mm512_maskz_loadu_epi32(mask, out), rounded(even[c], odd[c])));
    }
  }
}

void front_update_vnni(const int32_t* g, size_t stride, uint32_t pivots, uint32_t columns, uint32_t rows,
                       int32_t* target, size_t target_stride) {
  switch (columns) {
    case 4:
      return update<4>(g, stride, pivots, rows, target, target_stride);
    case 3:
      return update<3>(g, stride, pivots, rows, target, target_stride);
    case 2:
      return update<2>(g, stride, pivots, rows, target, target_stride);
    default:
      return update<1>(g, stride, pivots, rows, target, target_stride);
  }
}

void front_lanes_vnni(const int32_t* g, size_t next, size_t step, uint32_t terms, const int32_t* lanes, int64_t* sums) {
  __m512i even[kFrontColumns], odd[kFrontColumns];
  SINEW_UNROLL
  for (uint32_t c = 0; c < kFrontColumns; ++c) even[c] = odd[c] = _mm512_setzero_si512();
  for (uint32_t t = 0; t < terms; ++t, g += step, lanes += kFrontLanes) {
    const __m512i values = _mm512_loadu_si512(lanes);
    const __m512i others = _mm512_srli_epi64(values, 32);
    SINEW_UNROLL
    for (uint32_t c = 0; c < kFrontColumns; ++c) {
      const __m512i factor = _mm512_set1_epi32(g[c * next]);
      even[c] = _mm512_add_epi64(even[c], _mm512_mul_epi32(values, factor));
      odd[c] = _mm512_add_epi64(odd[c], _mm512_mul_epi32(others, factor));
    }
  }
  const __m512i first = _mm512_setr_epi64(0, 8, 1, 9, 2, 10, 3, 11),
                second = _mm512_setr_epi64(4, 12, 5, 13, 6, 14, 7, 15);
  SINEW_UNROLL
  for (uint32_t c = 0; c < kFrontColumns; ++c) {
    _mm512_storeu_si512(sums + c * kFrontLanes, _mm512_permutex2var_epi64(even[c], first, odd[c]));
    _mm512_storeu_si512(sums + c * kFrontLanes + 8, _mm512_permutex2var_epi64(even[c], second, odd[c]));
  }
}

}  // namespace

bool add_front_s32_vnni(FrontKernels* kernels) {
  kernels->update = front_update_vnni;
  kernels->lanes = front_lanes_vnni;
  return true;
}

}  // namespace sinew

#else

namespace sinew {

bool add_front_s32_vnni(FrontKernels*) { return false; }

}  // namespace sinew

#endif
