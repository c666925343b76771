// SPDX-License-Identifier: MIT
// Who wrote which channels of a buffer: the walk over a layer list that the reader's checks, the executor's plan and
// the quantizer's scales all use. Searches the list instead of keeping a table per channel; lists have at most 128
// layers.
#ifndef SINEW_MODEL_REGIONS_HPP
#define SINEW_MODEL_REGIONS_HPP

#include "model/layout.hpp"

namespace sinew {

constexpr int kFromInput = -1;  // one of the first buffers
constexpr int kNotWritten = -2;

// Channels [channel, channel + count) of a buffer with one writer.
struct Segment {
  int producer = kNotWritten;  // layer index, kFromInput or kNotWritten
  uint32_t channel = 0;
  uint32_t count = 0;
};

constexpr uint32_t region_end(const Region& region) { return static_cast<uint32_t>(region.offset) + region.channels; }
constexpr bool regions_overlap(const Region& a, const Region& b) {
  return a.buffer == b.buffer && a.offset < region_end(b) && b.offset < region_end(a);
}

// The piece of `region` that starts at buffer channel `channel` and has one writer among layers [0, before), or is an
// input, as buffers [0, inputs) are.
inline Segment segment_at(const Layer* layers, uint32_t inputs, uint32_t before, const Region& region,
                          uint32_t channel) {
  Segment segment;
  segment.channel = channel;
  uint32_t end = region_end(region);
  if (region.buffer < inputs) {
    segment.producer = kFromInput;
  } else {
    for (uint32_t i = 0; i < before; ++i) {
      const Region& out = layers[i].out;
      if (out.buffer == region.buffer && out.offset <= channel && channel < region_end(out)) {
        segment.producer = static_cast<int>(i);
        if (region_end(out) < end) end = region_end(out);
        break;
      }
    }
  }
  segment.count = end - channel;
  return segment;
}

// Widest range of a region's writers; ranges holds one entry per layer before `before`. Inputs are signed.
inline ValueRange region_range(const Layer* layers, uint32_t inputs, uint32_t before, const ValueRange* ranges,
                               const Region& region) {
  ValueRange widest = ValueRange::kPositive;
  for (uint32_t channel = region.offset; channel < region_end(region);) {
    const Segment segment = segment_at(layers, inputs, before, region, channel);
    const ValueRange range = segment.producer >= 0 ? ranges[segment.producer] : ValueRange::kSigned;
    if (range > widest) widest = range;
    channel += segment.count;
  }
  return widest;
}

// Interval of a sum of products; the accumulator proof. Every range contains 0, so each partial sum, in whatever order,
// lies in the interval of the whole: a proven sum never overflows its type in between either.
struct SumBound {
  int64_t low = 0, high = 0;
  void add(int32_t weight, ValueRange range) {
    const int64_t a = static_cast<int64_t>(weight) * range_low(range);
    const int64_t b = static_cast<int64_t>(weight) * range_high(range);
    low += a < b ? a : b;
    high += a < b ? b : a;
  }
  void add(const SumBound& other) {
    low += other.low;
    high += other.high;
  }
  int64_t largest() const { return -low > high ? -low : high; }
  bool below(int64_t limit) const { return low > -limit && high < limit; }
};
constexpr int64_t kNarrowLimit = static_cast<int64_t>(1) << 31;
constexpr int64_t kWideLimit = static_cast<int64_t>(1) << 62;

}  // namespace sinew
#endif
