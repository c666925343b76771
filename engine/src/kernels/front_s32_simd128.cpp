// SPDX-License-Identifier: MIT
// The factorisation's inner loops with WebAssembly's SIMD: i64x2.extmul on the low and the high half of four int32.
#include "kernels/front.hpp"

#if defined(__wasm_simd128__)
#include <wasm_simd128.h>

#include "kernels/front_s32_wide.hpp"

namespace sinew {
namespace {

struct FrontSimd128 {
  using Int32 = v128_t;
  using Mask = uint32_t;  // how many; there are no masked loads, and a tail comes once per column of a front
  using Values = v128_t;
  struct Sums {
    v128_t low, high;
  };
  static constexpr uint32_t kWidth = 4;

  static SINEW_INLINE Mask first(uint32_t n) { return n; }
  static SINEW_INLINE v128_t load(const int32_t* from) { return wasm_v128_load(from); }
  static SINEW_INLINE v128_t load(const int32_t* from, Mask n) {
    int32_t four[kWidth] = {};
    for (uint32_t i = 0; i < n; ++i) four[i] = from[i];
    return wasm_v128_load(four);
  }
  static SINEW_INLINE void store(int32_t* to, v128_t value) { wasm_v128_store(to, value); }
  static SINEW_INLINE void store(int32_t* to, v128_t value, Mask n) {
    int32_t four[kWidth];
    wasm_v128_store(four, value);
    for (uint32_t i = 0; i < n; ++i) to[i] = four[i];
  }

  static SINEW_INLINE Values values(v128_t row) { return row; }
  static SINEW_INLINE Sums zero() { return {wasm_i64x2_const_splat(0), wasm_i64x2_const_splat(0)}; }
  static SINEW_INLINE Sums add(Sums sums, Values values, int32_t factor) {
    const v128_t factors = wasm_i32x4_splat(factor);
    return {wasm_i64x2_add(sums.low, wasm_i64x2_extmul_low_i32x4(values, factors)),
            wasm_i64x2_add(sums.high, wasm_i64x2_extmul_high_i32x4(values, factors))};
  }
  // No arithmetic shift is needed for the low 32 bits.
  static SINEW_INLINE v128_t less(v128_t out, Sums sums) {
    const v128_t half = wasm_i64x2_const_splat(1 << (kFrontBits - 1));
    return wasm_i32x4_sub(out,
                          wasm_i32x4_shuffle(wasm_u64x2_shr(wasm_i64x2_add(sums.low, half), kFrontBits),
                                             wasm_u64x2_shr(wasm_i64x2_add(sums.high, half), kFrontBits), 0, 2, 4, 6));
  }
  static SINEW_INLINE void store_sums(int64_t* to, Sums sums) {
    wasm_v128_store(to, sums.low);
    wasm_v128_store(to + 2, sums.high);
  }
};

}  // namespace

bool add_front_s32_simd128(FrontKernels* kernels) {
  add_fronts<FrontSimd128>(kernels);
  return true;
}

}  // namespace sinew
#else
namespace sinew {
bool add_front_s32_simd128(FrontKernels*) { return false; }
}  // namespace sinew
#endif
