// SPDX-License-Identifier: MIT
// Aggregations over one-rings, candidates, parts and all rows with WebAssembly's SIMD, 8 channels at a time.
#include "kernels/variants.hpp"

#if defined(__wasm_simd128__)
#include <wasm_simd128.h>

#include "kernels/aggregate_s16_wide.hpp"

namespace sinew {
namespace {

struct AggregateSimd128 {
  using Int16 = v128_t;
  struct Sums {
    v128_t low, high;
  };
  struct Divider {
    v128_t multiplier, offset;
  };
  static constexpr int kWidth = 8, kMeanRegisters = 3;

  static SINEW_INLINE v128_t load(const int16_t* from) { return wasm_v128_load(from); }
  static SINEW_INLINE void store(int16_t* to, v128_t value) { wasm_v128_store(to, value); }
  static SINEW_INLINE v128_t largest(v128_t a, v128_t b) { return wasm_i16x8_max(a, b); }

  static SINEW_INLINE Sums zero_sums() { return {wasm_i32x4_const_splat(0), wasm_i32x4_const_splat(0)}; }
  static SINEW_INLINE Sums add(Sums sums, v128_t values) {
    return {wasm_i32x4_add(sums.low, wasm_i32x4_extend_low_i16x8(values)),
            wasm_i32x4_add(sums.high, wasm_i32x4_extend_high_i16x8(values))};
  }
  static SINEW_INLINE Sums load_sums(const int32_t* from) { return {wasm_v128_load(from), wasm_v128_load(from + 4)}; }
  static SINEW_INLINE void store_sums(int32_t* to, Sums sums) {
    wasm_v128_store(to, sums.low);
    wasm_v128_store(to + 4, sums.high);
  }

  static SINEW_INLINE Divider divider(MeanDivision division) {
    return {wasm_u32x4_splat(division.multiplier), wasm_u32x4_splat(division.offset)};
  }
  static SINEW_INLINE v128_t divide(const Divider& by, v128_t sums) {
    const v128_t dividend = wasm_i32x4_add(wasm_i32x4_add(sums, sums), by.offset);
    const v128_t a = wasm_u64x2_extmul_low_u32x4(dividend, by.multiplier);
    const v128_t b = wasm_u64x2_extmul_high_u32x4(dividend, by.multiplier);
    return wasm_i32x4_shuffle(a, b, 1, 3, 5, 7);
  }
  static SINEW_INLINE v128_t means(const Divider& by, Sums sums) {
    const v128_t packed = wasm_u16x8_narrow_i32x4(divide(by, sums.low), divide(by, sums.high));
    return wasm_v128_xor(packed, wasm_i16x8_const_splat(INT16_MIN));
  }

  static SINEW_INLINE uint32_t find_of_8(const uint16_t* joints, uint16_t joint) {
    const uint32_t mask = wasm_i16x8_bitmask(wasm_i16x8_eq(wasm_v128_load(joints), wasm_u16x8_splat(joint)));
    return mask == 0 ? 8 : static_cast<uint32_t>(__builtin_ctz(mask));
  }
};

}  // namespace

bool add_aggregates_s16_simd128(Kernels* kernels) {
  add_aggregates<AggregateSimd128>(kernels);
  return true;
}

}  // namespace sinew
#else
namespace sinew {
bool add_aggregates_s16_simd128(Kernels*) { return false; }
}  // namespace sinew
#endif
