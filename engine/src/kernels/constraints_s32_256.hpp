// SPDX-License-Identifier: MIT
// Four constraints at once in registers of 256 bits: what constraints_s32_wide.hpp asks for.
#ifndef SINEW_KERNELS_CONSTRAINTS_S32_256_HPP
#define SINEW_KERNELS_CONSTRAINTS_S32_256_HPP

#include <immintrin.h>

#include "kernels/constraints_s32_wide.hpp"

namespace sinew {
namespace {

struct Constraints256 {
  static constexpr uint32_t kWidth = 4, kLanes = 15;
  static constexpr uint8_t kRunFlag = kRunOfFour;
  using Real = __m256d;
  using Int = __m128i;
  using Mask = __m256d;

  SINEW_INLINE static Real all(double x) { return _mm256_set1_pd(x); }
  SINEW_INLINE static Real add(Real a, Real b) { return _mm256_add_pd(a, b); }
  SINEW_INLINE static Real subtract(Real a, Real b) { return _mm256_sub_pd(a, b); }
  SINEW_INLINE static Real times(Real a, Real b) { return _mm256_mul_pd(a, b); }
  SINEW_INLINE static Real divide(Real a, Real b) { return _mm256_div_pd(a, b); }
  SINEW_INLINE static Real root(Real a) { return _mm256_sqrt_pd(a); }
  SINEW_INLINE static Real floored(Real a) { return _mm256_floor_pd(a); }
  SINEW_INLINE static Real cut(Real a) { return _mm256_round_pd(a, _MM_FROUND_TO_ZERO | _MM_FROUND_NO_EXC); }
  SINEW_INLINE static Real magnitude(Real a) { return _mm256_andnot_pd(all(-0.0), a); }
  SINEW_INLINE static Real larger(Real a, Real b) { return _mm256_max_pd(a, b); }

  SINEW_INLINE static Int load(const int32_t* from) { return _mm_loadu_si128(reinterpret_cast<const __m128i*>(from)); }
  SINEW_INLINE static void store(int32_t* to, Int a) { _mm_storeu_si128(reinterpret_cast<__m128i*>(to), a); }
  SINEW_INLINE static Int sum(Int a, Int b) { return _mm_add_epi32(a, b); }
  SINEW_INLINE static Int difference(Int a, Int b) { return _mm_sub_epi32(a, b); }
  SINEW_INLINE static Int within(Int a, int32_t most) {
    return _mm_max_epi32(_mm_min_epi32(a, _mm_set1_epi32(most)), _mm_set1_epi32(-most));
  }
  SINEW_INLINE static Int whole(Real a) { return _mm256_cvttpd_epi32(a); }
  SINEW_INLINE static Real real(Int a) { return _mm256_cvtepi32_pd(a); }

  SINEW_INLINE static Mask less(Real a, Real b) { return _mm256_cmp_pd(a, b, _CMP_LT_OQ); }
  SINEW_INLINE static Mask at_least(Real a, Real b) { return _mm256_cmp_pd(a, b, _CMP_GE_OQ); }
  SINEW_INLINE static Mask both(Mask a, Mask b) { return _mm256_and_pd(a, b); }
  SINEW_INLINE static Mask of_moves(Int moves) { return _mm256_castsi256_pd(_mm256_cvtepi32_epi64(moves)); }
  SINEW_INLINE static Mask of_both_moves(Int a, Int b) { return of_moves(_mm_and_si128(a, b)); }
  SINEW_INLINE static uint32_t bits(Mask mask) { return static_cast<uint32_t>(_mm256_movemask_pd(mask)); }
  SINEW_INLINE static Real where(Mask mask, Real a) { return _mm256_and_pd(mask, a); }
  SINEW_INLINE static Int where(Mask mask, Int a) {
    const __m128 low = _mm_castpd_ps(_mm256_castpd256_pd128(mask)),
                 high = _mm_castpd_ps(_mm256_extractf128_pd(mask, 1));
    return _mm_and_si128(_mm_castps_si128(_mm_shuffle_ps(low, high, 0x88)), a);
  }
  SINEW_INLINE static Real either(Mask mask, Real a, Real b) { return _mm256_blendv_pd(b, a, mask); }

  SINEW_INLINE static __m128i load_node(const SolverNode* nodes, uint32_t n) {
    return _mm_load_si128(reinterpret_cast<const __m128i*>(nodes + n));
  }
  SINEW_INLINE static void store_node(SolverNode* nodes, uint32_t n, __m128i node) {
    _mm_store_si128(reinterpret_cast<__m128i*>(nodes + n), node);
  }
  template <int N>
  SINEW_INLINE static void load_nodes(const SolverNode* nodes, const uint32_t* at, Int* x, Int* y, Int* z, Int* moves) {
    const __m128i a = load_node(nodes, at[0]), b = load_node(nodes, at[N]), c = load_node(nodes, at[2 * N]),
                  d = load_node(nodes, at[3 * N]);
    const __m128i ab = _mm_unpacklo_epi32(a, b), cd = _mm_unpacklo_epi32(c, d), high_ab = _mm_unpackhi_epi32(a, b),
                  high_cd = _mm_unpackhi_epi32(c, d);
    *x = _mm_unpacklo_epi64(ab, cd);
    *y = _mm_unpackhi_epi64(ab, cd);
    *z = _mm_unpacklo_epi64(high_ab, high_cd);
    *moves = _mm_unpackhi_epi64(high_ab, high_cd);
  }
  template <int N>
  SINEW_INLINE static void store_nodes(Int x, Int y, Int z, Int moves, const uint32_t* at, SolverNode* nodes) {
    const __m128i xy = _mm_unpacklo_epi32(x, y), high_xy = _mm_unpackhi_epi32(x, y), zm = _mm_unpacklo_epi32(z, moves),
                  high_zm = _mm_unpackhi_epi32(z, moves);
    store_node(nodes, at[0], _mm_unpacklo_epi64(xy, zm));
    store_node(nodes, at[N], _mm_unpackhi_epi64(xy, zm));
    store_node(nodes, at[2 * N], _mm_unpacklo_epi64(high_xy, high_zm));
    store_node(nodes, at[3 * N], _mm_unpackhi_epi64(high_xy, high_zm));
  }
};

}  // namespace
}  // namespace sinew
#endif
