// SPDX-License-Identifier: MIT
// A segment against sixteen boxes with WebAssembly's SIMD, four at a time.
#include "kernels/boxes.hpp"

#if defined(__wasm_simd128__)
#include <wasm_simd128.h>

#include "kernels/boxes_s32_wide.hpp"

namespace sinew {
namespace {

struct BoxesSimd128 {
  using Int32 = v128_t;
  struct Int64 {
    v128_t low, high;
  };
  static constexpr uint32_t kWidth = 4;

  static SINEW_INLINE v128_t load(const int32_t* from) { return wasm_v128_load(from); }
  static SINEW_INLINE v128_t all(int32_t value) { return wasm_i32x4_splat(value); }
  static SINEW_INLINE v128_t add(v128_t a, v128_t b) { return wasm_i32x4_add(a, b); }
  static SINEW_INLINE v128_t subtract(v128_t a, v128_t b) { return wasm_i32x4_sub(a, b); }
  static SINEW_INLINE v128_t either(v128_t a, v128_t b) { return wasm_v128_or(a, b); }

  static SINEW_INLINE Int64 products(v128_t a, v128_t b) {
    return {wasm_i64x2_extmul_low_i32x4(a, b), wasm_i64x2_extmul_high_i32x4(a, b)};
  }
  static SINEW_INLINE Int64 add(Int64 a, Int64 b) {
    return {wasm_i64x2_add(a.low, b.low), wasm_i64x2_add(a.high, b.high)};
  }
  static SINEW_INLINE Int64 subtract(Int64 a, Int64 b) {
    return {wasm_i64x2_sub(a.low, b.low), wasm_i64x2_sub(a.high, b.high)};
  }
  static SINEW_INLINE Int64 either(Int64 a, Int64 b) { return {either(a.low, b.low), either(a.high, b.high)}; }

  static SINEW_INLINE uint32_t signs(v128_t a, Int64 b) {
    return static_cast<uint32_t>(wasm_i32x4_bitmask(either(a, wasm_i32x4_shuffle(b.low, b.high, 1, 3, 5, 7))));
  }
};

}  // namespace

bool add_boxes_s32_simd128(BoxKernel* kernel) {
  *kernel = boxes_met_in<BoxesSimd128>;
  return true;
}

}  // namespace sinew
#else
namespace sinew {
bool add_boxes_s32_simd128(BoxKernel*) { return false; }
}  // namespace sinew
#endif
