// SPDX-License-Identifier: MIT
// The inner loop of the heat stage's visibility: a segment against sixteen boxes (heat/visibility.hpp has the tree).
#ifndef SINEW_KERNELS_BOXES_HPP
#define SINEW_KERNELS_BOXES_HPP

#include <stdint.h>

namespace sinew {

constexpr uint32_t kBoxesInGroup = 16;

// Boxes that are tested together, grid units by axis. One that is not there has low = 2^28 and high = -2^28.
struct BoxGroup {
  int32_t low[3][kBoxesInGroup], high[3][kBoxesInGroup];
};

// A segment, everything doubled to stay in integers: middle = start + target, along = target - start, half = |along|.
// Grid units by axis; start and target within 2^23.
struct BoxSegment {
  int32_t middle[3], along[3], half[3];
};

// Bit i: the segment meets box i (separating axes: the boxes' and their cross products with the segment). Exact.
uint32_t boxes_met_ref(const BoxGroup& group, const BoxSegment& segment);

using BoxKernel = decltype(&boxes_met_ref);

// False when the file was compiled without its instruction set.
bool add_boxes_s32_avx2(BoxKernel* kernel);
bool add_boxes_s32_simd128(BoxKernel* kernel);
bool add_boxes_s32_neon(BoxKernel* kernel);
bool add_boxes_s32_avx512(BoxKernel* kernel);  // AVX-512 F and DQ

}  // namespace sinew
#endif
