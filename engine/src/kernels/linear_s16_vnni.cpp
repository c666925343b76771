// SPDX-License-Identifier: MIT
// The linear layer with AVX-512 VNNI: vpdpwssd on 16 outputs at a time.
#include "kernels/variants.hpp"

#if defined(__AVX512VNNI__) && defined(__AVX512BW__) && defined(__AVX512VL__)
#include <immintrin.h>

#include "kernels/linear_s16_tiles.hpp"

namespace sinew {
namespace {

struct Vnni {
  using Int32 = __m512i;
  using Pairs = __m512i;
  static constexpr int kWidth = 16, kGroups = 4, kFinish = 2;
  // Sums, weights and an input in 32 registers. On Zen 5 tiles of 8 x 3 and 12 x 2 run at half the speed of 7 x 3 and
  // 10 x 2, although the loops differ in nothing else.
  static constexpr int kRows[kGroups + 1] = {0, 8, 10, 7, 6};

  static SINEW_INLINE Int32 zero() { return _mm512_setzero_si512(); }
  static SINEW_INLINE Int32 load(const int32_t* from) { return _mm512_loadu_si512(from); }
  static SINEW_INLINE void store(int32_t* to, Int32 value) { _mm512_storeu_si512(to, value); }
  static SINEW_INLINE Int32 add(Int32 a, Int32 b) { return _mm512_add_epi32(a, b); }
  static SINEW_INLINE Pairs broadcast(int32_t pair) { return _mm512_set1_epi32(pair); }
  static SINEW_INLINE Pairs load_pairs(const int16_t* from) { return _mm512_load_si512(from); }
  static SINEW_INLINE Int32 dot(Int32 sum, Pairs weights, Pairs input) {
#if defined(__GNUC__)
    // As an intrinsic GCC 12 may copy the sums between registers or spill them; this ties them down.
    __asm__("vpdpwssd %2, %1, %0" : "+v"(sum) : "v"(weights), "v"(input));
    return sum;
#else
    return _mm512_dpwssd_epi32(sum, weights, input);
#endif
  }
  static SINEW_INLINE __m512i requantize(__m512i sum, const int32_t* shifts, const int32_t* factors, __m256i residual) {
    if (factors != nullptr) {
      sum = _mm512_add_epi32(sum, _mm512_mullo_epi32(_mm512_cvtepi16_epi32(residual), load(factors)));
    }
    return _mm512_srav_epi32(sum, load(shifts));
  }
  static SINEW_INLINE void finish(const Int32* sums, const int32_t* shifts, const int32_t* factors,
                                  const int16_t* residual, int32_t low, int32_t high, uint32_t count, int16_t* out) {
    const __mmask32 mask = count >= 32 ? ~0u : (1u << count) - 1u;
    __m512i values = _mm512_setzero_si512();
    if (factors != nullptr) values = _mm512_maskz_loadu_epi16(mask, residual);
    const __m512i a = requantize(sums[0], shifts, factors, _mm512_castsi512_si256(values));
    const __m512i b = requantize(sums[1], shifts + 16, factors == nullptr ? nullptr : factors + 16,
                                 _mm512_extracti64x4_epi64(values, 1));
    // The clamp lies inside int16, so a saturating pack may come first; then quarters go back in order.
    __m512i both = _mm512_packs_epi32(a, b);
    both = _mm512_max_epi16(both, _mm512_set1_epi16(static_cast<int16_t>(low)));
    both = _mm512_min_epi16(both, _mm512_set1_epi16(static_cast<int16_t>(high)));
    both = _mm512_permutexvar_epi64(_mm512_setr_epi64(0, 2, 4, 6, 1, 3, 5, 7), both);
    if (count >= 32) {
      _mm512_storeu_si512(out, both);
    } else {
      _mm512_mask_storeu_epi16(out, mask, both);
    }
  }
};

void linear_s16_vnni(const LinearView& linear, RowsView in, RowsView residual, const uint16_t* present, uint32_t rows,
                     int16_t* out, uint32_t out_stride) {
  linear_tiled<Vnni>(linear, in.data, in.stride, residual.data, residual.stride, present, rows, out, out_stride);
}

void linear_sums_s16_vnni(const LinearView& linear, RowsView in, uint32_t rows, int32_t* sums) {
  linear_sums_tiled<Vnni>(linear, in.data, in.stride, rows, sums);
}

}  // namespace

bool add_linear_s16_vnni(Kernels* kernels) {
  kernels->linear_packed = linear_s16_vnni;
  kernels->linear_sums = linear_sums_s16_vnni;
  return true;
}

}  // namespace sinew
#else
namespace sinew {
bool add_linear_s16_vnni(Kernels*) { return false; }
}  // namespace sinew
#endif
