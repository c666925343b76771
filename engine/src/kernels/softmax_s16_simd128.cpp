// SPDX-License-Identifier: MIT
// Softmax with WebAssembly's SIMD, four candidates at a time.
#include "kernels/softmax.hpp"

#if defined(__wasm_simd128__)
#include <wasm_simd128.h>

#include "kernels/softmax_s16_wide.hpp"

namespace sinew {
namespace {

struct SoftmaxSimd128 {
  using Int32 = v128_t;
  struct Reals {
    v128_t low, high;
  };
  static constexpr uint32_t kWidth = 4;

  static SINEW_INLINE v128_t load(const void* from, uint32_t n) {
    int16_t copy[kWidth] = {-1, -1, -1, -1};
    if (n < kWidth) {
      for (uint32_t i = 0; i < n; ++i) copy[i] = static_cast<const int16_t*>(from)[i];
      from = copy;
    }
    return wasm_i32x4_load16x4(from);
  }
  static SINEW_INLINE void store(uint32_t* to, v128_t value, uint32_t n) {
    if (n == kWidth) return wasm_v128_store(to, value);
    uint32_t copy[kWidth];
    wasm_v128_store(copy, value);
    for (uint32_t i = 0; i < n; ++i) to[i] = copy[i];
  }
  static SINEW_INLINE v128_t all(int32_t value) { return wasm_i32x4_splat(value); }
  static SINEW_INLINE v128_t subtract(v128_t a, v128_t b) { return wasm_i32x4_sub(a, b); }
  static SINEW_INLINE v128_t larger(v128_t a, v128_t b) { return wasm_i32x4_max(a, b); }
  static SINEW_INLINE int32_t largest(v128_t a) {
    const v128_t two = larger(a, wasm_i32x4_shuffle(a, a, 2, 3, 0, 1));
    return wasm_i32x4_extract_lane(larger(two, wasm_i32x4_shuffle(two, two, 1, 0, 3, 2)), 0);
  }
  static SINEW_INLINE v128_t present(v128_t logits, v128_t joints) {
    return wasm_v128_bitselect(all(kAbsentLogit), logits, wasm_i32x4_eq(joints, all(-1)));
  }

  static SINEW_INLINE Reals add(Reals a, Reals b) {
    return {wasm_f64x2_add(a.low, b.low), wasm_f64x2_add(a.high, b.high)};
  }
  static SINEW_INLINE double sum(Reals a) {
    const v128_t two = wasm_f64x2_add(a.low, a.high);
    return wasm_f64x2_extract_lane(two, 0) + wasm_f64x2_extract_lane(two, 1);
  }

  // An entry of the table and the next one for two numbers.
  static SINEW_INLINE v128_t pairs(int32_t a, int32_t b) {
    return wasm_v128_load64_lane(kPowers.q30 + b, wasm_v128_load64_zero(kPowers.q30 + a), 1);
  }
  // There are no shifts by numbers of a register: x >> w is floor(x * 2^-w), and the power is made of its exponent's
  // bits.
  static SINEW_INLINE v128_t shifted(v128_t x, v128_t exponents) {
    return wasm_f64x2_floor(wasm_f64x2_mul(x, wasm_i64x2_shl(exponents, 52)));
  }
  static SINEW_INLINE Reals powers(v128_t d) {
    const v128_t steps = wasm_v128_and(wasm_u32x4_shr(d, kFineBits), all(kSteps - 1));
    const v128_t fine = wasm_v128_and(d, all((1 << kFineBits) - 1));
    const v128_t low = pairs(wasm_i32x4_extract_lane(steps, 0), wasm_i32x4_extract_lane(steps, 1));
    const v128_t high = pairs(wasm_i32x4_extract_lane(steps, 2), wasm_i32x4_extract_lane(steps, 3));
    const v128_t value = wasm_i32x4_shuffle(low, high, 0, 2, 4, 6);
    const v128_t drop = subtract(value, wasm_i32x4_shuffle(low, high, 1, 3, 5, 7));
    const v128_t between = subtract(value, wasm_u32x4_shr(wasm_i32x4_mul(drop, fine), kFineBits));
    const v128_t exponents = subtract(all(1023), wasm_u32x4_shr(d, 10));
    const v128_t upper = wasm_i32x4_shuffle(between, between, 2, 3, 2, 3);
    return {shifted(wasm_f64x2_convert_low_i32x4(between), wasm_u64x2_extend_low_u32x4(exponents)),
            shifted(wasm_f64x2_convert_low_i32x4(upper), wasm_u64x2_extend_high_u32x4(exponents))};
  }
  static SINEW_INLINE v128_t quotient(v128_t x, double offset, double factor) {
    const v128_t dividend = wasm_f64x2_add(wasm_f64x2_mul(x, wasm_f64x2_splat(65536.0)), wasm_f64x2_splat(offset));
    return wasm_i32x4_trunc_sat_f64x2_zero(wasm_f64x2_mul(dividend, wasm_f64x2_splat(factor)));
  }
  static SINEW_INLINE v128_t quotients(Reals x, double offset, double factor) {
    return wasm_i32x4_shuffle(quotient(x.low, offset, factor), quotient(x.high, offset, factor), 0, 1, 4, 5);
  }
  static SINEW_INLINE v128_t at_least(v128_t a, uint32_t smallest) {
    return wasm_v128_and(a, wasm_i32x4_ge(a, all(static_cast<int32_t>(smallest))));
  }
};

}  // namespace

bool add_softmax_s16_simd128(SoftmaxKernel* kernel) {
  *kernel = softmax<SoftmaxSimd128>;
  return true;
}

}  // namespace sinew
#else
namespace sinew {
bool add_softmax_s16_simd128(SoftmaxKernel*) { return false; }
}  // namespace sinew
#endif
