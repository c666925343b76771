// SPDX-License-Identifier: MIT
// A segment against sixteen boxes, once for all registers. A file that is compiled with an instruction set's flags
// includes this and says what a register is:
//   Int32, kLanes                          int32 of a register
//   load, all(int32), add, subtract, either(Int32, Int32)     either: bitwise or
//   Int64                                  kLanes int64, in any order that signs() knows
//   products(Int32, Int32), add, subtract, either(Int64, Int64)     the second factor comes from all()
//   signs(Int32, Int64)                    bit i: one of both is negative in lane i
#ifndef SINEW_KERNELS_BOXES_S32_LANES_HPP
#define SINEW_KERNELS_BOXES_S32_LANES_HPP

#include "kernels/boxes.hpp"
#include "kernels/isolated.hpp"

namespace sinew {
namespace {

// Without comparisons: |a| > b where b - a or b + a is negative.
template <class L>
uint32_t boxes_met_in(const BoxGroup& group, const BoxSegment& segment) {
  uint32_t apart = 0;
  for (uint32_t first = 0; first < kBoxesInGroup; first += L::kLanes) {
    typename L::Int32 m[3], e[3];
    SINEW_UNROLL
    for (int axis = 0; axis < 3; ++axis) {
      const typename L::Int32 low = L::load(group.low[axis] + first), high = L::load(group.high[axis] + first);
      m[axis] = L::subtract(L::all(segment.middle[axis]), L::add(low, high));
      e[axis] = L::subtract(high, low);
    }
    typename L::Int32 boxes = L::all(0);
    typename L::Int64 edges = L::products(boxes, boxes);
    SINEW_UNROLL
    for (int axis = 0; axis < 3; ++axis) {
      const typename L::Int32 reach = L::add(e[axis], L::all(segment.half[axis]));
      boxes = L::either(boxes, L::either(L::subtract(reach, m[axis]), L::add(reach, m[axis])));
      const int j = axis == 2 ? 0 : axis + 1, k = axis == 0 ? 2 : axis - 1;
      const typename L::Int64 cross =
          L::subtract(L::products(m[j], L::all(segment.along[k])), L::products(m[k], L::all(segment.along[j])));
      const typename L::Int64 limit =
          L::add(L::products(e[j], L::all(segment.half[k])), L::products(e[k], L::all(segment.half[j])));
      edges = L::either(edges, L::either(L::subtract(limit, cross), L::add(limit, cross)));
    }
    apart |= L::signs(boxes, edges) << first;
  }
  return ~apart & ((1u << kBoxesInGroup) - 1);
}

}  // namespace
}  // namespace sinew
#endif
