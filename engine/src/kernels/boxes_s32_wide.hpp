// SPDX-License-Identifier: MIT
// A segment against sixteen boxes, once for all registers. A file that is compiled with an instruction set's flags
// includes this and defines the register types and operations:
//   Int32, kWidth                          int32 of a register
//   load, all(int32), add, subtract, either(Int32, Int32)     either: bitwise or
//   Int64                                  kWidth int64, in any order that signs() knows
//   products(Int32, Int32), add, subtract, either(Int64, Int64)     the second factor comes from all()
//   signs(Int32, Int64)                    bit i: one of both is negative at number i
#ifndef SINEW_KERNELS_BOXES_S32_WIDE_HPP
#define SINEW_KERNELS_BOXES_S32_WIDE_HPP

#include "kernels/boxes.hpp"
#include "kernels/isolated.hpp"

namespace sinew {
namespace {

// Without comparisons: |a| > b where b - a or b + a is negative.
template <class Isa>
uint32_t boxes_met_in(const BoxGroup& group, const BoxSegment& segment) {
  uint32_t apart = 0;
  for (uint32_t first = 0; first < kBoxesInGroup; first += Isa::kWidth) {
    typename Isa::Int32 m[3], e[3];
    SINEW_UNROLL
    for (int axis = 0; axis < 3; ++axis) {
      const typename Isa::Int32 low = Isa::load(group.low[axis] + first), high = Isa::load(group.high[axis] + first);
      m[axis] = Isa::subtract(Isa::all(segment.middle[axis]), Isa::add(low, high));
      e[axis] = Isa::subtract(high, low);
    }
    typename Isa::Int32 boxes = Isa::all(0);
    typename Isa::Int64 edges = Isa::products(boxes, boxes);
    SINEW_UNROLL
    for (int axis = 0; axis < 3; ++axis) {
      const typename Isa::Int32 reach = Isa::add(e[axis], Isa::all(segment.half[axis]));
      boxes = Isa::either(boxes, Isa::either(Isa::subtract(reach, m[axis]), Isa::add(reach, m[axis])));
      const int j = axis == 2 ? 0 : axis + 1, k = axis == 0 ? 2 : axis - 1;
      const typename Isa::Int64 cross = Isa::subtract(Isa::products(m[j], Isa::all(segment.along[k])),
                                                      Isa::products(m[k], Isa::all(segment.along[j])));
      const typename Isa::Int64 limit =
          Isa::add(Isa::products(e[j], Isa::all(segment.half[k])), Isa::products(e[k], Isa::all(segment.half[j])));
      edges = Isa::either(edges, Isa::either(Isa::subtract(limit, cross), Isa::add(limit, cross)));
    }
    apart |= Isa::signs(boxes, edges) << first;
  }
  return ~apart & ((1u << kBoxesInGroup) - 1);
}

}  // namespace
}  // namespace sinew
#endif
