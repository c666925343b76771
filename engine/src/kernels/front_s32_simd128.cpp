// SPDX-License-Identifier: MIT
// The factorisation's inner loops with WebAssembly's SIMD: i64x2.extmul on the low and the high half of four int32.
#include "kernels/front.hpp"

#if defined(__wasm_simd128__)
#include <wasm_simd128.h>

#include "kernels/isolated.hpp"

namespace sinew {
namespace {

constexpr uint32_t kLanes = 4;

// Sums of products of four values with one factor per column.
template <uint32_t kColumns>
struct Sums {
  v128_t low[kColumns], high[kColumns];

  SINEW_INLINE Sums() {
    SINEW_UNROLL
    for (uint32_t c = 0; c < kColumns; ++c) low[c] = high[c] = wasm_i64x2_const_splat(0);
  }
  SINEW_INLINE void add(uint32_t c, v128_t values, int32_t factor) {
    const v128_t factors = wasm_i32x4_splat(factor);
    low[c] = wasm_i64x2_add(low[c], wasm_i64x2_extmul_low_i32x4(values, factors));
    high[c] = wasm_i64x2_add(high[c], wasm_i64x2_extmul_high_i32x4(values, factors));
  }
};

// The low 32 bits of (sum + half) >> kFrontBits; no arithmetic shift is needed for them.
SINEW_INLINE v128_t rounded(v128_t low, v128_t high) {
  const v128_t half = wasm_i64x2_const_splat(1 << (kFrontBits - 1));
  return wasm_i32x4_shuffle(wasm_u64x2_shr(wasm_i64x2_add(low, half), kFrontBits),
                            wasm_u64x2_shr(wasm_i64x2_add(high, half), kFrontBits), 0, 2, 4, 6);
}

template <uint32_t kColumns>
SINEW_INLINE void update(const int32_t* g, size_t stride, uint32_t pivots, uint32_t rows, int32_t* target,
                         size_t target_stride) {
  uint32_t i = 0;
  for (; i + kLanes <= rows; i += kLanes) {
    Sums<kColumns> sums;
    const int32_t* column = g;
    for (uint32_t k = 0; k < pivots; ++k, column += stride) {
      const v128_t values = wasm_v128_load(column + i);
      SINEW_UNROLL
      for (uint32_t c = 0; c < kColumns; ++c) sums.add(c, values, column[c]);
    }
    SINEW_UNROLL
    for (uint32_t c = 0; c < kColumns; ++c) {
      int32_t* const out = target + c * target_stride + i;
      wasm_v128_store(out, wasm_i32x4_sub(wasm_v128_load(out), rounded(sums.low[c], sums.high[c])));
    }
  }
  for (; i < rows; ++i) {
    for (uint32_t c = 0; c < kColumns; ++c) {
      uint64_t sum = 1u << (kFrontBits - 1);
      const int32_t* column = g;
      for (uint32_t k = 0; k < pivots; ++k, column += stride) {
        sum += static_cast<uint64_t>(static_cast<int64_t>(column[i]) * column[c]);
      }
      int32_t* const out = target + c * target_stride + i;
      *out = static_cast<int32_t>(static_cast<uint32_t>(*out) - static_cast<uint32_t>(sum >> kFrontBits));
    }
  }
}

void front_update_simd128(const int32_t* g, size_t stride, uint32_t pivots, uint32_t columns, uint32_t rows,
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

void front_lanes_simd128(const int32_t* g, size_t next, size_t step, uint32_t terms, const int32_t* lanes,
                         int64_t* sums) {
  for (uint32_t lane = 0; lane < kFrontLanes; lane += kLanes) {
    Sums<kFrontColumns> part;
    const int32_t* factors = g;
    const int32_t* values = lanes + lane;
    for (uint32_t t = 0; t < terms; ++t, factors += step, values += kFrontLanes) {
      const v128_t four = wasm_v128_load(values);
      SINEW_UNROLL
      for (uint32_t c = 0; c < kFrontColumns; ++c) part.add(c, four, factors[c * next]);
    }
    SINEW_UNROLL
    for (uint32_t c = 0; c < kFrontColumns; ++c) {
      wasm_v128_store(sums + c * kFrontLanes + lane, part.low[c]);
      wasm_v128_store(sums + c * kFrontLanes + lane + 2, part.high[c]);
    }
  }
}

}  // namespace

bool add_front_s32_simd128(FrontKernels* kernels) {
  kernels->update = front_update_simd128;
  kernels->lanes = front_lanes_simd128;
  return true;
}

}  // namespace sinew
#else
namespace sinew {
bool add_front_s32_simd128(FrontKernels*) { return false; }
}  // namespace sinew
#endif
