// SPDX-License-Identifier: MIT
// Softmax with ARM64 NEON, four candidates at a time.
#include "kernels/softmax.hpp"

#if defined(__aarch64__) && defined(__ARM_NEON) && !defined(__ARM_BIG_ENDIAN)
#include <arm_neon.h>

#include "kernels/softmax_s16_wide.hpp"

namespace sinew {
namespace {

struct SoftmaxNeon {
  using Int32 = int32x4_t;
  struct Reals {
    float64x2_t low, high;
  };
  static constexpr uint32_t kWidth = 4;

  static SINEW_INLINE int32x4_t load(const void* from, uint32_t n) {
    const int16_t* values = static_cast<const int16_t*>(from);
    int16_t copy[kWidth] = {-1, -1, -1, -1};
    if (n < kWidth) {
      for (uint32_t i = 0; i < n; ++i) copy[i] = values[i];
      values = copy;
    }
    return vmovl_s16(vld1_s16(values));
  }
  static SINEW_INLINE void store(uint32_t* to, int32x4_t value, uint32_t n) {
    if (n == kWidth) return vst1q_u32(to, vreinterpretq_u32_s32(value));
    uint32_t copy[kWidth];
    vst1q_u32(copy, vreinterpretq_u32_s32(value));
    for (uint32_t i = 0; i < n; ++i) to[i] = copy[i];
  }
  static SINEW_INLINE int32x4_t all(int32_t value) { return vdupq_n_s32(value); }
  static SINEW_INLINE int32x4_t subtract(int32x4_t a, int32x4_t b) { return vsubq_s32(a, b); }
  static SINEW_INLINE int32x4_t larger(int32x4_t a, int32x4_t b) { return vmaxq_s32(a, b); }
  static SINEW_INLINE int32_t largest(int32x4_t a) { return vmaxvq_s32(a); }
  static SINEW_INLINE int32x4_t present(int32x4_t logits, int32x4_t joints) {
    return vbslq_s32(vceqq_s32(joints, all(-1)), all(kAbsentLogit), logits);
  }

  static SINEW_INLINE Reals add(Reals a, Reals b) { return {vaddq_f64(a.low, b.low), vaddq_f64(a.high, b.high)}; }
  static SINEW_INLINE double sum(Reals a) { return vaddvq_f64(vaddq_f64(a.low, a.high)); }

  static SINEW_INLINE Reals powers(int32x4_t d) {
    const uint32x4_t steps = vandq_u32(vreinterpretq_u32_s32(vshrq_n_s32(d, kFineBits)), vdupq_n_u32(kSteps - 1));
    const int32x4_t fine = vandq_s32(d, all((1 << kFineBits) - 1));
    // An entry of the table and the next one for each number.
    const uint32x4_t low = vcombine_u32(vld1_u32(kPowers.q30 + vgetq_lane_u32(steps, 0)),
                                        vld1_u32(kPowers.q30 + vgetq_lane_u32(steps, 1)));
    const uint32x4_t high = vcombine_u32(vld1_u32(kPowers.q30 + vgetq_lane_u32(steps, 2)),
                                         vld1_u32(kPowers.q30 + vgetq_lane_u32(steps, 3)));
    const int32x4_t value = vreinterpretq_s32_u32(vuzp1q_u32(low, high));
    const int32x4_t drop = vsubq_s32(value, vreinterpretq_s32_u32(vuzp2q_u32(low, high)));
    const int32x4_t between = vsubq_s32(value, vshrq_n_s32(vmulq_s32(drop, fine), kFineBits));
    const int32x4_t power = vshlq_s32(between, vnegq_s32(vshrq_n_s32(d, 10)));
    return {vcvtq_f64_s64(vmovl_s32(vget_low_s32(power))), vcvtq_f64_s64(vmovl_high_s32(power))};
  }
  static SINEW_INLINE int64x2_t quotient(float64x2_t x, double offset, double factor) {
    const float64x2_t dividend = vaddq_f64(vmulq_n_f64(x, 65536.0), vdupq_n_f64(offset));
    return vcvtq_s64_f64(vmulq_n_f64(dividend, factor));
  }
  static SINEW_INLINE int32x4_t quotients(Reals x, double offset, double factor) {
    return vcombine_s32(vmovn_s64(quotient(x.low, offset, factor)), vmovn_s64(quotient(x.high, offset, factor)));
  }
  static SINEW_INLINE int32x4_t at_least(int32x4_t a, uint32_t smallest) {
    const uint32x4_t kept = vcgeq_s32(a, all(static_cast<int32_t>(smallest)));
    return vandq_s32(a, vreinterpretq_s32_u32(kept));
  }
};

}  // namespace

bool add_softmax_s16_neon(SoftmaxKernel* kernel) {
  *kernel = softmax<SoftmaxNeon>;
  return true;
}

}  // namespace sinew
#else
namespace sinew {
bool add_softmax_s16_neon(SoftmaxKernel*) { return false; }
}  // namespace sinew
#endif
