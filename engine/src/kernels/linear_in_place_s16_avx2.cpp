// SPDX-License-Identifier: MIT
// The linear layer with AVX2 on the model's own bytes, for sinew_bind_options::weights_in_place: 16 columns of two rows and
// four outputs at a time. Weights lie by outputs there, so sums are added up across a register at the end; packed
// weights (linear_s16_tiles.hpp) do without that and reuse inputs more often.
#include "kernels/variants.hpp"

#if defined(__AVX2__)
#include <immintrin.h>
#include <string.h>

#include "kernels/isolated.hpp"

namespace sinew {
namespace {

constexpr uint32_t kWidth = 16, kOutputs = 4;

// Two rows, the same one twice at the end of an odd number.
struct RowPair {
  const int16_t* x[2];
  const int16_t* residual[2];
  int16_t* out[2];
};

SINEW_INLINE __m256i load(const int16_t* from) {
  return _mm256_loadu_si256(static_cast<const __m256i*>(static_cast<const void*>(from)));
}
// The first pairs of columns of a register, the others 0 and not touched in memory.
SINEW_INLINE __m256i load_pairs(const int16_t* from, __m256i mask) {
  return _mm256_maskload_epi32(static_cast<const int*>(static_cast<const void*>(from)), mask);
}
SINEW_INLINE __m256i add_products(__m256i sum, __m256i weights, __m256i inputs) {
  // No pair of products leaves int32: the reader refuses the weight -32768.
  return _mm256_add_epi32(sum, _mm256_madd_epi16(weights, inputs));
}
SINEW_INLINE __m128i add_across(const __m256i* sums) {
  const __m256i both = _mm256_hadd_epi32(_mm256_hadd_epi32(sums[0], sums[1]), _mm256_hadd_epi32(sums[2], sums[3]));
  return _mm_add_epi32(_mm256_castsi256_si128(both), _mm256_extracti128_si256(both, 1));
}

// Numbers of four outputs; behind the last one its own again.
struct FourOutputs {
  uint32_t n[kOutputs];
  __m128i bias, shifts, factors;

  SINEW_INLINE FourOutputs(const LinearView& linear, uint32_t first) {
    int32_t wide[3][kOutputs];
    for (uint32_t i = 0; i < kOutputs; ++i) {
      n[i] = first + i < linear.out ? first + i : linear.out - 1;
      memcpy(&wide[0][i], linear.bias + 8u * n[i], sizeof(int32_t));  // class N: the low half of the int64
      wide[1][i] = linear.shifts[n[i]];
      wide[2][i] = linear.residual != nullptr ? linear.residual[n[i]] : 0;
    }
    bias = load_four(wide[0]);
    shifts = load_four(wide[1]);
    factors = load_four(wide[2]);
  }
  static SINEW_INLINE __m128i load_four(const int32_t* from) {
    return _mm_loadu_si128(static_cast<const __m128i*>(static_cast<const void*>(from)));
  }
};

void four_outputs(const LinearView& linear, const RowPair& rows, uint32_t first) {
  const FourOutputs outputs(linear, first);
  const int16_t* weights[kOutputs];
  for (uint32_t i = 0; i < kOutputs; ++i) weights[i] = linear.weights + static_cast<size_t>(outputs.n[i]) * linear.in;
  __m256i sums[2][kOutputs];
  SINEW_UNROLL for (uint32_t i = 0; i < kOutputs; ++i) sums[0][i] = sums[1][i] = _mm256_setzero_si256();
  uint32_t k = 0;
  for (; k + kWidth <= linear.in; k += kWidth) {
    const __m256i x0 = load(rows.x[0] + k), x1 = load(rows.x[1] + k);
    SINEW_UNROLL for (uint32_t i = 0; i < kOutputs; ++i) {
      const __m256i w = load(weights[i] + k);
      sums[0][i] = add_products(sums[0][i], w, x0);
      sums[1][i] = add_products(sums[1][i], w, x1);
    }
  }
  if (linear.in - k >= 2) {
    const __m256i mask = _mm256_cmpgt_epi32(_mm256_set1_epi32(static_cast<int32_t>((linear.in - k) / 2)),
                                            _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7));
    const __m256i x0 = load_pairs(rows.x[0] + k, mask), x1 = load_pairs(rows.x[1] + k, mask);
    SINEW_UNROLL for (uint32_t i = 0; i < kOutputs; ++i) {
      const __m256i w = load_pairs(weights[i] + k, mask);
      sums[0][i] = add_products(sums[0][i], w, x0);
      sums[1][i] = add_products(sums[1][i], w, x1);
    }
  }
  const uint32_t count = linear.out - first < kOutputs ? linear.out - first : kOutputs;
  const uint32_t last = linear.in - 1;
  for (int r = 0; r < 2; ++r) {
    __m128i sum = _mm_add_epi32(outputs.bias, add_across(sums[r]));
    if (linear.in % 2 != 0) {
      int32_t products[kOutputs];
      for (uint32_t i = 0; i < kOutputs; ++i) products[i] = rows.x[r][last] * weights[i][last];
      sum = _mm_add_epi32(sum, FourOutputs::load_four(products));
    }
    if (linear.residual != nullptr) {
      int32_t residual[kOutputs];
      for (uint32_t i = 0; i < kOutputs; ++i) residual[i] = rows.residual[r][outputs.n[i]];
      sum = _mm_add_epi32(sum, _mm_mullo_epi32(FourOutputs::load_four(residual), outputs.factors));
    }
    sum = _mm_srav_epi32(sum, outputs.shifts);
    sum = _mm_min_epi32(_mm_max_epi32(sum, _mm_set1_epi32(linear.low)), _mm_set1_epi32(linear.high));
    int16_t values[8];
    _mm_storeu_si128(static_cast<__m128i*>(static_cast<void*>(values)), _mm_packs_epi32(sum, sum));
    memcpy(rows.out[r] + first, values, count * sizeof(int16_t));
  }
}

void linear_in_place_s16_avx2(const LinearView& linear, RowsView in, RowsView residual, const uint16_t* present,
                              uint32_t rows, int16_t* out, uint32_t out_stride) {
  // Class W is rare, and its int64 sums gain little.
  if (linear.wide) return linear_s16_ref(linear, in, residual, present, rows, out, out_stride);
  for (uint32_t r = 0; r < rows;) {
    // The next two present rows.
    RowPair pair;
    int count = 0;
    for (; r < rows && count < 2; ++r) {
      int16_t* const to = out + static_cast<size_t>(r) * out_stride;
      if (present != nullptr && present[r] == kNoJoint) {
        memset(to, 0, linear.out * sizeof(int16_t));
        continue;
      }
      pair.x[count] = in.data + static_cast<size_t>(r) * in.stride;
      pair.residual[count] =
          linear.residual != nullptr ? residual.data + static_cast<size_t>(r) * residual.stride : nullptr;
      pair.out[count++] = to;
    }
    if (count == 0) return;
    if (count == 1) {
      pair.x[1] = pair.x[0];
      pair.residual[1] = pair.residual[0];
      pair.out[1] = pair.out[0];
    }
    for (uint32_t n = 0; n < linear.out; n += kOutputs) four_outputs(linear, pair, n);
  }
}

}  // namespace

bool add_linear_in_place_s16_avx2(Kernels* kernels) {
  kernels->linear = linear_in_place_s16_avx2;
  return true;
}

}  // namespace sinew
#else
namespace sinew {
bool add_linear_in_place_s16_avx2(Kernels*) { return false; }
}  // namespace sinew
#endif
