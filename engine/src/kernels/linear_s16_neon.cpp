// SPDX-License-Identifier: MIT
// The linear layer with ARM64 NEON: smlal by one number of a register on 8 outputs at a time.
#include "kernels/variants.hpp"

#if defined(__aarch64__) && defined(__ARM_NEON) && !defined(__ARM_BIG_ENDIAN)
#include <arm_neon.h>

#include "kernels/linear_s16_tiles.hpp"

namespace sinew {
namespace {

struct LinearNeon {
  struct Int32 {
    int32x4_t low, high;
  };
  using Pairs = int16x8x2_t;  // first columns, second columns of 8 outputs
  static constexpr int kWidth = 8, kGroups = 1, kFinish = 1;
  // 6 rows x 4 registers of sums, 4 of weights and an input fill 29 of 32 registers.
  static constexpr int kRows[kGroups + 1] = {0, 6};

  static SINEW_INLINE Int32 zero() { return {vdupq_n_s32(0), vdupq_n_s32(0)}; }
  static SINEW_INLINE Int32 load(const int32_t* from) { return {vld1q_s32(from), vld1q_s32(from + 4)}; }
  static SINEW_INLINE void store(int32_t* to, Int32 value) {
    vst1q_s32(to, value.low);
    vst1q_s32(to + 4, value.high);
  }
  static SINEW_INLINE Int32 add(const Int32& a, const Int32& b) {
    return {vaddq_s32(a.low, b.low), vaddq_s32(a.high, b.high)};
  }
  static SINEW_INLINE int16x4_t broadcast(int32_t pair) { return vreinterpret_s16_s32(vdup_n_s32(pair)); }
  static SINEW_INLINE Pairs load_pairs(const int16_t* from) { return vld2q_s16(from); }
  static SINEW_INLINE Int32 dot(Int32 sum, const Pairs& weights, int16x4_t input) {
    sum.low = vmlal_lane_s16(sum.low, vget_low_s16(weights.val[0]), input, 0);
    sum.high = vmlal_high_lane_s16(sum.high, weights.val[0], input, 0);
    sum.low = vmlal_lane_s16(sum.low, vget_low_s16(weights.val[1]), input, 1);
    sum.high = vmlal_high_lane_s16(sum.high, weights.val[1], input, 1);
    return sum;
  }
  static SINEW_INLINE int16x4_t requantize(int32x4_t sum, const int32_t* shifts, const int32_t* factors,
                                           int16x4_t residual, int32_t low, int32_t high) {
    if (factors != nullptr) sum = vmlaq_s32(sum, vmovl_s16(residual), vld1q_s32(factors));
    sum = vshlq_s32(sum, vnegq_s32(vld1q_s32(shifts)));  // to the right by 0..31
    return vmovn_s32(vminq_s32(vmaxq_s32(sum, vdupq_n_s32(low)), vdupq_n_s32(high)));
  }
  static SINEW_INLINE void finish(const Int32* sums, const int32_t* shifts, const int32_t* factors,
                                  const int16_t* residual, int32_t low, int32_t high, uint32_t count, int16_t* out) {
    int16_t values[16] = {}, results[16];
    if (factors != nullptr && count < 16) {
      memcpy(values, residual, count * sizeof(int16_t));
      residual = values;
    } else if (factors == nullptr) {
      residual = values;
    }
    int16_t* const to = count < 16 ? results : out;
    for (int i = 0; i < 4; ++i) {
      const int32x4_t sum = i % 2 == 0 ? sums[i / 2].low : sums[i / 2].high;
      vst1_s16(to + 4 * i, requantize(sum, shifts + 4 * i, factors == nullptr ? nullptr : factors + 4 * i,
                                      vld1_s16(residual + 4 * i), low, high));
    }
    if (count < 16) memcpy(out, results, count * sizeof(int16_t));
  }
};

void linear_s16_neon(const LinearView& linear, RowsView in, RowsView residual, const uint16_t* present, uint32_t rows,
                     int16_t* out, uint32_t out_stride) {
  linear_tiled<LinearNeon>(linear, in.data, in.stride, residual.data, residual.stride, present, rows, out, out_stride);
}

void linear_sums_s16_neon(const LinearView& linear, RowsView in, uint32_t rows, int32_t* sums) {
  linear_sums_tiled<LinearNeon>(linear, in.data, in.stride, rows, sums);
}

}  // namespace

bool add_linear_s16_neon(Kernels* kernels) {
  kernels->linear_packed = linear_s16_neon;
  kernels->linear_sums = linear_sums_s16_neon;
  return true;
}

}  // namespace sinew
#else
namespace sinew {
bool add_linear_s16_neon(Kernels*) { return false; }
}  // namespace sinew
#endif
