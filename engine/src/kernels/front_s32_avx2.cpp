// SPDX-License-Identifier: MIT
// The factorisation's inner loops with AVX2: vpmuldq on the even and the odd int32 of a register.
#include "kernels/front.hpp"

#if defined(__AVX2__)
#include <immintrin.h>

#include "kernels/isolated.hpp"

namespace sinew {
namespace {

SINEW_INLINE __m256i load(const int32_t* from) {
  return _mm256_loadu_si256(static_cast<const __m256i*>(static_cast<const void*>(from)));
}
SINEW_INLINE void store(void* to, __m256i value) { _mm256_storeu_si256(static_cast<__m256i*>(to), value); }
SINEW_INLINE __m256i odd_half(__m256i v) { return _mm256_srli_epi64(v, 32); }

// The low 32 bits of (sum + half) >> kFrontBits; no arithmetic shift is needed for them.
SINEW_INLINE __m256i rounded(__m256i even, __m256i odd) {
  const __m256i half = _mm256_set1_epi64x(1 << (kFrontBits - 1));
  const __m256i low = _mm256_srli_epi64(_mm256_add_epi64(even, half), kFrontBits);
  const __m256i high = _mm256_slli_epi64(_mm256_add_epi64(odd, half), 32 - kFrontBits);
  return _mm256_blend_epi32(low, high, 0xAA);
}

template <uint32_t kColumns>
SINEW_INLINE void update(const int32_t* g, size_t stride, uint32_t pivots, uint32_t rows, int32_t* target,
                         size_t target_stride) {
  uint32_t i = 0;
  for (; i + 8 <= rows; i += 8) {
    __m256i even[kColumns], odd[kColumns];
    SINEW_UNROLL
    for (uint32_t c = 0; c < kColumns; ++c) even[c] = odd[c] = _mm256_setzero_si256();
    const int32_t* column = g;
    for (uint32_t k = 0; k < pivots; ++k, column += stride) {
      const __m256i values = load(column + i);
      const __m256i others = odd_half(values);
      SINEW_UNROLL
      for (uint32_t c = 0; c < kColumns; ++c) {
        const __m256i factor = _mm256_set1_epi32(column[c]);
        even[c] = _mm256_add_epi64(even[c], _mm256_mul_epi32(values, factor));
        odd[c] = _mm256_add_epi64(odd[c], _mm256_mul_epi32(others, factor));
      }
    }
    SINEW_UNROLL
    for (uint32_t c = 0; c < kColumns; ++c) {
      int32_t* const out = target + c * target_stride + i;
      store(out, _mm256_sub_epi32(load(out), rounded(even[c], odd[c])));
    }
  }
  if (i == rows) return;
  const uint32_t left = rows - i;
  const __m256i mask =
      _mm256_cmpgt_epi32(_mm256_set1_epi32(static_cast<int32_t>(left)), _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7));
  __m256i even[kColumns], odd[kColumns];
  SINEW_UNROLL
  for (uint32_t c = 0; c < kColumns; ++c) even[c] = odd[c] = _mm256_setzero_si256();
  const int32_t* column = g;
  for (uint32_t k = 0; k < pivots; ++k, column += stride) {
    const __m256i values = _mm256_maskload_epi32(column + i, mask);
    const __m256i others = odd_half(values);
    SINEW_UNROLL
    for (uint32_t c = 0; c < kColumns; ++c) {
      const __m256i factor = _mm256_set1_epi32(column[c]);
      even[c] = _mm256_add_epi64(even[c], _mm256_mul_epi32(values, factor));
      odd[c] = _mm256_add_epi64(odd[c], _mm256_mul_epi32(others, factor));
    }
  }
  SINEW_UNROLL
  for (uint32_t c = 0; c < kColumns; ++c) {
    int32_t* const out = target + c * target_stride + i;
    _mm256_maskstore_epi32(out, mask, _mm256_sub_epi32(_mm256_maskload_epi32(out, mask), rounded(even[c], odd[c])));
  }
}

void front_update_avx2(const int32_t* g, size_t stride, uint32_t pivots, uint32_t columns, uint32_t rows,
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

// Eight of the lanes: sums of more would not fit the registers.
SINEW_INLINE void add_lanes(const int32_t* g, size_t next, size_t step, uint32_t terms, const int32_t* lanes,
                            int64_t* sums) {
  __m256i even[kFrontColumns], odd[kFrontColumns];
  SINEW_UNROLL
  for (uint32_t c = 0; c < kFrontColumns; ++c) even[c] = odd[c] = _mm256_setzero_si256();
  for (uint32_t t = 0; t < terms; ++t, g += step, lanes += kFrontLanes) {
    const __m256i values = load(lanes);
    const __m256i others = odd_half(values);
    SINEW_UNROLL
    for (uint32_t c = 0; c < kFrontColumns; ++c) {
      const __m256i factor = _mm256_set1_epi32(g[c * next]);
      even[c] = _mm256_add_epi64(even[c], _mm256_mul_epi32(values, factor));
      odd[c] = _mm256_add_epi64(odd[c], _mm256_mul_epi32(others, factor));
    }
  }
  SINEW_UNROLL
  for (uint32_t c = 0; c < kFrontColumns; ++c) {
    const __m256i low = _mm256_unpacklo_epi64(even[c], odd[c]), high = _mm256_unpackhi_epi64(even[c], odd[c]);
    store(sums + c * kFrontLanes, _mm256_permute2x128_si256(low, high, 0x20));
    store(sums + c * kFrontLanes + 4, _mm256_permute2x128_si256(low, high, 0x31));
  }
}

void front_lanes_avx2(const int32_t* g, size_t next, size_t step, uint32_t terms, const int32_t* lanes, int64_t* sums) {
  for (uint32_t lane = 0; lane < kFrontLanes; lane += 8) add_lanes(g, next, step, terms, lanes + lane, sums + lane);
}

}  // namespace

bool add_front_s32_avx2(FrontKernels* kernels) {
  kernels->update = front_update_avx2;
  kernels->lanes = front_lanes_avx2;
  return true;
}

}  // namespace sinew

#else

namespace sinew {

bool add_front_s32_avx2(FrontKernels*) { return false; }

}  // namespace sinew

#endif
