// SPDX-License-Identifier: MIT
// The definition of a segment against sixteen boxes in plain C++.
#include "core/fixed.hpp"
#include "kernels/boxes.hpp"

namespace sinew {
namespace {

// Bit i: the box around the segment meets box i. Without comparisons, so that compilers make vector code of it: a
// difference is negative where the two are apart.
uint32_t near_boxes(const BoxGroup& group, const BoxSegment& segment) {
  constexpr int32_t kBits[kBoxesInGroup] = {1,   2,   4,    8,    16,   32,   64,    128,
                                            256, 512, 1024, 2048, 4096, 8192, 16384, 32768};
  int32_t apart[kBoxesInGroup] = {};
  for (int axis = 0; axis < 3; ++axis) {
    const int32_t low = segment.middle[axis] - segment.half[axis], high = segment.middle[axis] + segment.half[axis];
    for (uint32_t i = 0; i < kBoxesInGroup; ++i)
      apart[i] |= (high - 2 * group.low[axis][i]) | (2 * group.high[axis][i] - low);
  }
  int32_t met = 0;
  for (uint32_t i = 0; i < kBoxesInGroup; ++i) met |= ~(apart[i] >> 31) & kBits[i];
  return static_cast<uint32_t>(met);
}

bool meets_box(const BoxGroup& group, const BoxSegment& segment, uint32_t box) {
  int32_t m[3], e[3];  // from the box's middle to the segment's, and the box's size
  for (int axis = 0; axis < 3; ++axis) {
    m[axis] = segment.middle[axis] - (group.low[axis][box] + group.high[axis][box]);
    e[axis] = group.high[axis][box] - group.low[axis][box];
  }
  for (int axis = 0; axis < 3; ++axis) {
    const int j = axis == 2 ? 0 : axis + 1, k = axis == 0 ? 2 : axis - 1;
    const int64_t cross = static_cast<int64_t>(m[j]) * segment.along[k] - static_cast<int64_t>(m[k]) * segment.along[j];
    if (abs64(cross) > static_cast<int64_t>(e[j]) * segment.half[k] + static_cast<int64_t>(e[k]) * segment.half[j])
      return false;
  }
  return true;
}

}  // namespace

uint32_t boxes_met_ref(const BoxGroup& group, const BoxSegment& segment) {
  uint32_t met = 0;
  for (uint32_t rest = near_boxes(group, segment); rest != 0; rest &= rest - 1) {
    const uint32_t box = static_cast<uint32_t>(low_bit(rest));
    if (meets_box(group, segment, box)) met |= 1u << box;
  }
  return met;
}

}  // namespace sinew
