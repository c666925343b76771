// SPDX-License-Identifier: MIT
// Arithmetic of the channels: ratios, logs and roots in Q13, and the numbers that channels have in a row.
#ifndef SINEW_FEATURES_CHANNEL_VALUES_HPP
#define SINEW_FEATURES_CHANNEL_VALUES_HPP

#include "core/fixed.hpp"
#include "features/channels.hpp"
#include "features/features.hpp"

namespace sinew::features {

constexpr int32_t kOne = 1 << kFeatureBits;
constexpr uint32_t kLogFloor = 4;  // Q15: logs of heat weights start at 2^-13
constexpr int64_t kLogFloorLog = -13 * (1 << 16);
constexpr int32_t kSoftLength =
    kSide / 256;  // added to lengths before a logarithm, so that noise at contact does not count

enum VertexFeature : uint32_t {
#define SINEW_CHANNEL(name) kV_##name,
  SINEW_VERTEX_CHANNELS(SINEW_CHANNEL)
#undef SINEW_CHANNEL
      kVertexFeatureCount
};
enum PairFeature : uint32_t {
#define SINEW_CHANNEL(name) kP_##name,
  SINEW_PAIR_CHANNELS(SINEW_CHANNEL)
#undef SINEW_CHANNEL
      kPairFeatureCount
};

// From here on a pair's channels depend on the joint and the part alone.
constexpr uint32_t kFirstPartChannel = kP_host_share;
constexpr uint32_t kPartChannels = kPairFeatureCount - kFirstPartChannel;

SINEW_ONCE inline int16_t q13(int64_t value) { return clamp16(value, -2 * kOne, 2 * kOne - 1); }
// value / whole in Q13, rounded half up; whole > 0.
inline int16_t ratio_q13(int64_t value, int64_t whole) {
  const int64_t twice = 2 * value * kOne + whole;
  const int64_t q = twice / (2 * whole);
  return q13(q * 2 * whole > twice ? q - 1 : q);
}
// The same of the mesh's longest side.
inline int16_t side_ratio_q13(int64_t value) { return q13(round_shift(value * kOne, kGridBits)); }
// log2(value) / 2^shift in Q13, for value >= 1; `minus` is subtracted first, both Q16.
inline int16_t log_q13(uint64_t value, int32_t minus_q16, int shift) {
  return q13(round_shift(static_cast<int64_t>(log2_q16(value)) - minus_q16, 3 + shift));
}
// Natural log of a Q15 weight divided by kLogFeatureDivisor = 8, in Q13. 45426 = ln 2 in Q16.
inline int16_t weight_log_q13(uint32_t weight) {
  const int64_t l = weight <= kLogFloor ? kLogFloorLog : static_cast<int64_t>(log2_q16(weight)) - (15 << 16);
  return q13(round_shift(l * 45426, 16 + 3 + 3));
}
// sqrt of a Q15 weight in Q13.
inline int16_t weight_root_q13(uint32_t weight) { return q13(isqrt64(static_cast<uint64_t>(weight) << 11)); }
inline int16_t weight_q13(uint32_t weight) { return q13((weight + 2) >> 2); }

// Channels of a Q15 weight; `relative` to the largest of its row unless that is 0. Most candidates have none.
struct WeightChannels {
  int16_t weight, root, log, relative;
};
inline WeightChannels weight_channels(uint32_t weight, uint32_t largest) {
  if (weight == 0) return {0, 0, weight_log_q13(0), 0};
  return {weight_q13(weight), weight_root_q13(weight), weight_log_q13(weight),
          largest == 0 ? int16_t{0} : ratio_q13(weight, largest)};
}
// A sum of Q15 weights over `size` vertices as their mean, Q13.
inline int16_t share_q13(int64_t sum, uint32_t size) { return q13(sum / (static_cast<int64_t>(size) * 4)); }

struct HeatRow {  // a finished heat row
  uint16_t joints[kHeatSlots];
  uint16_t weights[kHeatSlots];
  uint32_t count = 0;

  void load(const HeatField& field, uint32_t vertex) { count = finish_heat_row(field, vertex, joints, weights); }
  uint32_t top() const {  // slot of the largest weight, ties to the lower joint
    uint32_t best = 0;
    for (uint32_t i = 1; i < count; ++i) {
      if (weights[i] > weights[best] || (weights[i] == weights[best] && joints[i] < joints[best])) best = i;
    }
    return best;
  }
};

}  // namespace sinew::features
#endif
