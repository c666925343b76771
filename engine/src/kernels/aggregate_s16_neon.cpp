// SPDX-License-Identifier: MIT
// Aggregations over one-rings, candidates, parts and all rows with ARM64 NEON, 8 channels at a time.
#include "kernels/variants.hpp"

#if defined(__aarch64__) && defined(__ARM_NEON) && !defined(__ARM_BIG_ENDIAN)
#include <arm_neon.h>

#include "kernels/aggregate_s16_wide.hpp"

namespace sinew {
namespace {

struct AggregateNeon {
  using Int16 = int16x8_t;
  struct Sums {
    int32x4_t low, high;
  };
  struct Divider {
    uint32x4_t multiplier, offset;
  };
  static constexpr int kWidth = 8, kMeanRegisters = 3;

  static SINEW_INLINE int16x8_t load(const int16_t* from) { return vld1q_s16(from); }
  static SINEW_INLINE void store(int16_t* to, int16x8_t value) { vst1q_s16(to, value); }
  static SINEW_INLINE int16x8_t largest(int16x8_t a, int16x8_t b) { return vmaxq_s16(a, b); }

  static SINEW_INLINE Sums zero_sums() { return {vdupq_n_s32(0), vdupq_n_s32(0)}; }
  static SINEW_INLINE Sums add(Sums sums, int16x8_t values) {
    return {vaddw_s16(sums.low, vget_low_s16(values)), vaddw_high_s16(sums.high, values)};
  }
  static SINEW_INLINE Sums load_sums(const int32_t* from) { return {vld1q_s32(from), vld1q_s32(from + 4)}; }
  static SINEW_INLINE void store_sums(int32_t* to, Sums sums) {
    vst1q_s32(to, sums.low);
    vst1q_s32(to + 4, sums.high);
  }

  static SINEW_INLINE Divider divider(MeanDivision division) {
    return {vdupq_n_u32(division.multiplier), vdupq_n_u32(division.offset)};
  }
  static SINEW_INLINE uint16x4_t divide(const Divider& by, int32x4_t sums) {
    const uint32x4_t dividend = vaddq_u32(vreinterpretq_u32_s32(vaddq_s32(sums, sums)), by.offset);
    const uint64x2_t a = vmull_u32(vget_low_u32(dividend), vget_low_u32(by.multiplier));
    const uint64x2_t b = vmull_high_u32(dividend, by.multiplier);
    return vmovn_u32(vuzp2q_u32(vreinterpretq_u32_u64(a), vreinterpretq_u32_u64(b)));
  }
  static SINEW_INLINE int16x8_t means(const Divider& by, Sums sums) {
    const uint16x8_t packed = vcombine_u16(divide(by, sums.low), divide(by, sums.high));
    return vreinterpretq_s16_u16(veorq_u16(packed, vdupq_n_u16(0x8000)));
  }

  static SINEW_INLINE uint32_t find_of_8(const uint16_t* joints, uint16_t joint) {
    const uint8x8_t equal = vmovn_u16(vceqq_u16(vld1q_u16(joints), vdupq_n_u16(joint)));
    const uint64_t mask = vget_lane_u64(vreinterpret_u64_u8(equal), 0);
    return mask == 0 ? 8 : static_cast<uint32_t>(__builtin_ctzll(mask)) / 8;
  }
};

}  // namespace

bool add_aggregates_s16_neon(Kernels* kernels) {
  add_aggregates<AggregateNeon>(kernels);
  return true;
}

}  // namespace sinew
#else
namespace sinew {
bool add_aggregates_s16_neon(Kernels*) { return false; }
}  // namespace sinew
#endif
