// SPDX-License-Identifier: MIT
// The linear layer with WebAssembly's 128-bit SIMD: i32x4.dot_i16x8_s on 4 outputs at a time.
#include "kernels/variants.hpp"

#if defined(__wasm_simd128__)
#include <wasm_simd128.h>

#include "kernels/linear_s16_tiles.hpp"

namespace sinew {
namespace {

struct LinearSimd128 {
  using Int32 = v128_t;
  using Pairs = v128_t;
  static constexpr int kWidth = 4, kGroups = 1, kFinish = 1;
  static constexpr int kRows[kGroups + 1] = {0, 2};

  static SINEW_INLINE Int32 zero() { return wasm_i32x4_const_splat(0); }
  static SINEW_INLINE Int32 load(const int32_t* from) { return wasm_v128_load(from); }
  static SINEW_INLINE void store(int32_t* to, Int32 value) { wasm_v128_store(to, value); }
  static SINEW_INLINE Int32 add(Int32 a, Int32 b) { return wasm_i32x4_add(a, b); }
  static SINEW_INLINE Pairs broadcast(int32_t pair) { return wasm_i32x4_splat(pair); }
  static SINEW_INLINE Pairs load_pairs(const int16_t* from) { return wasm_v128_load(from); }
  static SINEW_INLINE Int32 dot(Int32 sum, Pairs weights, Pairs input) {
    return wasm_i32x4_add(sum, wasm_i32x4_dot_i16x8(weights, input));
  }
  // 2^(31 - shift) each. There is no shift by numbers of a register, so a table of the eight powers below 256 is asked
  // once per byte: an index that is not of this byte is negative or above 7 and finds 0.
  static SINEW_INLINE v128_t powers(v128_t shifts) {
    const v128_t table = wasm_i8x16_const(1, 2, 4, 8, 16, 32, 64, -128, 0, 0, 0, 0, 0, 0, 0, 0);
    const v128_t exponents =
        wasm_i32x4_mul(wasm_i32x4_sub(wasm_i32x4_const_splat(31), shifts), wasm_i32x4_const_splat(0x01010101));
    return wasm_i8x16_swizzle(table, wasm_i8x16_sub(exponents, wasm_i32x4_const_splat(0x18100800)));
  }
  static SINEW_INLINE v128_t requantize(v128_t sum, const int32_t* shifts, const int32_t* factors, v128_t residual,
                                        v128_t low, v128_t high) {
    if (factors != nullptr) sum = wasm_i32x4_add(sum, wasm_i32x4_mul(residual, load(factors)));
    // sum >> shift is bits 31..62 of sum * 2^(31 - shift). Shifts of class N are 1..31; those of outputs behind the
    // last, 0 and whatever lies there, are of no use to anyone.
    const v128_t factor = powers(load(shifts));
    const v128_t a = wasm_u64x2_shr(wasm_i64x2_extmul_low_i32x4(sum, factor), 31);
    const v128_t b = wasm_u64x2_shr(wasm_i64x2_extmul_high_i32x4(sum, factor), 31);
    const v128_t value = wasm_i32x4_shuffle(a, b, 0, 2, 4, 6);
    return wasm_i32x4_min(wasm_i32x4_max(value, low), high);
  }
  static SINEW_INLINE void finish(const Int32* sums, const int32_t* shifts, const int32_t* factors,
                                  const int16_t* residual, int32_t low, int32_t high, uint32_t count, int16_t* out) {
    const v128_t lowest = wasm_i32x4_splat(low), highest = wasm_i32x4_splat(high);
    v128_t given[2] = {zero(), zero()};
    if (factors != nullptr) memcpy(given, residual, count == 16 ? sizeof(given) : count * sizeof(int16_t));
    v128_t done[2];
    SINEW_UNROLL for (int i = 0; i < 2; ++i) {
      const int at = 8 * i;
      const v128_t a = requantize(sums[2 * i], shifts + at, factors == nullptr ? nullptr : factors + at,
                                  wasm_i32x4_extend_low_i16x8(given[i]), lowest, highest);
      const v128_t b = requantize(sums[2 * i + 1], shifts + at + 4, factors == nullptr ? nullptr : factors + at + 4,
                                  wasm_i32x4_extend_high_i16x8(given[i]), lowest, highest);
      done[i] = wasm_i16x8_narrow_i32x4(a, b);
    }
    if (count == 16) {
      wasm_v128_store(out, done[0]);
      wasm_v128_store(out + 8, done[1]);
    } else {
      memcpy(out, done, count * sizeof(int16_t));
    }
  }
};

void linear_s16_simd128(const LinearView& linear, RowsView in, RowsView residual, const uint16_t* present,
                        uint32_t rows, int16_t* out, uint32_t out_stride) {
  linear_tiled<LinearSimd128>(linear, in.data, in.stride, residual.data, residual.stride, present, rows, out,
                              out_stride);
}

void linear_sums_s16_simd128(const LinearView& linear, RowsView in, uint32_t rows, int32_t* sums) {
  linear_sums_tiled<LinearSimd128>(linear, in.data, in.stride, rows, sums);
}

}  // namespace

bool add_linear_s16_simd128(Kernels* kernels) {
  kernels->linear_packed = linear_s16_simd128;
  kernels->linear_sums = linear_sums_s16_simd128;
  return true;
}

}  // namespace sinew
#else
namespace sinew {
bool add_linear_s16_simd128(Kernels*) { return false; }
}  // namespace sinew
#endif
