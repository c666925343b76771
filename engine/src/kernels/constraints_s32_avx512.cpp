// SPDX-License-Identifier: MIT
// Eight soft edges or eight hard volumes at once with AVX-512, and four where a run has no more.
#include "kernels/constraints.hpp"

#if defined(__AVX512F__) && defined(__AVX512DQ__) && defined(__AVX512VL__)
#include "kernels/constraints_s32_256.hpp"

namespace sinew {
namespace {

struct Constraints512 {
  static constexpr uint32_t kWidth = 8, kLanes = 255;
  static constexpr uint8_t kRunFlag = kRunOfEight;
  using Real = __m512d;
  using Int = __m256i;
  using Mask = __mmask8;

  SINEW_INLINE static Real all(double x) { return _mm512_set1_pd(x); }
  SINEW_INLINE static Real add(Real a, Real b) { return _mm512_add_pd(a, b); }
  SINEW_INLINE static Real subtract(Real a, Real b) { return _mm512_sub_pd(a, b); }
  SINEW_INLINE static Real times(Real a, Real b) { return _mm512_mul_pd(a, b); }
  SINEW_INLINE static Real divide(Real a, Real b) { return _mm512_div_pd(a, b); }
  SINEW_INLINE static Real root(Real a) { return _mm512_sqrt_pd(a); }
  SINEW_INLINE static Real floored(Real a) {
    return _mm512_roundscale_pd(a, _MM_FROUND_TO_NEG_INF | _MM_FROUND_NO_EXC);
  }
  SINEW_INLINE static Real cut(Real a) { return _mm512_roundscale_pd(a, _MM_FROUND_TO_ZERO | _MM_FROUND_NO_EXC); }
  SINEW_INLINE static Real magnitude(Real a) { return _mm512_abs_pd(a); }
  SINEW_INLINE static Real larger(Real a, Real b) { return _mm512_max_pd(a, b); }

  SINEW_INLINE static Int load(const int32_t* from) {
    return _mm256_loadu_si256(reinterpret_cast<const __m256i*>(from));
  }
  SINEW_INLINE static void store(int32_t* to, Int a) { _mm256_storeu_si256(reinterpret_cast<__m256i*>(to), a); }
  SINEW_INLINE static Int sum(Int a, Int b) { return _mm256_add_epi32(a, b); }
  SINEW_INLINE static Int difference(Int a, Int b) { return _mm256_sub_epi32(a, b); }
  SINEW_INLINE static Int within(Int a, int32_t most) {
    return _mm256_max_epi32(_mm256_min_epi32(a, _mm256_set1_epi32(most)), _mm256_set1_epi32(-most));
  }
  SINEW_INLINE static Int whole(Real a) { return _mm512_cvttpd_epi32(a); }
  SINEW_INLINE static Real real(Int a) { return _mm512_cvtepi32_pd(a); }

  SINEW_INLINE static Mask less(Real a, Real b) { return _mm512_cmp_pd_mask(a, b, _CMP_LT_OQ); }
  SINEW_INLINE static Mask at_least(Real a, Real b) { return _mm512_cmp_pd_mask(a, b, _CMP_GE_OQ); }
  SINEW_INLINE static Mask both(Mask a, Mask b) { return static_cast<Mask>(a & b); }
  SINEW_INLINE static Mask of_moves(Int moves) { return _mm256_movepi32_mask(moves); }
  SINEW_INLINE static Mask of_both_moves(Int a, Int b) { return both(of_moves(a), of_moves(b)); }
  SINEW_INLINE static uint32_t bits(Mask mask) { return mask; }
  SINEW_INLINE static Real where(Mask mask, Real a) { return _mm512_maskz_mov_pd(mask, a); }
  SINEW_INLINE static Int where(Mask mask, Int a) { return _mm256_maskz_mov_epi32(mask, a); }
  SINEW_INLINE static Real either(Mask mask, Real a, Real b) { return _mm512_mask_blend_pd(mask, b, a); }

  // The node of a lane, and that of the lane four further on.
  SINEW_INLINE static __m256i load_two(const SolverNode* nodes, uint32_t low, uint32_t high) {
    return _mm256_inserti128_si256(_mm256_castsi128_si256(Constraints256::load_node(nodes, low)),
                                   Constraints256::load_node(nodes, high), 1);
  }
  SINEW_INLINE static void store_two(SolverNode* nodes, uint32_t low, uint32_t high, __m256i two) {
    Constraints256::store_node(nodes, low, _mm256_castsi256_si128(two));
    Constraints256::store_node(nodes, high, _mm256_extracti128_si256(two, 1));
  }
  template <int N>
  SINEW_INLINE static void load_nodes(const SolverNode* nodes, const uint32_t* at, Int* x, Int* y, Int* z, Int* moves) {
    const __m256i a = load_two(nodes, at[0], at[4 * N]), b = load_two(nodes, at[N], at[5 * N]),
                  c = load_two(nodes, at[2 * N], at[6 * N]), d = load_two(nodes, at[3 * N], at[7 * N]);
    const __m256i ab = _mm256_unpacklo_epi32(a, b), cd = _mm256_unpacklo_epi32(c, d),
                  high_ab = _mm256_unpackhi_epi32(a, b), high_cd = _mm256_unpackhi_epi32(c, d);
    *x = _mm256_unpacklo_epi64(ab, cd);
    *y = _mm256_unpackhi_epi64(ab, cd);
    *z = _mm256_unpacklo_epi64(high_ab, high_cd);
    *moves = _mm256_unpackhi_epi64(high_ab, high_cd);
  }
  template <int N>
  SINEW_INLINE static void store_nodes(Int x, Int y, Int z, Int moves, const uint32_t* at, SolverNode* nodes) {
    const __m256i xy = _mm256_unpacklo_epi32(x, y), high_xy = _mm256_unpackhi_epi32(x, y),
                  zm = _mm256_unpacklo_epi32(z, moves), high_zm = _mm256_unpackhi_epi32(z, moves);
    store_two(nodes, at[0], at[4 * N], _mm256_unpacklo_epi64(xy, zm));
    store_two(nodes, at[N], at[5 * N], _mm256_unpackhi_epi64(xy, zm));
    store_two(nodes, at[2 * N], at[6 * N], _mm256_unpacklo_epi64(high_xy, high_zm));
    store_two(nodes, at[3 * N], at[7 * N], _mm256_unpackhi_epi64(high_xy, high_zm));
  }
};

}  // namespace

bool add_constraints_s32_avx512(ConstraintKernels* kernels) {
  kernels->edges = solve_edges<Constraints512, Constraints256>;
  kernels->volumes = solve_volumes<Constraints512, Constraints256>;
  return true;
}

}  // namespace sinew
#else
namespace sinew {
bool add_constraints_s32_avx512(ConstraintKernels*) { return false; }
}  // namespace sinew
#endif
