// SPDX-License-Identifier: MIT
// Four soft edges or four hard volumes at once with AVX2. Sums and products are integers below 2^53 in doubles, so exact.
// A quotient of two that are below 2^52, cut to an integer, and a root of one, are too, whatever way the processor rounds. Where
// a number may be larger, the reference takes over.
#include "kernels/constraints.hpp"
#include "kernels/isolated.hpp"

#if defined(__AVX2__)
#include <immintrin.h>

namespace sinew {
namespace {

using Double = __m256d;
using Int = __m128i;

SINEW_INLINE Double all(double x) { return _mm256_set1_pd(x); }
SINEW_INLINE Double add(Double a, Double b) { return _mm256_add_pd(a, b); }
SINEW_INLINE Double subtract(Double a, Double b) { return _mm256_sub_pd(a, b); }
SINEW_INLINE Double times(Double a, Double b) { return _mm256_mul_pd(a, b); }
SINEW_INLINE Double magnitude(Double a) { return _mm256_andnot_pd(all(-0.0), a); }
SINEW_INLINE Double cut(Double a) { return _mm256_round_pd(a, _MM_FROUND_TO_ZERO | _MM_FROUND_NO_EXC); }
SINEW_INLINE Double floored(Double a) { return _mm256_floor_pd(a); }
SINEW_INLINE Double less(Double a, Double b) { return _mm256_cmp_pd(a, b, _CMP_LT_OQ); }
SINEW_INLINE Int to_int(Double a) { return _mm256_cvttpd_epi32(a); }
SINEW_INLINE Double to_double(Int a) { return _mm256_cvtepi32_pd(a); }
SINEW_INLINE int bits_of(Double mask) { return _mm256_movemask_pd(mask); }

// Four vectors by axis.
struct Ints {
  Int x, y, z;
};
struct Doubles {
  Double x, y, z;
};
SINEW_INLINE Doubles to_double(Ints v) { return {to_double(v.x), to_double(v.y), to_double(v.z)}; }
SINEW_INLINE Double dot(Doubles a, Doubles b) { return add(add(times(a.x, b.x), times(a.y, b.y)), times(a.z, b.z)); }
SINEW_INLINE Int clamped(Int v, int32_t most) {
  return _mm_max_epi32(_mm_min_epi32(v, _mm_set1_epi32(most)), _mm_set1_epi32(-most));
}
// a - b, clamped
SINEW_INLINE Ints between(Ints a, Ints b, int32_t most) {
  return {clamped(_mm_sub_epi32(a.x, b.x), most), clamped(_mm_sub_epi32(a.y, b.y), most),
          clamped(_mm_sub_epi32(a.z, b.z), most)};
}
// Products over the cell's edge.
SINEW_INLINE Double over_cell(Double a, Double b, Double c, Double d) {
  return floored(times(subtract(times(a, b), times(c, d)), all(1.0 / kCellUnits)));
}
SINEW_INLINE Doubles cross_over_cell(Doubles a, Doubles b) {
  return {over_cell(a.y, b.z, a.z, b.y), over_cell(a.z, b.x, a.x, b.z), over_cell(a.x, b.y, a.y, b.x)};
}

SINEW_INLINE Int load_node(const Vec3i* nodes, uint32_t n) {
  const int32_t* const at = &nodes[n].x;
  return _mm_insert_epi32(_mm_loadl_epi64(reinterpret_cast<const Int*>(at)), at[2], 2);
}
SINEW_INLINE Ints load_nodes(const Vec3i* nodes, const uint32_t* n) {
  const Int a = load_node(nodes, n[0]), b = load_node(nodes, n[1]), c = load_node(nodes, n[2]),
            d = load_node(nodes, n[3]);
  const Int ab = _mm_unpacklo_epi32(a, b), cd = _mm_unpacklo_epi32(c, d);
  return {_mm_unpacklo_epi64(ab, cd), _mm_unpackhi_epi64(ab, cd),
          _mm_unpacklo_epi64(_mm_unpackhi_epi32(a, b), _mm_unpackhi_epi32(c, d))};
}
// Those of the lanes in `mask`.
SINEW_INLINE void store_nodes(Ints v, const uint32_t* n, int mask, Vec3i* nodes) {
  const Int low = _mm_unpacklo_epi32(v.x, v.y), high = _mm_unpackhi_epi32(v.x, v.y);
  const Int pairs[4] = {low, _mm_unpackhi_epi64(low, low), high, _mm_unpackhi_epi64(high, high)};
  const int32_t z[4] = {_mm_cvtsi128_si32(v.z), _mm_extract_epi32(v.z, 1), _mm_extract_epi32(v.z, 2),
                        _mm_extract_epi32(v.z, 3)};
  SINEW_UNROLL for (int lane = 0; lane < 4; ++lane) {
    if ((mask >> lane & 1) == 0) continue;
    int32_t* const at = &nodes[n[lane]].x;
    _mm_storel_epi64(reinterpret_cast<Int*>(at), pairs[lane]);
    at[2] = z[lane];
  }
}
// Bit of a lane: its node moves.
SINEW_INLINE int moving(const uint8_t* moves, const uint32_t* n) {
  return (moves[n[0]] != 0 ? 1 : 0) | (moves[n[1]] != 0 ? 2 : 0) | (moves[n[2]] != 0 ? 4 : 0) |
         (moves[n[3]] != 0 ? 8 : 0);
}
SINEW_INLINE Double mask_of(int bits) {
  const __m256i lanes = _mm256_setr_epi64x(1, 2, 4, 8);
  return _mm256_castsi256_pd(_mm256_cmpeq_epi64(_mm256_and_si256(_mm256_set1_epi64x(bits), lanes), lanes));
}

// x + (ratio * g + half) >> shift
SINEW_INLINE Int stepped(Int x, Double ratio, Double g, int shift) {
  const double half = static_cast<double>(int64_t{1} << (shift - 1)), over = 0.5 / half;
  return _mm_add_epi32(x, to_int(floored(times(add(times(ratio, g), all(half)), all(over)))));
}
SINEW_INLINE Ints stepped(Ints p, Double ratio, Doubles g, int shift) {
  return {stepped(p.x, ratio, g.x, shift), stepped(p.y, ratio, g.y, shift), stepped(p.z, ratio, g.z, shift)};
}

void solve_four_volumes(const VolumeList& list, uint32_t first, double rest) {
  uint32_t at[4][4];  // corner, lane
  for (int lane = 0; lane < 4; ++lane) {
    const uint32_t* const corners = list.corners + 4 * static_cast<size_t>(list.tetrahedra[first + lane]);
    for (int k = 0; k < 4; ++k) at[k][lane] = corners[k];
  }
  Ints nodes[4];
  int moves[4];
  SINEW_UNROLL for (int k = 0; k < 4; ++k) {
    nodes[k] = load_nodes(list.nodes, at[k]);
    moves[k] = moving(list.moves, at[k]);
  }
  const Doubles b = to_double(between(nodes[1], nodes[0], kLongSide)),
                c = to_double(between(nodes[2], nodes[0], kLongSide)),
                d = to_double(between(nodes[3], nodes[0], kLongSide));
  Doubles gradient[4];
  gradient[1] = cross_over_cell(c, d);
  gradient[2] = cross_over_cell(d, b);
  gradient[3] = cross_over_cell(b, c);
  const Double none = _mm256_setzero_pd();
  gradient[0] = {subtract(none, add(add(gradient[1].x, gradient[2].x), gradient[3].x)),
                 subtract(none, add(add(gradient[1].y, gradient[2].y), gradient[3].y)),
                 subtract(none, add(add(gradient[1].z, gradient[2].z), gradient[3].z))};
  const Double error = subtract(all(rest), dot(b, gradient[1]));
  Double denominator = none, largest = none;
  SINEW_UNROLL for (int k = 0; k < 4; ++k) {
    const Double mask = mask_of(moves[k]);
    const Doubles& g = gradient[k];
    denominator = add(denominator, _mm256_and_pd(mask, dot(g, g)));
    const Double bound = add(add(magnitude(g.x), magnitude(g.y)), magnitude(g.z));
    largest = _mm256_max_pd(largest, _mm256_and_pd(mask, bound));
  }
  denominator = _mm256_max_pd(denominator, all(static_cast<double>(kLeastDenominator)));
  const Double ratio = cut(_mm256_div_pd(times(error, all(4096)), floored(times(denominator, all(1.0 / 64)))));
  // The reference shortens long steps.
  constexpr double kLong = static_cast<double>((kLongestStep + 1) << kRatioBits), kLargeError = 1099511627776.0;
  const int odd = 15 ^ (bits_of(less(times(magnitude(ratio), largest), all(kLong))) &
                        bits_of(less(magnitude(error), all(kLargeError))));
  SINEW_UNROLL for (int k = 0; k < 4; ++k)
      store_nodes(stepped(nodes[k], ratio, gradient[k], kRatioBits), at[k], moves[k] & ~odd, list.nodes);
  for (int lane = 0; odd >> lane != 0; ++lane) {
    if ((odd >> lane & 1) != 0) solve_volume_ref(list, first + static_cast<uint32_t>(lane));
  }
}

void solve_four_edges(const EdgeList& list, uint32_t first) {
  SolverEdge* const edges = list.edges + first;
  uint32_t a[4], b[4];
  for (int lane = 0; lane < 4; ++lane) {
    a[lane] = edges[lane].a;
    b[lane] = edges[lane].b;
  }
  const Ints from = load_nodes(list.nodes, a), to = load_nodes(list.nodes, b);
  const int a_moves = moving(list.moves, a), b_moves = moving(list.moves, b);
  const Doubles d = to_double(between(from, to, kLongEdge));
  const Double now = floored(_mm256_sqrt_pd(times(dot(d, d), all(256))));
  const Double rest = to_double(_mm_setr_epi32(edges[0].rest, edges[1].rest, edges[2].rest, edges[3].rest));
  const Int before = _mm_setr_epi32(edges[0].lambda, edges[1].lambda, edges[2].lambda, edges[3].lambda);
  const Double error = subtract(times(subtract(rest, now), all(256)),
                                times(all(static_cast<double>(list.rates.softness)), to_double(before)));
  const Double inverse = _mm256_blendv_pd(all(static_cast<double>(list.rates.inverse[0])),
                                          all(static_cast<double>(list.rates.inverse[1])), mask_of(a_moves & b_moves));
  const Double change = floored(times(add(times(error, inverse), all(8388608)), all(1.0 / 16777216)));
  const Double ratio = cut(_mm256_div_pd(times(change, all(1048576)), now));
  constexpr double kLargeError = 68719476736.0, kLargeRatio = 2147483648.0, kShort = 16;
  const int odd =
      15 ^ (bits_of(less(magnitude(error), all(kLargeError))) & bits_of(less(magnitude(ratio), all(kLargeRatio))) &
            bits_of(_mm256_cmp_pd(now, all(kShort), _CMP_GE_OQ)));
  int32_t after[4];
  _mm_storeu_si128(reinterpret_cast<Int*>(after), _mm_add_epi32(before, to_int(change)));
  SINEW_UNROLL for (int lane = 0; lane < 4; ++lane) {
    if ((odd >> lane & 1) == 0) edges[lane].lambda = after[lane];
  }
  store_nodes(stepped(from, ratio, d, 20), a, a_moves & ~odd, list.nodes);
  store_nodes(stepped(to, subtract(_mm256_setzero_pd(), ratio), d, 20), b, b_moves & ~odd, list.nodes);
  for (int lane = 0; odd >> lane != 0; ++lane) {
    if ((odd >> lane & 1) != 0) solve_edge_ref(list, first + static_cast<uint32_t>(lane));
  }
}

// Runs of independent entries by `four`, the others by `one`.
template <class List, class Four, class One>
SINEW_INLINE void each(const List& list, uint32_t begin, uint32_t end, bool backwards, const Four& four,
                       const One& one) {
  if (backwards) {
    for (uint32_t k = end; k > begin;) {
      if (k >= begin + kWide && list.wide[k - kWide] != kNarrow) {
        k -= kWide;
        four(k);
      } else {
        one(--k);
      }
    }
    return;
  }
  for (uint32_t k = begin; k < end;) {
    if (list.wide[k] != kNarrow) {
      four(k);
      k += kWide;
    } else {
      one(k++);
    }
  }
}

void solve_edges_avx2(const EdgeList& list, uint32_t begin, uint32_t end, bool backwards) {
  each(
      list, begin, end, backwards, [&list](uint32_t k) { solve_four_edges(list, k); },
      [&list](uint32_t k) { solve_edge_ref(list, k); });
}

void solve_volumes_avx2(const VolumeList& list, uint32_t begin, uint32_t end, bool backwards) {
  constexpr double kSmall = static_cast<double>(kSmallVolume);
  each(
      list, begin, end, backwards,
      [&list](uint32_t k) { solve_four_volumes(list, k, list.wide[k] == kWideLarge ? 2 * kSmall : kSmall); },
      [&list](uint32_t k) { solve_volume_ref(list, k); });
}

}  // namespace

bool add_constraints_s32_avx2(ConstraintKernels* kernels) {
  kernels->edges = solve_edges_avx2;
  kernels->volumes = solve_volumes_avx2;
  return true;
}

}  // namespace sinew
#else
namespace sinew {
bool add_constraints_s32_avx2(ConstraintKernels*) { return false; }
}  // namespace sinew
#endif
