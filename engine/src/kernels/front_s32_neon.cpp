// SPDX-License-Identifier: MIT
// The factorisation's inner loops with ARM64 NEON: smlal on the low and the high half of four int32.
#include "kernels/front.hpp"

#if defined(__aarch64__) && defined(__ARM_NEON) && !defined(__ARM_BIG_ENDIAN)
#include <arm_neon.h>

#include "kernels/front_s32_wide.hpp"

namespace sinew {
namespace {

struct FrontNeon {
  using Int32 = int32x4_t;
  using Mask = uint32_t;  // how many; there are no masked loads, and a tail comes once per column of a front
  using Values = int32x4_t;
  struct Sums {
    int64x2_t low, high;
  };
  static constexpr uint32_t kWidth = 4;

  static SINEW_INLINE Mask first(uint32_t n) { return n; }
  static SINEW_INLINE int32x4_t load(const int32_t* from) { return vld1q_s32(from); }
  static SINEW_INLINE int32x4_t load(const int32_t* from, Mask n) {
    int32_t four[kWidth] = {};
    for (uint32_t i = 0; i < n; ++i) four[i] = from[i];
    return vld1q_s32(four);
  }
  static SINEW_INLINE void store(int32_t* to, int32x4_t value) { vst1q_s32(to, value); }
  static SINEW_INLINE void store(int32_t* to, int32x4_t value, Mask n) {
    int32_t four[kWidth];
    vst1q_s32(four, value);
    for (uint32_t i = 0; i < n; ++i) to[i] = four[i];
  }

  static SINEW_INLINE Values values(int32x4_t row) { return row; }
  static SINEW_INLINE Sums zero() { return {vdupq_n_s64(0), vdupq_n_s64(0)}; }
  static SINEW_INLINE Sums add(Sums sums, Values values, int32_t factor) {
    return {vmlal_n_s32(sums.low, vget_low_s32(values), factor), vmlal_high_n_s32(sums.high, values, factor)};
  }
  // rshrn adds the half and keeps the low 32 bits.
  static SINEW_INLINE int32x4_t less(int32x4_t out, Sums sums) {
    return vsubq_s32(out, vcombine_s32(vrshrn_n_s64(sums.low, kFrontBits), vrshrn_n_s64(sums.high, kFrontBits)));
  }
  static SINEW_INLINE void store_sums(int64_t* to, Sums sums) {
    vst1q_s64(to, sums.low);
    vst1q_s64(to + 2, sums.high);
  }
};

}  // namespace

bool add_front_s32_neon(FrontKernels* kernels) {
  add_fronts<FrontNeon>(kernels);
  return true;
}

}  // namespace sinew
#else
namespace sinew {
bool add_front_s32_neon(FrontKernels*) { return false; }
}  // namespace sinew
#endif
