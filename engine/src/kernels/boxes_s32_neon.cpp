// SPDX-License-Identifier: MIT
// A segment against sixteen boxes with ARM64 NEON, four at a time.
#include "kernels/boxes.hpp"

#if defined(__aarch64__) && defined(__ARM_NEON) && !defined(__ARM_BIG_ENDIAN)
#include <arm_neon.h>

#include "kernels/boxes_s32_wide.hpp"

namespace sinew {
namespace {

struct BoxesNeon {
  using Int32 = int32x4_t;
  struct Int64 {
    int64x2_t low, high;
  };
  static constexpr uint32_t kWidth = 4;

  static SINEW_INLINE int32x4_t load(const int32_t* from) { return vld1q_s32(from); }
  static SINEW_INLINE int32x4_t all(int32_t value) { return vdupq_n_s32(value); }
  static SINEW_INLINE int32x4_t add(int32x4_t a, int32x4_t b) { return vaddq_s32(a, b); }
  static SINEW_INLINE int32x4_t subtract(int32x4_t a, int32x4_t b) { return vsubq_s32(a, b); }
  static SINEW_INLINE int32x4_t either(int32x4_t a, int32x4_t b) { return vorrq_s32(a, b); }

  static SINEW_INLINE Int64 products(int32x4_t a, int32x4_t b) {
    return {vmull_s32(vget_low_s32(a), vget_low_s32(b)), vmull_high_s32(a, b)};
  }
  static SINEW_INLINE Int64 add(Int64 a, Int64 b) { return {vaddq_s64(a.low, b.low), vaddq_s64(a.high, b.high)}; }
  static SINEW_INLINE Int64 subtract(Int64 a, Int64 b) { return {vsubq_s64(a.low, b.low), vsubq_s64(a.high, b.high)}; }
  static SINEW_INLINE Int64 either(Int64 a, Int64 b) { return {vorrq_s64(a.low, b.low), vorrq_s64(a.high, b.high)}; }

  static SINEW_INLINE uint32_t signs(int32x4_t a, Int64 b) {
    const int32x4_t high_halves = vuzp2q_s32(vreinterpretq_s32_s64(b.low), vreinterpretq_s32_s64(b.high));
    const int32x4_t positions = vcombine_s32(vcreate_s32(0x0000000100000000), vcreate_s32(0x0000000300000002));
    const uint32x4_t negative = vshrq_n_u32(vreinterpretq_u32_s32(either(a, high_halves)), 31);
    return vaddvq_u32(vshlq_u32(negative, positions));
  }
};

}  // namespace

bool add_boxes_s32_neon(BoxKernel* kernel) {
  *kernel = boxes_met_in<BoxesNeon>;
  return true;
}

}  // namespace sinew
#else
namespace sinew {
bool add_boxes_s32_neon(BoxKernel*) { return false; }
}  // namespace sinew
#endif
